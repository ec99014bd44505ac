// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/reconstruct.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/reconstruct/distances.h"
#include "apps/reconstruct/shrinking_front.h"
#include "core/disjoint_sets.h"
#include "core/errors.h"
#include "core/stopwatch.h"
#include "dsc3d/improve/improve.h"
#include "dsc3d/interface.h"
#include "geometry/surface_intersections.h"
#include "io/number.h"

namespace dsc::reconstruct {

namespace {

geometry::SurfaceData interface_of(const dsc3d::Mesh& mesh, const Cloud& cloud) {
    geometry::SurfaceData surface = dsc3d::Interface(mesh).data.surface;
    for (Point3& p : surface.vertices) p = cloud.to_input(p);
    return surface;
}

// With the vertices of the surface first, as they are numbered there.
geometry::TetData inside_of(const dsc3d::Mesh& mesh) {
    const geometry::TetData all = mesh.data();
    geometry::TetData inside{.vertices = all.vertices};
    for (std::size_t t = 0; t < all.tets.size(); ++t)
        if (all.label(t) == inside_label) inside.tets.push_back(all.tets[t]);
    return inside;
}

geometry::TetData improved_inside(const dsc3d::Mesh& mesh, const Cloud& cloud, const ReconstructParameters& parameters,
                                  core::Observer& observer) {
    dsc3d::Mesh inside(inside_of(mesh));
    dsc3d::ImproveParameters improvement;
    improvement.changes_boundary = false;
    improvement.measure = geometry::QualityMeasure::minimum_sine;
    improvement.target_angle = parameters.min_angle;
    improvement.threads = parameters.threads;
    dsc3d::improve(inside, improvement, observer);
    geometry::TetData data = inside.data();
    for (Point3& p : data.vertices) p = cloud.to_input(p);
    return data;
}

std::vector<std::int64_t> genus_of_components(const geometry::SurfaceData& surface) {
    core::DisjointSets parts(surface.vertices.size());
    for (const auto& [a, b, c] : surface.triangles) parts.unite(a, b), parts.unite(a, c);
    // V - E + F with E = 3 F / 2 on a closed surface.
    std::vector<std::int64_t> vertices(surface.vertices.size(), 0), triangles(surface.vertices.size(), 0);
    for (std::size_t v = 0; v < surface.vertices.size(); ++v) ++vertices[parts.find(v)];
    for (const auto& triangle : surface.triangles) ++triangles[parts.find(triangle[0])];
    std::vector<std::int64_t> genus;
    for (std::size_t v = 0; v < vertices.size(); ++v)
        if (triangles[v] > 0) genus.push_back(1 - (vertices[v] - triangles[v] / 2) / 2);
    std::sort(genus.rbegin(), genus.rend());
    return genus;
}

void require_good_surface(const Reconstruction& result, const std::string& source) {
    if (result.surface.triangles.empty())
        throw core::RunError(source +
                             ": no surface was found: the points don't enclose anything at their spacing; "
                             "give more points, or --noise");
    const geometry::SurfaceCheck& check = result.check;
    const bool is_good = check.is_closed() && check.is_manifold() && check.is_oriented() &&
                         check.degenerate_triangles.empty() && check.volume && *check.volume > 0 &&
                         geometry::self_intersections(result.surface).empty();
    if (!is_good)
        throw core::RunError(source +
                             ": the surface is not valid as its coordinates are rounded; move the points "
                             "nearer to the origin");
}

void measure(const Cloud& cloud, std::vector<Point3> points, const ReconstructParameters& parameters,
             Reconstruction& result) {
    for (Point3& p : points) p = cloud.to_input(p);
    const std::vector<double> distances = distances_from_surface(points, result.surface, parameters.threads);
    double sum = 0, squares = 0;
    for (const double d : distances) {
        sum += d;
        squares += d * d;
        result.residuals.largest = std::max(result.residuals.largest, d);
    }
    const auto count = static_cast<double>(distances.size());
    result.residuals.mean = sum / count;
    result.residuals.root_mean_square = std::sqrt(squares / count);
    const KdTree tree(points);
    for (const Point3& p : result.surface.vertices)
        result.vertex_distance.push_back(std::sqrt(tree.nearest(p).squared_distance));
    for (const auto& [a, b, c] : result.surface.triangles) {
        const Point3 middle =
            (result.surface.vertices[a] + result.surface.vertices[b] + result.surface.vertices[c]) / 3;
        const KdTree::Neighbour near = tree.nearest(middle);
        const double far = parameters.invented_distance * cloud.spacing[near.index] * cloud.scale;
        result.is_invented.push_back(near.squared_distance > far * far ? 1 : 0);
    }
}

void require_sensible_detail(double detail, const Cloud& cloud, const ReconstructParameters& parameters) {
    constexpr double beyond_rounding = 1.01;  // so that what a message proposes to three digits is not refused
    const double least = parameters.least_detail * cloud.median_spacing * cloud.scale;
    const double most = parameters.most_detail * cloud.scale;
    if (detail < least)
        throw core::UsageError(
            "detail: far below the spacing of the points, which say nothing about edges so short; "
            "give at least " +
            io::number_text(beyond_rounding * least, 3));
    if (detail > most)
        throw core::UsageError("detail: too long for a cloud of this size; give at most " +
                               io::number_text(most / beyond_rounding, 3));
}

// So many that their disk is as wide as noise asks for, which is a ratio of the spacing.
int wanted_neighbours(double noise, const ReconstructParameters& parameters) {
    const double radius = parameters.noise_reach * noise;
    return static_cast<int>(std::clamp(std::numbers::pi * radius * radius,
                                       static_cast<double>(parameters.cloud.neighbours),
                                       static_cast<double>(parameters.most_neighbours)));
}

}  // namespace

void ReconstructParameters::validate() const {
    if (detail && !(*detail > 0)) throw core::UsageError("detail: has to be positive");
    if (noise && !(*noise >= 0)) throw core::UsageError("noise: has to be at least 0");
    if (!(least_detail > 0)) throw core::UsageError("least_detail: has to be positive");
    if (!(most_detail > 0)) throw core::UsageError("most_detail: has to be positive");
    if (!(min_angle > 0 && min_angle <= 40)) throw core::UsageError("min_angle: has to be in (0, 40]");
    if (!(invented_distance > 0)) throw core::UsageError("invented_distance: has to be positive");
    if (!(noise_reach > 0)) throw core::UsageError("noise_reach: has to be positive");
    if (most_neighbours < cloud.neighbours) throw core::UsageError("most_neighbours: has to be at least neighbours");
    cloud.validate();
    normals.validate();
    orientation.validate();
    denoising.validate();
    front.validate();
    model.validate();
    fit.validate();
    bridge.validate();
}

Reconstruction reconstruct(const geometry::PointData& data, const ReconstructParameters& parameters,
                           const std::string& source, core::Observer& observer, const StageWatcher& watcher) {
    parameters.validate();
    Reconstruction result;
    result.points = data.points.size();
    core::Stopwatch watch;
    double last = 0;
    const auto end_phase = [&](const char* phase) {
        result.phases.push_back({phase, watch.seconds() - last});
        last = watch.seconds();
        observer.check_cancelled();
    };

    observer.progress("measuring the cloud", -1, "");
    Cloud cloud = prepared_cloud(data.points, parameters.cloud, source, parameters.threads);
    if (parameters.detail) require_sensible_detail(*parameters.detail, cloud, parameters);
    const double noise = parameters.noise ? *parameters.noise / cloud.scale : estimated_noise(cloud);
    const int neighbours = wanted_neighbours(noise / cloud.median_spacing, parameters);
    if (neighbours > parameters.cloud.neighbours) set_neighbours(cloud, static_cast<std::size_t>(neighbours));
    const std::vector<Vector3> axes = cloud_axes(cloud, noise, parameters.normals);
    end_phase("cloud");
    Orientation orientation = oriented_normals(cloud, axes, noise, parameters.orientation, observer);
    end_phase("orientation");
    const std::vector<Point3> measured = cloud.points;
    const double noise_left = denoise(cloud, orientation.normals, noise, parameters.denoising);
    end_phase("denoising");
    Front front = labelled_front(cloud, orientation, noise,
                                 parameters.detail ? std::optional(*parameters.detail / cloud.scale) : std::nullopt,
                                 parameters.front, observer);
    const KdTree tree(cloud.points);
    if (parameters.keeps_genus_zero) {
        shrink_to_genus_zero(*front.mesh, tree);
        front.cavities = 0;
    }
    if (watcher) watcher("front", interface_of(*front.mesh, cloud));
    end_phase("front");

    SurfaceModelParameters model_parameters = parameters.model;
    // What noise is left is averaged by more points than curvature asks for.
    if (noise_left < noise) model_parameters.patch_points = model_parameters.points;
    const SurfaceModel model(cloud, tree, orientation.normals, noise_left, model_parameters);
    const auto wanted = [&](const Point3& p) { return front.wanted_edge(tree.nearest(p).index); };
    double mean_edge = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
        mean_edge += front.wanted_edge(i) / static_cast<double>(cloud.size());
    {
        Workbench bench(*front.mesh, mean_edge, {});
        const FitWatcher fit_watcher = [&](const char* stage) {
            if (watcher) watcher(stage, interface_of(*front.mesh, cloud));
        };
        SurfaceFitParameters fit = parameters.fit;
        fit.refinement = std::max(fit.refinement, noise_left);
        result.fit = fit_surface(bench, model, wanted, fit, observer, fit_watcher);
        if (bridge_gaps(bench, cloud, tree, parameters.bridge, observer) > 0) fit_watcher("gaps bridged");
    }
    end_phase("fit");

    observer.progress("checking", -1, "");
    result.surface = interface_of(*front.mesh, cloud);
    result.check = geometry::check_surface(result.surface);
    require_good_surface(result, source);
    result.genus = genus_of_components(result.surface);
    result.duplicates = cloud.duplicates;
    result.strays = cloud.strays;
    result.spacing = cloud.median_spacing * cloud.scale;
    result.noise = noise * cloud.scale;
    result.cavities = front.cavities;
    result.dropped_parts = front.dropped_parts;
    measure(cloud, measured, parameters, result);
    end_phase("check");
    if (parameters.makes_tets) {
        result.tets = improved_inside(*front.mesh, cloud, parameters, observer);
        end_phase("tetrahedra");
    }
    return result;
}

}  // namespace dsc::reconstruct
