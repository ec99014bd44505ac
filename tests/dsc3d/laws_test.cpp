// SPDX-License-Identifier: GPL-3.0-or-later
// Laws that hold through any sequence of operations: the mesh is valid, its domain and regions keep their volumes and
// their surfaces their areas, whatever is split, flipped, removed, retriangulated, collapsed, moved, labelled,
// compacted.
#include <optional>

#include "dsc3d/operations/edge_removal.h"
#include "dsc3d/operations/multi_face.h"
#include "dsc3d/operations/smoothing.h"
#include "tests/dsc3d/random_topology.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/support.h"
#include "tests/support/seed.h"

using namespace dsc::dsc3d;
using namespace dsc::tests;
using dsc::core::Random;
using dsc::geometry::QualityMeasure;

namespace {

enum class Operation {
    splits,
    flips_2_3,
    flips_3_2,
    flips_4_4,
    flips_2_2,
    plain_collapses,
    moves,
    labels,
    compactions,
    edge_removals,
    multi_face_removals,
    retriangulations,
    rated_collapses,
    smoothings,
    count,
    first_rated = edge_removals
};

// Operations in bursts: some that know nothing of qualities, then some on a rated mesh, whose attributes follow.
class RandomOperations {
public:
    RandomOperations(Mesh& mesh, int labels, std::uint32_t size, Random& random)
        : mesh_(mesh), complex_(mesh.complex()), labels_(labels), size_(size), random_(random), walker_(complex_) {}

    /// True when something was changed; `keeps_volumes` says whether regions have kept theirs.
    bool run_one(bool& keeps_volumes) {
        keeps_volumes = true;
        if (++step_ % 40 == 0) {
            rated_.reset();
        } else if (step_ % 40 == 20) {
            const auto measure = static_cast<QualityMeasure>(random_.below(4));
            rated_.emplace(mesh_, measure, FlatSurfaceParameters{});
        }
        constexpr auto plain = static_cast<std::uint64_t>(Operation::first_rated);
        constexpr auto all = static_cast<std::uint64_t>(Operation::count);
        const auto operation =
            static_cast<Operation>(rated_ ? plain + random_.below(all - plain) : random_.below(plain));
        if (!run(operation)) return false;
        last_ = operation;
        ++done_[static_cast<std::size_t>(operation)];
        keeps_volumes = operation != Operation::labels && !moved_interface_;
        return true;
    }
    Operation last() const { return last_; }
    int done(Operation operation) const { return done_[static_cast<std::size_t>(operation)]; }

private:
    bool run(Operation operation) {
        moved_interface_ = false;
        switch (operation) {
            case Operation::splits: return split_something();
            case Operation::flips_2_3: {
                const FaceId f = pick<FaceId>(complex_.face_capacity());
                return is_small() && can_flip_2_3(complex_, f, walker_) && flip(flip_2_3(complex_, f));
            }
            case Operation::flips_3_2: {
                const EdgeId e = pick_edge();
                return can_flip_3_2(complex_, e, walker_) && flip(flip_3_2(complex_, e));
            }
            case Operation::flips_4_4: {
                const EdgeId e = pick_edge();
                const auto diagonal = static_cast<Diagonal>(random_.below(2));
                if (!can_flip_4_4(complex_, e, diagonal, walker_)) return false;
                const Flip chosen = flip_4_4(complex_, e, diagonal);
                return keeps_surface(e, chosen) && flip(chosen);
            }
            case Operation::flips_2_2: {
                const EdgeId e = pick_edge();
                if (!can_flip_2_2(complex_, e, walker_)) return false;
                const Flip chosen = flip_2_2(complex_, e);
                return keeps_surface(e, chosen) && flip(chosen);
            }
            case Operation::plain_collapses: return collapse_something();
            case Operation::moves: return move_something();
            case Operation::labels: return labels_ > 1 && random_.below(10) == 0 && label_something();
            case Operation::compactions:
                if (random_.below(20) != 0) return false;
                complex_.compact();
                return true;
            default: return run_rated(operation);
        }
    }

    bool run_rated(Operation operation) {
        switch (operation) {
            case Operation::edge_removals:
                return edge_removal_.propose(*rated_, pick_edge(), proposal_, 0.0) && apply();
            case Operation::multi_face_removals:
                if (!is_small()) return false;
                multi_face_.gather(*rated_, pick<FaceId>(complex_.face_capacity()));
                return multi_face_.propose_removal(*rated_, proposal_, 0.0) && apply();
            case Operation::retriangulations:
                multi_face_.gather(*rated_, pick<FaceId>(complex_.face_capacity()));
                return multi_face_.propose_retriangulation(*rated_, proposal_, 0.0) && apply();
            case Operation::rated_collapses: {
                const EdgeId e = pick_edge();
                return is_large() &&
                       edge_collapse_.propose(*rated_, e, complex_.vertices(e)[random_.below(2)], 0.0, proposal_) &&
                       apply();
            }
            default: return smoothing_.smooth(*rated_, pick<VertexId>(complex_.vertex_capacity()));
        }
    }

    bool apply() { return rated_->apply(proposal_); }

    bool flip(const Flip& flip) {
        if (!flip.is_positive(mesh_)) return false;
        flip.apply(complex_);
        return true;
    }

    bool is_small() const { return complex_.tet_count() < size_; }
    bool is_large() const { return complex_.tet_count() > size_ / 2; }

    bool split_something() {
        if (!is_small()) return false;
        switch (random_.below(3)) {
            case 0: return split_at_random(pick_edge());
            case 1: return split_at_random(pick<FaceId>(complex_.face_capacity()));
            default: return split_at_random(pick<TetId>(complex_.tet_capacity()));
        }
    }
    template <class Simplex>
    bool split_at_random(Simplex simplex) {
        Point3 sum = Point3::Zero();
        double weights = 0;
        for (const VertexId v : complex_.vertices(simplex)) {
            const double weight = random_.uniform(0.3, 1);
            sum += weight * mesh_.position(v);
            weights += weight;
        }
        const Point3 place = sum / weights;
        if (!can_split(mesh_, simplex, place)) return false;
        split(mesh_, simplex, place);
        return true;
    }

    // What a flip of a surface edge asks of geometry: one plane, and no tetrahedron that lies in it up to rounding.
    bool keeps_surface(EdgeId e, const Flip& flip) {
        if (!complex_.is_surface(e)) return true;
        gather_ring(complex_, e, ring_);
        const Point3 &a = mesh_.position(ring_.a), &b = mesh_.position(ring_.b);
        double area = 0, height = 0;
        for (const VertexId v : ring_.link) {
            if (!is_surface_face(v)) continue;
            const Eigen::Vector3d normal = (b - a).cross(mesh_.position(v) - a);
            area = std::max(area, normal.norm());
            for (const VertexId u : ring_.link)
                if (is_surface_face(u)) height = std::max(height, std::abs(normal.dot(mesh_.position(u) - a)));
        }
        const auto tets = flip.added();
        return height < 1e-14 * area && std::all_of(tets.begin(), tets.end(), [&](const NewTet& tet) {
                   return volume(mesh_, tet.vertices) > least_surface_quality;
               });
    }
    // Whether the face of the ring's edge with v belongs to the surface.
    bool is_surface_face(VertexId v) const {
        for (const TetId t : ring_.tets) {
            if (!complex_.has_vertex(t, v)) continue;
            for (const FaceId f : complex_.faces(t)) {
                const FaceVertices corners = complex_.vertices(f);
                const auto has = [&](VertexId u) {
                    return std::find(corners.begin(), corners.end(), u) != corners.end();
                };
                if (has(ring_.a) && has(ring_.b) && has(v)) return complex_.is_surface(f);
            }
        }
        return false;
    }

    bool collapse_something() {
        const EdgeId e = pick_edge();
        const EdgeVertices ends = complex_.vertices(e);
        const std::size_t kept = random_.below(2);
        const VertexId gone = ends[1 - kept];
        if (!is_large() || complex_.is_surface(gone)) return false;
        if (!edge_collapse_.keeps_topology(complex_, e, ends[kept], walker_)) return false;
        for (const TetId t : walker_.star(gone)) {
            if (complex_.has_vertex(t, ends[kept])) continue;
            TetVertices moved = complex_.vertices(t);
            std::replace(moved.begin(), moved.end(), gone, ends[kept]);
            if (!mesh_.is_positive(moved)) return false;
        }
        collapse(complex_, e, ends[kept], walker_);
        return true;
    }

    // Mostly regions grow: without that, every face would soon be one of an interface.
    bool label_something() {
        const TetId t = pick<TetId>(complex_.tet_capacity());
        const TetId neighbour = complex_.neighbour(t, static_cast<int>(random_.below(4)));
        const bool grows = neighbour.is_valid() && random_.below(5) != 0;
        const int label =
            grows ? complex_.label(neighbour) : static_cast<int>(random_.below(static_cast<std::uint64_t>(labels_)));
        if (complex_.label(t) == label) return false;
        complex_.set_label(t, label);
        return true;
    }

    bool move_something() {
        const VertexId v = pick<VertexId>(complex_.vertex_capacity());
        if (complex_.is_boundary(v)) return false;
        const Point3 before = mesh_.position(v);
        const double x = random_.uniform(-0.2, 0.2), y = random_.uniform(-0.2, 0.2), z = random_.uniform(-0.2, 0.2);
        mesh_.set_position(v, before + Point3(x, y, z));
        for (const TetId t : walker_.star(v)) {
            if (mesh_.is_positive(complex_.vertices(t))) continue;
            mesh_.set_position(v, before);
            return false;
        }
        moved_interface_ = complex_.is_interface(v);
        return true;
    }

    template <class Handle>
    Handle pick(std::uint32_t capacity) {
        for (;;) {
            const Handle handle(static_cast<std::uint32_t>(random_.below(capacity)));
            if (!complex_.is_deleted(handle)) return handle;
        }
    }
    EdgeId pick_edge() { return pick<EdgeId>(complex_.edge_capacity()); }

    Mesh& mesh_;
    Complex& complex_;
    int labels_;
    std::uint32_t size_;
    Random& random_;
    StarWalker walker_;
    std::optional<RatedMesh> rated_;
    EdgeRemoval edge_removal_;
    MultiFace multi_face_;
    EdgeCollapse edge_collapse_;
    Smoothing smoothing_;
    Proposal proposal_;
    EdgeRing ring_;
    std::uint64_t step_ = 0;
    bool moved_interface_ = false;
    Operation last_ = Operation::splits;
    std::array<int, static_cast<std::size_t>(Operation::count)> done_ = {};
};

struct Sequence {
    Cells cells;
    int labels;
    int operations;
    std::uint32_t size;
    int checked_every;
    bool is_oblique = false;
};

void run(const Sequence& sequence, std::uint64_t with_seed) {
    Random random(with_seed);
    TetData data = box(sequence.cells);
    if (sequence.labels > 1) label_slabs(data, sequence.cells, sequence.labels);
    if (sequence.is_oblique) turn(data);
    Mesh mesh(data);
    RandomOperations operations(mesh, sequence.labels, sequence.size, random);
    auto expected_volumes = volumes(mesh);
    auto expected_areas = surface_areas(mesh);
    for (int done = 0; done < sequence.operations;) {
        bool keeps_volumes = true;
        if (!operations.run_one(keeps_volumes)) continue;
        ++done;
        if (!keeps_volumes) {
            expected_volumes = volumes(mesh);
            expected_areas = surface_areas(mesh);
        }
        if (done % sequence.checked_every != 0) continue;
        INFO("after " << done << " operations, the last of kind " << static_cast<int>(operations.last()));
        require_valid(mesh);
        require_same(expected_volumes, volumes(mesh), 1e-12);
        require_same(expected_areas, surface_areas(mesh), 1e-12);
    }
    for (int i = 0; i < static_cast<int>(Operation::count); ++i) {
        const auto operation = static_cast<Operation>(i);
        INFO("operation " << static_cast<int>(operation));
        if (operation != Operation::labels || sequence.labels > 1)
            CHECK(operations.done(operation) > sequence.operations / 5000);
    }
    double total = 0;
    for (const auto& [label, sum] : volumes(mesh)) total += sum;
    CHECK(total == Approx(1.0 * sequence.cells[0] * sequence.cells[1] * sequence.cells[2]).epsilon(1e-11));
}

}  // namespace

TEST_CASE("30000 random operations on a box, each followed by a full check", "[slow]") {
    run({{2, 1, 1}, 1, 30000, 50, 1}, seed(1));
}

TEST_CASE("25000 random operations on a box of two regions, each followed by a full check", "[slow]") {
    run({{2, 1, 1}, 2, 25000, 50, 1, true}, seed(2));
}

TEST_CASE("25000 random operations on a box of three regions, each followed by a full check", "[slow]") {
    run({{3, 1, 1}, 3, 25000, 50, 1}, seed(3));
}

TEST_CASE("random operations on a larger box, checked now and then") {
    run({{6, 5, 5}, 3, 10000, 1200, 1000, true}, seed(4));
}

TEST_CASE("random operations on a small box, each followed by a full check") {
    for (const int labels : {1, 2, 3}) run({{3, 1, 1}, labels, 1500, 50, 1}, seed(5));
}

TEST_CASE("30000 random changes of connectivity alone, each followed by a full check", "[slow]") {
    for (const int labels : {1, 3}) {
        Random random(seed(6));
        Mesh mesh(box({2, 1, 1}));
        RandomTopology topology(mesh.complex(), random, 50, labels);
        for (int step = 0; step < 15000; ++step) {
            topology.run_one();
            if (step % 100 == 0) mesh.complex().compact();
            require_valid(mesh.complex());
        }
        for (int kind = 0; kind < RandomTopology::label; ++kind)
            CHECK(topology.done(static_cast<RandomTopology::Kind>(kind)) > 50);
    }
}
