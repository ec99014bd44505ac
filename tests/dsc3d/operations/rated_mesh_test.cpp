// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/rated_mesh.h"

#include "dsc3d/operations/edge_collapse.h"
#include "dsc3d/operations/edge_removal.h"
#include "dsc3d/operations/multi_face.h"
#include "dsc3d/operations/relocation.h"
#include "dsc3d/operations/smoothing.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;
using dsc::geometry::QualityMeasure;

namespace {

// All that a transaction promises to restore, by the handles of vertices.
struct State {
    LabelledTets tets;
    std::map<VertexId, Point3> positions;
    std::map<VertexId, std::pair<VertexMotion, std::int32_t>> freedoms;
    std::map<std::set<VertexId>, std::int32_t> patches;
    std::map<TetVertices, double> qualities;

    explicit State(const RatedMesh& mesh) {
        const Complex& complex = mesh.complex();
        tets = labelled_tets(complex);
        for (const VertexId v : vertices(complex)) {
            positions[v] = mesh.position(v);
            freedoms[v] = {mesh.surface().motion(v), mesh.surface().freedom(v).carrier};
        }
        for (const FaceId f : faces(complex)) {
            const FaceVertices v = complex.vertices(f);
            if (complex.is_surface(f)) patches[std::set(v.begin(), v.end())] = mesh.surface().patch(f);
        }
        for (const TetId t : dsc::tests::tets(complex)) {
            REQUIRE(mesh.quality(t) == mesh.rate(complex.vertices(t)));
            qualities[oriented(complex.vertices(t))] = mesh.quality(t);
        }
    }
};

void require_equal(const State& a, const State& b) {
    REQUIRE(a.tets == b.tets);
    REQUIRE(a.positions == b.positions);
    REQUIRE(a.freedoms == b.freedoms);
    REQUIRE(a.patches == b.patches);
    // The same tetrahedra, maybe rated from another vertex.
    for (const auto& [tet, quality] : a.qualities) REQUIRE(b.qualities.at(tet) == Approx(quality).epsilon(1e-9));
}

class RandomChanges {
public:
    RandomChanges(RatedMesh& mesh, Random& random) : mesh_(mesh), random_(random) {}

    bool run_one() {
        const Complex& complex = mesh_.complex();
        switch (random_.below(6)) {
            case 0: return edge_removal_.propose(mesh_, pick(edges(complex)), proposal_, 0.0) && mesh_.apply(proposal_);
            case 1:
                multi_face_.gather(mesh_, pick(faces(complex)));
                return multi_face_.propose_removal(mesh_, proposal_, 0.0) && mesh_.apply(proposal_);
            case 2:
                multi_face_.gather(mesh_, pick(faces(complex)));
                return multi_face_.propose_retriangulation(mesh_, proposal_, 0.0) && mesh_.apply(proposal_);
            case 3: {
                const EdgeId e = pick(edges(complex));
                return collapse_.propose(mesh_, e, complex.vertices(e)[random_.below(2)], 0.0, proposal_) &&
                       mesh_.apply(proposal_);
            }
            case 4:
                return relocation_.propose(mesh_, pick(vertices(complex)), pick(edges(complex)), proposal_) &&
                       mesh_.apply(proposal_);
            default: {
                const VertexId v = pick(vertices(complex));
                const Eigen::Vector3d wish(random_.uniform(-0.3, 0.3), random_.uniform(-0.3, 0.3),
                                           random_.uniform(-0.3, 0.3));
                const Point3 place = mesh_.surface().settled(v, mesh_.position(v) + mesh_.surface().allowed(v, wish));
                return mesh_.move(v, place, mesh_.walker().star(v));
            }
        }
    }

private:
    template <class Handle>
    Handle pick(const std::vector<Handle>& handles) {
        return handles[random_.below(handles.size())];
    }

    RatedMesh& mesh_;
    Random& random_;
    EdgeRemoval edge_removal_;
    MultiFace multi_face_;
    EdgeCollapse collapse_;
    Relocation relocation_;
    Proposal proposal_;
};

TetData rated_sample(int trial, Random& random) {
    TetData data = box({2, 2, 2});
    if (trial % 3 == 1) label_slabs(data, {2, 2, 2}, 2);
    shake_inside(data, 0.3, random);
    if (trial % 2 == 1) turn(data);
    return data;
}

}  // namespace

TEST_CASE("what is taken back was never done") {
    Random random(seed(1));
    for (int trial = 0; trial < 12; ++trial) {
        Mesh mesh(rated_sample(trial, random));
        RatedMesh rated(mesh, QualityMeasure::minimum_biased_sine, {});
        RandomChanges changes(rated, random);
        for (int round = 0; round < 40; ++round) {
            const State before(rated);
            rated.begin();
            REQUIRE(rated.transaction().is_open());
            for (int change = 0; change < 1 + round % 12; ++change) {
                changes.run_one();
                require_valid(mesh);
            }
            if (round % 4 == 3) {
                rated.commit();
                require_valid(mesh);
                static_cast<void>(State(rated));  // all qualities are those of the tetrahedra
                continue;
            }
            rated.roll_back();
            REQUIRE_FALSE(rated.transaction().is_open());
            require_valid(mesh);
            require_equal(before, State(rated));
        }
    }
}

TEST_CASE("a transaction knows which tetrahedra it has touched, and what they were like") {
    Random random(seed(2));
    for (int trial = 0; trial < 30; ++trial) {
        Mesh mesh(rated_sample(trial, random));
        RatedMesh rated(mesh, QualityMeasure::volume_length, {});
        RandomChanges changes(rated, random);
        std::map<TetVertices, std::vector<Point3>> shapes;
        const auto shape = [&](TetId t) {
            std::vector<Point3> corners;
            for (const VertexId v : oriented(mesh.complex().vertices(t))) corners.push_back(mesh.position(v));
            return corners;
        };
        for (const TetId t : tets(mesh.complex())) shapes[oriented(mesh.complex().vertices(t))] = shape(t);
        double sum_before = 0, sum_after = 0;
        for (const TetId t : tets(mesh.complex())) sum_before += rated.quality(t);
        rated.begin();
        for (int change = 0; change < 8; ++change) changes.run_one();
        for (const TetId t : tets(mesh.complex())) sum_after += rated.quality(t);

        std::set<TetId> touched;
        double touched_after = 0, touched_before = 0;
        for (const TetId t : rated.transaction().touched()) {
            REQUIRE_FALSE(mesh.complex().is_deleted(t));
            REQUIRE(touched.insert(t).second);
            touched_after += rated.quality(t);
        }
        for (const double quality : rated.transaction().qualities_before()) touched_before += quality;
        // What has not been touched is what it was.
        for (const TetId t : tets(mesh.complex())) {
            if (touched.count(t) != 0) continue;
            const auto found = shapes.find(oriented(mesh.complex().vertices(t)));
            REQUIRE(found != shapes.end());
            REQUIRE(found->second == shape(t));
        }
        REQUIRE(sum_after - sum_before == Approx(touched_after - touched_before).margin(1e-9));
        rated.commit();
    }
}

TEST_CASE("a change that would invert a tetrahedron changes nothing") {
    Random random(seed(3));
    Mesh mesh(rated_sample(0, random));
    RatedMesh rated(mesh, QualityMeasure::minimum_sine, {});
    const State before(rated);
    const std::uint32_t time = rated.time();
    for (const EdgeId e : edges(mesh.complex())) {
        const auto [a, b] = mesh.complex().vertices(e);
        REQUIRE_FALSE(rated.move(a, mesh.position(b), rated.walker().star(a)));
    }
    for (const TetId t : tets(mesh.complex())) {
        Proposal proposal;
        proposal.removed = {t};
        NewTet mirrored = {mesh.complex().vertices(t)};
        std::swap(mirrored.vertices[0], mirrored.vertices[1]);
        proposal.added = {mirrored};
        REQUIRE_FALSE(rated.apply(proposal));
    }
    require_equal(before, State(rated));
    CHECK(rated.time() == time);
}

TEST_CASE("a change stamps the vertices of the tetrahedra that go, come or change, and no others") {
    Random random(seed(4));
    Mesh mesh(rated_sample(1, random));
    RatedMesh rated(mesh, QualityMeasure::minimum_sine, {});
    const VertexId v(13);  // the middle
    std::vector<VertexId> neighbours;
    const auto star = rated.walker().star(v, neighbours);
    const std::uint32_t before = rated.time();
    REQUIRE(rated.move(v, mesh.position(v) + Point3(1e-3, 0, 0), star));
    CHECK(rated.time() == before + 1);
    for (const VertexId u : vertices(mesh.complex())) {
        const bool is_near = u == v || std::find(neighbours.begin(), neighbours.end(), u) != neighbours.end();
        CHECK(rated.changed(u) == (is_near ? rated.time() : 1));
    }
}

TEST_CASE("another measure rates all tetrahedra anew") {
    Random random(seed(5));
    Mesh mesh(rated_sample(0, random));
    RatedMesh rated(mesh, QualityMeasure::minimum_sine, {});
    for (const QualityMeasure measure :
         {QualityMeasure::radius_ratio, QualityMeasure::volume_length, QualityMeasure::minimum_biased_sine}) {
        rated.set_measure(measure);
        CHECK(rated.measure() == measure);
        for (const TetId t : tets(mesh.complex())) {
            const TetVertices& c = mesh.complex().vertices(t);
            REQUIRE(rated.quality(t) == dsc::geometry::quality(measure, mesh.position(c[0]), mesh.position(c[1]),
                                                               mesh.position(c[2]), mesh.position(c[3])));
        }
    }
}

TEST_CASE("a split on the boundary divides its faces, and the new vertex moves as those let it") {
    for (const bool is_oblique : {false, true}) {
        TetData data = box({2, 2, 2});
        if (is_oblique) turn(data);
        const auto to_box = [&](const Point3& p) { return is_oblique ? Point3(oblique_motion().inverse() * p) : p; };
        const std::size_t count = edges(Mesh(data).complex()).size();
        for (std::uint32_t i = 0; i < count; ++i) {
            Mesh mesh(data);
            const Complex& complex = mesh.complex();
            RatedMesh rated(mesh, QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh));
            const EdgeId e(i);
            const bool is_boundary = complex.is_boundary(e);
            const auto [a, b] = complex.vertices(e);
            const Point3 middle = 0.3 * mesh.position(a) + 0.7 * mesh.position(b);
            const auto areas = surface_areas(mesh);
            std::map<std::int32_t, double> patch_areas;
            const auto areas_by_patch = [&] {
                std::map<std::int32_t, double> found;
                for (const FaceId f : faces(complex)) {
                    if (!complex.is_boundary(f)) continue;
                    const FaceVertices v = complex.vertices(f);
                    const Point3& p = mesh.position(v[0]);
                    found[rated.surface().patch(f)] +=
                        (mesh.position(v[1]) - p).cross(mesh.position(v[2]) - p).norm() / 2;
                }
                return found;
            };
            patch_areas = areas_by_patch();
            const auto volume = volumes(mesh);
            const VertexId m = rated.split(e, middle);
            REQUIRE(m.is_valid());
            require_valid(mesh);
            require_same(volume, volumes(mesh), 1e-13);
            require_same(areas, surface_areas(mesh), 1e-13);
            require_same(patch_areas, areas_by_patch(), 1e-13);
            for (const TetId t : tets(complex)) REQUIRE(rated.quality(t) == rated.rate(complex.vertices(t)));

            int free_axes = 0;
            Eigen::Vector3d wish(0.1, 0.02, -0.05);
            Eigen::Vector3d expected = wish;
            for (int axis = 0; axis < 3; ++axis) {
                const double x = to_box(middle)[axis];
                const bool is_at_side = std::abs(x) < 1e-9 || std::abs(x - 2) < 1e-9;
                free_axes += is_at_side ? 0 : 1;
                if (is_at_side) expected[axis] = 0;
            }
            CHECK((free_axes < 3) == is_boundary);
            CHECK(rated.surface().motion(m) == (free_axes == 3   ? VertexMotion::free
                                                : free_axes == 2 ? VertexMotion::plane
                                                                 : VertexMotion::line));
            const Eigen::Matrix3d linear =
                is_oblique ? Eigen::Matrix3d(oblique_motion().linear()) : Eigen::Matrix3d::Identity();
            CHECK((rated.surface().allowed(m, linear * wish) - linear * expected).norm() < 1e-14);
            CHECK((rated.surface().settled(m, middle) - middle).norm() < 1e-14);
        }
    }
}

TEST_CASE("splits and collapses of a flat boundary, one after another, leave it where it is") {
    Random random(seed(6));
    TetData data = box({2, 2, 2});
    turn(data);
    Mesh mesh(data);
    RatedMesh rated(mesh, QualityMeasure::minimum_sine, FlatSurface::flat_boundary(mesh));
    const auto areas = surface_areas(mesh);
    const auto volume = volumes(mesh);
    EdgeCollapse collapse;
    Proposal proposal;
    int splits = 0, collapses = 0;
    for (int change = 0; change < 400; ++change) {
        const std::vector<EdgeId> all = edges(mesh.complex());
        const EdgeId e = all[random.below(all.size())];
        const auto [a, b] = mesh.complex().vertices(e);
        if (change % 3 == 0) {
            splits += rated.split(e, 0.5 * (mesh.position(a) + mesh.position(b))).is_valid() ? 1 : 0;
        } else {
            collapses +=
                collapse.propose(rated, e, random.below(2) == 0 ? a : b, 0.02, proposal) && rated.apply(proposal);
        }
        if (change % 10 == 0) require_valid(mesh);
    }
    require_valid(mesh);
    CHECK(splits > 50);
    CHECK(collapses > 20);
    require_same(areas, surface_areas(mesh), 1e-12);
    require_same(volume, volumes(mesh), 1e-12);
}
