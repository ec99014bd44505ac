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
#include "apps/flow/planar/checkpoint.h"
#include "apps/flow/planar/flow.h"
#include "apps/flow/planar/initial_complex.h"
#include "apps/flow/resume.h"
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

FlowResult first_result(const flow::Options& options, const Eigen::AlignedBox2d& domain, double edge_length) {
    const Options& planar = *options.planar;
    flow::MotionOptions end_of_motion;
    end_of_motion.period = planar.motion.period;
    if (planar.motion.motion == Motion::vortex) end_of_motion.motion = flow::Motion::vortex;
    if (planar.motion.motion == Motion::rotate) end_of_motion.angle = planar.motion.angle;
    FlowResult result;
    result.domain = domain;
    result.is_torus = planar.shape.is_torus;
    result.edge_length = edge_length;
    result.time = time_steps(options.time, end_of_motion);
    return result;
}

Targets motion_of(const flow::Options& options, const FlowResult& result) {
    return motion_targets(options.planar->motion, result.domain, result.edge_length, result.time.until);
}

// From where `result`, `snapshots` and `checkpoints` are to the end.
int finish(const flow::Options& options, const EdgeLimits& edges, const Targets& targets, Complex& complex,
           FlowResult& result, Snapshots& snapshots, Checkpoints& checkpoints, apps::ProgressObserver& observer) {
    remove_unfinished_files(options.folder);
    run_flow(complex, deformation(edges, options.topology), targets, snapshots, observer, result, &checkpoints);
    write_results(options, complex, result, snapshots);
    observer.clear();
    if (!options.common.quiet) fmt::print("{}", report_text(result));
    require_end(result.end, result.reason, options.folder, checkpoints.state().has_value());
    return apps::exit_done;
}

}  // namespace

int start(const flow::Options& options) {
    const ShapeOptions& shape = options.planar->shape;
    if (shape.shape == Shape::file) require_other_files(shape.path, options.folder);
    apps::ProgressObserver observer(options.common.progress);
    InitialComplex initial = initial_complex(shape, observer);
    FlowResult result = first_result(options, initial.domain, initial.edge_length);
    const Targets targets = motion_of(options, result);
    remove_checkpoint(options.folder);
    Checkpoints checkpoints(apps::checkpoint_path(options.folder), checkpoint_kind, options.given,
                            options.checkpoint_interval);
    Snapshots snapshots(options.folder, result.time.count, options.snapshots);
    return finish(options, edge_limits(initial), targets, initial.complex, result, snapshots, checkpoints, observer);
}

int resume(const flow::Options& options, apps::CheckpointFile& file) {
    SavedRun saved = file.run<SavedRun>();
    apps::ProgressObserver observer(options.common.progress);
    const EdgeLimits edges = saved.state.edges;
    FlowResult result = first_result(options, saved.state.domain, edges.edge_length);
    const Targets targets = motion_of(options, result);
    Complex complex(domain_of(result.domain, result.is_torus), saved.state.complex);
    Checkpoints checkpoints(apps::checkpoint_path(options.folder), checkpoint_kind, options.given,
                            options.checkpoint_interval);
    Snapshots snapshots(options.folder, result.time.count, options.snapshots);
    take_over(std::move(saved), result, snapshots, checkpoints);
    return finish(options, edges, targets, complex, result, snapshots, checkpoints, observer);
}

}  // namespace dsc::flow::planar
