// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/step_record.h"

#include <catch2/catch.hpp>

#include "apps/flow/planar/held_contacts.h"
#include "apps/flow/planar/snapshots.h"
#include "dsc2d/generate/complex_around.h"
#include "dsc2d/generate/shapes.h"
#include "dsc2d/interface.h"
#include "dsc2d/operations/split.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::flow::planar;
using dsc2d::Complex;

namespace {

Complex two() {
    return complex_around(dsc2d::Domain::box({0, 0}, {1, 1}), dsc2d::two_discs({0.5, 0.5}, 0.15, 0.1, 0.02), 0.02);
}

}  // namespace

TEST_CASE("a record has the figures of the mesh, inverted triangles among them") {
    Complex complex = two();
    const UnchangedEdges unchanged(complex);
    const StepRecord record = step_record(complex, 3, 0.5, unchanged);
    CHECK(record.step == 3);
    CHECK(record.time == 0.5);
    CHECK(record.triangles == complex.face_count());
    CHECK(record.interface_edges == dsc2d::Interface(complex).segments.size());
    CHECK(record.unchanged_share == 1);
    CHECK(record.labels[1].components == 2);
    CHECK(record.inverted == 0);
    CHECK(record.min_angle > 20);
    CHECK(record.max_angle < 140);
    const core::VertexId v = dsc2d::Interface(complex).vertices.front();
    complex.set_position_unchecked(v, complex.position(v) + Point2(0.5, 0));
    CHECK(step_record(complex, 4, 1, unchanged).inverted > 0);
}

TEST_CASE("an edge that was split is no longer unchanged; compaction changes nothing") {
    Complex complex = two();
    const UnchangedEdges unchanged(complex);
    const auto count = static_cast<double>(dsc2d::Interface(complex).segments.size());
    for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i) {
        const core::HalfedgeId h = Complex::halfedge(core::EdgeId(i));
        if (!complex.is_interface(h)) continue;
        split_edge(complex, h, *can_split_edge(complex, h, 0.5));
        break;
    }
    CHECK(unchanged.share(complex) == Approx(1 - 1 / count));
    complex.compact();
    CHECK(unchanged.share(complex) == Approx(1 - 1 / count));
}

TEST_CASE("a component that is gone is told once, with its label") {
    Complex complex = two();
    ComponentTracker tracker(complex);
    CHECK(tracker.update(complex).empty());
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        const core::FaceId f(i);
        if (complex.label(f) == 1 && complex.corners(f)[0].x() < 0.5) complex.set_label(f, 0);
    }
    const auto vanished = tracker.update(complex);
    REQUIRE(vanished.size() == 1);
    CHECK(vanished[0].label == 1);
    CHECK((vanished[0].centroid - Point2(0.3, 0.5)).norm() < 0.16);
    CHECK(tracker.update(complex).empty());
}

TEST_CASE("what is held is let go when its targets take it apart") {
    Complex complex = two();
    const dsc2d::Interface interface(complex);
    const core::VertexId a = interface.vertices.front(), b = interface.vertices[20];
    const Point2 way = complex.position(b) - complex.position(a);
    complex.lock(a);
    complex.lock(b);
    HeldContacts contacts;
    contacts.add(complex, std::vector{dsc2d::Contact{a, b, Point2(0, 0), dsc2d::LatticeVector::Zero(), 0.1, 0}});
    std::vector<std::optional<Point2>> targets(complex.vertex_capacity());
    targets[a.index()] = complex.position(a) + 0.1 * way;
    contacts.release(complex, targets);
    CHECK(complex.is_locked(a));
    CHECK(complex.is_locked(b));
    HeldContacts all = contacts;
    all.release_all(complex);
    CHECK(all.is_empty());
    CHECK_FALSE(complex.is_locked(a));
    targets[b.index()] = complex.position(b) + 0.1 * way;  // both go the same way
    contacts.release(complex, targets);
    CHECK_FALSE(complex.is_locked(a));
    CHECK_FALSE(complex.is_locked(b));
    CHECK(contacts.is_empty());
}

TEST_CASE("snapshots go to a series of files and to lines for each pair of labels") {
    const Complex complex =
        complex_around(dsc2d::Domain::box({0, 0}, {1, 1}), dsc2d::labelled_block({0.5, 0.5}, {0.4, 0.4}, 0.05), 0.05);
    const tests::TemporaryFolder folder;
    Snapshots snapshots(folder.path(), 4, 3);
    for (int step = 0; step < 4; ++step) snapshots.add(complex, step, 0.25 * step);
    snapshots.add_last(complex, 3, 0.75);
    CHECK(folder.content() ==
          std::vector<std::string>{"series.pvd", "series_0000.vtp", "series_0001.vtp", "series_0002.vtp"});
    const auto series = snapshots.series();
    REQUIRE(series.size() == 6);
    CHECK(series[0].name == "between 0 and 1");
    for (const io::ViewSeries& lines : series) {
        CHECK(lines.times == std::vector<double>{0, 0.5, 0.75});
        REQUIRE(lines.frames.size() == 3);
        CHECK_FALSE(lines.frames[2].empty());
    }
    const io::PolyData data = DrawnCurves::poly_data(DrawnCurves::interface(complex));
    std::size_t segments = 0;
    for (const auto& line : data.lines) segments += line.size() - 1;
    CHECK(segments == dsc2d::Interface(complex).segments.size());
}
