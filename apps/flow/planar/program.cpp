// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/program.h"

#include <fmt/core.h>

#include <array>
#include <filesystem>
#include <map>
#include <utility>

#include "apps/common/progress.h"
#include "apps/common/run_main.h"
#include "apps/flow/output.h"
#include "apps/flow/planar/flow.h"
#include "apps/flow/planar/initial_complex.h"
#include "core/errors.h"
#include "dsc2d/interface.h"
#include "geometry/surface_data.h"
#include "io/atomic_file.h"
#include "io/number.h"
#include "io/planar_mesh.h"

namespace dsc::flow::planar {

using dsc2d::Complex;

namespace {

// A vertex of a torus is written once for each period in which something needs it.
class PlaceNumbers {
public:
    explicit PlaceNumbers(const Complex& complex) : complex_(complex) {}

    std::uint32_t number(core::VertexId v, const dsc2d::LatticeVector& cell) {
        const auto [at, is_new] =
            numbers_.try_emplace({v.index(), cell.x(), cell.y()}, static_cast<std::uint32_t>(places_.size()));
        if (is_new) places_.push_back(complex_.position(v) + complex_.domain().translation(cell));
        return at->second;
    }
    const std::vector<Point2>& places() const { return places_; }

private:
    const Complex& complex_;
    std::map<std::tuple<std::uint32_t, int, int>, std::uint32_t> numbers_;
    std::vector<Point2> places_;
};

std::string curve_obj(const Complex& complex) {
    PlaceNumbers numbers(complex);
    std::string lines;
    for (const dsc2d::InterfaceCurve& curve : dsc2d::interface_curves(complex)) {
        lines += "l";
        for (const dsc2d::CurvePoint& point : curve.points)
            lines += " " + std::to_string(numbers.number(point.vertex, point.cell) + 1);
        lines += "\n";
    }
    std::string text;
    for (const Point2& p : numbers.places())
        text += "v " + io::number_text(p.x()) + " " + io::number_text(p.y()) + " 0\n";
    return text + lines;
}

geometry::SurfaceData triangle_data(const Complex& complex) {
    PlaceNumbers numbers(complex);
    geometry::SurfaceData data;
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        const core::FaceId f(i);
        if (complex.is_deleted(f)) continue;
        core::HalfedgeId h = complex.halfedge(f);
        dsc2d::LatticeVector cell = dsc2d::LatticeVector::Zero();
        std::array<std::uint32_t, 3> triangle{};
        for (std::uint32_t& v : triangle) {
            v = numbers.number(complex.from(h), cell);
            cell += complex.offset(h);
            h = complex.next(h);
        }
        data.triangles.push_back(triangle);
        data.labels.push_back(complex.label(f));
    }
    for (const Point2& p : numbers.places()) data.vertices.emplace_back(p.x(), p.y(), 0);
    return data;
}

void write_results(const flow::Options& options, const Complex& complex, const FlowResult& result,
                   const Snapshots& snapshots) {
    const std::filesystem::path folder = options.folder;
    io::write_file(folder / "final.obj", curve_obj(complex));
    io::write_planar_mesh(folder / "final.mesh", triangle_data(complex));
    write_reports(options, report_json(result, options.given),
                  [&](const std::string& title) { return html_page(result, complex, snapshots, title); });
}

}  // namespace

int run(const flow::Options& options) {
    const Options& planar = *options.planar;
    if (planar.shape.shape == Shape::file) require_other_files(planar.shape.path, options.folder);
    apps::ProgressObserver observer(options.common.progress);
    InitialComplex initial = initial_complex(planar.shape, observer);
    flow::MotionOptions end_of_motion;
    end_of_motion.period = planar.motion.period;
    if (planar.motion.motion == Motion::vortex) end_of_motion.motion = flow::Motion::vortex;
    if (planar.motion.motion == Motion::rotate) end_of_motion.angle = planar.motion.angle;
    FlowResult result;
    result.domain = initial.domain;
    result.is_torus = planar.shape.is_torus;
    result.edge_length = initial.edge_length;
    result.time = time_steps(options.time, end_of_motion);
    const Targets targets = motion_targets(planar.motion, initial.domain, initial.edge_length, result.time.until);
    remove_checkpoint(options.folder);
    Snapshots snapshots(options.folder, result.time.count, options.snapshots);
    run_flow(initial.complex, deformation(initial, options.topology), targets, snapshots, observer, result);
    write_results(options, initial.complex, result, snapshots);
    observer.clear();
    if (!options.common.quiet) fmt::print("{}", report_text(result));
    require_end(result.end, result.reason, options.folder);
    return apps::exit_done;
}

}  // namespace dsc::flow::planar
