// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of the 3D complex, of each operation, and of mesh improvement against size, on Delaunay tetrahedralizations of
// random points. One thread.
//
//     dsc3d_bench --benchmark_format=json
//     dsc3d_bench --benchmark_filter='improve_thesis/100000$'
//     dsc3d_bench --benchmark_filter=improve_thesis_2m           # minutes, and some gigabytes to make the mesh
#include <benchmark/benchmark.h>
#include <malloc.h>
#include <sys/resource.h>

#include <array>
#include <ctime>
#include <fstream>
#include <vector>

#include "bench/random_delaunay.h"
#include "core/observer.h"
#include "dsc3d/improve/improve.h"
#include "dsc3d/operations/edge_collapse.h"
#include "dsc3d/operations/edge_removal.h"
#include "dsc3d/operations/flips.h"
#include "dsc3d/operations/multi_face.h"
#include "dsc3d/operations/smoothing.h"
#include "dsc3d/operations/split.h"

namespace {

using namespace dsc;
using namespace dsc::dsc3d;

constexpr auto measure = geometry::QualityMeasure::minimum_biased_sine;

geometry::TetData make_data(std::size_t tets) { return bench::random_delaunay(tets, 1); }

// Operations are judged on a mesh that is out of the fastest cache, and the same for all.
const geometry::TetData& shared_data() {
    static const geometry::TetData data = make_data(100'000);
    return data;
}

template <class Handle>
std::vector<Handle> all_handles(std::uint32_t capacity) {
    std::vector<Handle> handles;
    for (std::uint32_t i = 0; i < capacity; ++i) handles.emplace_back(i);
    return handles;
}

// Runs `use(handle)` for one handle after the other, in their order; reports items per second.
template <class Handle, class Use>
void for_each_in_turn(benchmark::State& state, std::uint32_t capacity, Use&& use) {
    std::uint32_t i = 0;
    for (auto _ : state) {
        use(Handle(i));
        if (++i == capacity) i = 0;
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
}

// How much the resident memory has grown at its peak since construction. (Linux)
class PeakMemory {
public:
    PeakMemory() {
        malloc_trim(0);
        std::ofstream("/proc/self/clear_refs") << "5";  // the peak is what there is now
        at_first_ = peak();
    }
    double growth() const { return peak() - at_first_; }

private:
    static double peak() {
        rusage usage;
        getrusage(RUSAGE_SELF, &usage);
        return 1024.0 * static_cast<double>(usage.ru_maxrss);
    }
    double at_first_;
};

void build(benchmark::State& state) {
    const geometry::TetData data = make_data(static_cast<std::size_t>(state.range(0)));
    double bytes = 0;
    for (auto _ : state) {
        const Mesh mesh(data);
        bytes = static_cast<double>(mesh.complex().memory());
    }
    const auto tets = static_cast<double>(data.tets.size());
    state.counters["tets"] = tets;
    state.counters["complex_bytes_per_tet"] = bytes / tets;
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * data.tets.size()));
}
BENCHMARK(build)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void gather_rings(benchmark::State& state) {
    const Mesh mesh(shared_data());
    EdgeRing ring;
    for_each_in_turn<EdgeId>(state, mesh.complex().edge_capacity(), [&](EdgeId e) {
        gather_ring(mesh.complex(), e, ring);
        benchmark::DoNotOptimize(ring.tets.data());
    });
}
BENCHMARK(gather_rings);

void gather_stars(benchmark::State& state) {
    const Mesh mesh(shared_data());
    StarWalker walker(mesh.complex());
    for_each_in_turn<VertexId>(state, mesh.complex().vertex_capacity(),
                               [&](VertexId v) { benchmark::DoNotOptimize(walker.star(v).data()); });
}
BENCHMARK(gather_stars);

// Two replaces per item: 2-3 and back.
void flip_2_3_and_3_2(benchmark::State& state) {
    Mesh mesh(shared_data());
    Complex& complex = mesh.complex();
    StarWalker walker(complex);
    std::vector<FaceId> possible;
    for (const FaceId f : all_handles<FaceId>(complex.face_capacity()))
        if (can_flip_2_3(complex, f, walker)) possible.push_back(f);
    std::size_t i = 0;
    for (auto _ : state) {
        FaceId& f = possible[i];
        // A flip nearby may have taken it, or made another out of its handle.
        if (!complex.is_deleted(f) && can_flip_2_3(complex, f, walker)) {
            const EdgeId e = flip_2_3(complex, f).apply(complex).added_edges[0];
            f = flip_3_2(complex, e).apply(complex).added_faces[0];
        }
        if (++i == possible.size()) i = 0;
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
}
BENCHMARK(flip_2_3_and_3_2);

void split_and_collapse(benchmark::State& state) {
    Mesh mesh(shared_data());
    Complex& complex = mesh.complex();
    StarWalker walker(complex);
    const std::uint32_t tets = complex.tet_capacity();
    std::uint32_t i = 0;
    for (auto _ : state) {
        const TetId t(i);
        if (++i == tets) i = 0;
        const NewTet whole = {complex.vertices(t), complex.label(t)};
        const VertexId m = split(complex, t);
        const auto star = walker.star(m);
        const std::vector<TetId> parts(star.begin(), star.end());
        complex.replace(parts, std::array{whole});
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
}
BENCHMARK(split_and_collapse);

void propose_edge_removal(benchmark::State& state) {
    Mesh mesh(shared_data());
    RatedMesh rated(mesh, measure, {});
    EdgeRemoval removal;
    Proposal proposal;
    for_each_in_turn<EdgeId>(state, mesh.complex().edge_capacity(),
                             [&](EdgeId e) { benchmark::DoNotOptimize(removal.propose(rated, e, proposal)); });
}
BENCHMARK(propose_edge_removal);

void propose_multi_face_removal(benchmark::State& state) {
    Mesh mesh(shared_data());
    RatedMesh rated(mesh, measure, {});
    MultiFace multi_face;
    Proposal proposal;
    for_each_in_turn<FaceId>(state, mesh.complex().face_capacity(), [&](FaceId f) {
        multi_face.gather(rated, f);
        benchmark::DoNotOptimize(!mesh.complex().is_surface(f) && multi_face.propose_removal(rated, proposal));
    });
}
BENCHMARK(propose_multi_face_removal);

void propose_multi_face_retriangulation(benchmark::State& state) {
    Mesh mesh(shared_data());
    RatedMesh rated(mesh, measure, {});
    MultiFace multi_face;
    Proposal proposal;
    for_each_in_turn<FaceId>(state, mesh.complex().face_capacity(), [&](FaceId f) {
        multi_face.gather(rated, f);
        benchmark::DoNotOptimize(multi_face.propose_retriangulation(rated, proposal));
    });
}
BENCHMARK(propose_multi_face_retriangulation);

void propose_edge_collapse(benchmark::State& state) {
    Mesh mesh(shared_data());
    RatedMesh rated(mesh, measure, {});
    EdgeCollapse collapse;
    Proposal proposal;
    for_each_in_turn<EdgeId>(state, mesh.complex().edge_capacity(), [&](EdgeId e) {
        const VertexId kept = mesh.complex().vertices(e)[0];
        benchmark::DoNotOptimize(collapse.propose(rated, e, kept, 0.5, proposal));
    });
}
BENCHMARK(propose_edge_collapse);

void find_best_place(benchmark::State& state) {
    Mesh mesh(shared_data());
    RatedMesh rated(mesh, measure, {});
    Smoothing smoothing;
    for_each_in_turn<VertexId>(state, mesh.complex().vertex_capacity(), [&](VertexId v) {
        benchmark::DoNotOptimize(smoothing.best_place(rated, v, rated.walker().star(v)));
    });
}
BENCHMARK(find_best_place);

void make_flat_surface(benchmark::State& state) {
    const Mesh mesh(shared_data());
    for (auto _ : state) benchmark::DoNotOptimize(FlatSurface(mesh, {}));
}
BENCHMARK(make_flat_surface)->Unit(benchmark::kMillisecond);

// Argument: tetrahedra. One run, from the making of the mesh to its end: CPU time per tetrahedron of the input, and how
// much the resident memory of the process has grown at its peak, which leaves out the arrays of the input.
void improve_thesis(benchmark::State& state) {
    core::Observer silent;
    geometry::TetData data = make_data(static_cast<std::size_t>(state.range(0)));
    const auto tets = static_cast<double>(data.tets.size());
    ImproveReport report;
    double seconds = 0, bytes = 0, peak = 0, tets_after = 0;
    for (auto _ : state) {
        const PeakMemory memory;
        const std::clock_t start = std::clock();
        Mesh mesh(data);
        report = improve(mesh, {.measure = measure, .threads = 1}, silent);
        seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        bytes = static_cast<double>(mesh.complex().memory());
        tets_after = mesh.complex().tet_count();
        peak = memory.growth();
    }
    state.counters["tets"] = tets;
    state.counters["tets_after"] = tets_after;
    state.counters["rounds"] = report.rounds;
    state.counters["cpu_ms_per_tet"] = 1e3 * seconds / tets;
    state.counters["complex_bytes_per_tet"] = bytes / tets;
    state.counters["peak_bytes_per_tet"] = peak / tets;
}
BENCHMARK(improve_thesis)
    ->Arg(1'000)
    ->Arg(10'000)
    ->Arg(30'000)
    ->Arg(100'000)
    ->Arg(300'000)
    ->Arg(1'000'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

void improve_thesis_2m(benchmark::State& state) { improve_thesis(state); }
BENCHMARK(improve_thesis_2m)->Arg(2'000'000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
