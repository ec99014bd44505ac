// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/initial_mesh.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include "core/assert.h"
#include "core/errors.h"
#include "dsc3d/generate/blocks.h"
#include "dsc3d/generate/remesh.h"
#include "dsc3d/generate/shapes.h"
#include "dsc3d/generate/tetrahedralize.h"
#include "dsc3d/generate/vessel.h"
#include "dsc3d/interface.h"
#include "dsc3d/operations/triangle_wall.h"
#include "io/closed_surface.h"
#include "io/surface_mesh.h"
#include "io/tet_mesh.h"

namespace dsc::flow {

using Box = Eigen::AlignedBox3d;
using geometry::InterfaceData;
using geometry::SurfaceData;

namespace {

// Of the vertices that have triangles.
Box bounds(const SurfaceData& surface) {
    Box box;
    for (const auto& triangle : surface.triangles)
        for (const std::uint32_t v : triangle) box.extend(surface.vertices[v]);
    return box;
}

Box bounds(const std::vector<Point3>& points) {
    Box box;
    for (const Point3& p : points) box.extend(p);
    return box;
}

Box box_around(const Point3& centre, const Point3& size) { return {centre - size / 2, centre + size / 2}; }

InterfaceData of_one_label(SurfaceData surface) {
    InterfaceData data{.surface = std::move(surface)};
    data.sides.assign(data.surface.triangles.size(), {0, 1});
    return data;
}

// The unit box when it leaves a quarter of the size on each side, else twice the size: then there is room to turn.
Box default_domain(const Box& shape) {
    const double size = shape.sizes().maxCoeff();
    const Box unit(Point3(0, 0, 0), Point3(1, 1, 1));
    if (unit.contains(box_around(shape.center(), shape.sizes() + Point3::Constant(size / 2)))) return unit;
    return box_around(shape.center(), Point3::Constant(2 * size));
}

double mean_edge_length(const SurfaceData& surface) {
    double sum = 0;
    for (const auto& triangle : surface.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            sum += (surface.vertices[triangle[k]] - surface.vertices[triangle[(k + 1) % 3]]).norm();
    return sum / 3 / static_cast<double>(surface.triangles.size());
}

bool is_in_vessel(const ShapeOptions& options) { return options.sphere || !options.container.empty(); }

SurfaceData read_closed_surface(const std::string& path) {
    SurfaceData surface = io::read_surface_mesh(path);
    surface.labels.clear();
    io::require_closed_surface(path, surface);
    return surface;
}

bool is_tet_file(const std::string& path) {
    static const std::set<std::string> extensions = {".mesh", ".msh", ".node", ".ele", ".vtu", ".vtk"};
    return extensions.contains(std::filesystem::path(path).extension().string());
}

InitialMesh from_tets(const ShapeOptions& options) {
    if (options.growth) throw core::UsageError("--growth: a tetrahedral mesh from a file has its tetrahedra");
    if (options.domain || is_in_vessel(options))
        throw core::UsageError("--domain: a tetrahedral mesh from a file is its own domain");
    InitialMesh result{.data = io::read_tet_mesh(options.path).data, .may_be_too_fine = true};
    const dsc3d::Interface interface(dsc3d::Mesh(result.data, options.path));
    if (interface.faces.empty())
        throw core::InputError(options.path, "", "all tetrahedra have the same label, so there is nothing to move",
                               "give each region a label of its own");
    result.domain = bounds(result.data.vertices);
    result.edge_length = options.edge_length.value_or(mean_edge_length(interface.data.surface));
    return result;
}

// Edges of the sphere grow with the distance from the interface, as those of the tetrahedra do later.
SurfaceData sphere_around(const SphericalDomain& sphere, const SurfaceData& interface, double edge_length) {
    constexpr double growth = 0.6;
    // What triangles with edges over which the sphere turns by 6 degrees cut off: no longer ones come (flat_surface.h).
    constexpr double cut_off = 0.002;
    double farthest = 0;
    for (const Point3& p : interface.vertices) farthest = std::max(farthest, (p - sphere.centre).norm());
    if (farthest >= (1 - cut_off) * sphere.radius)
        throw core::UsageError("--domain: the surface comes out of the triangles of the sphere; make it larger");
    const double length = edge_length + growth * (sphere.radius - farthest);
    // Edges that don't cut off more of the sphere than the deformation does.
    constexpr std::uint32_t least_frequency = 12;
    return dsc3d::icosphere(sphere.centre, sphere.radius,
                            std::max(least_frequency, dsc3d::icosphere_frequency(sphere.radius, length)));
}

InitialMesh in_vessel(const InterfaceData& interface, const ShapeOptions& options, core::Observer& observer) {
    InitialMesh result;
    result.edge_length = mean_edge_length(interface.surface);
    const SurfaceData vessel = options.sphere ? sphere_around(*options.sphere, interface.surface, result.edge_length)
                                              : read_closed_surface(options.container);
    result.domain = options.sphere ? box_around(options.sphere->centre, Point3::Constant(2 * options.sphere->radius))
                                   : bounds(vessel);
    result.data = dsc3d::tetrahedralize_within(interface, vessel, {}, observer);
    return result;
}

template <class Surface>
InitialMesh around(const Surface& surface, const SurfaceData& triangles, const ShapeOptions& options,
                   core::Observer& observer) {
    InitialMesh result;
    result.domain = options.domain.value_or(default_domain(bounds(triangles)));
    result.edge_length = mean_edge_length(triangles);
    dsc3d::TetrahedralizeParameters parameters;
    if (options.growth) parameters.growth = *options.growth;
    result.data = dsc3d::tetrahedralize(surface, result.domain, parameters, observer);
    result.may_be_too_fine = options.growth.has_value();
    return result;
}

InitialMesh from_surface(const ShapeOptions& options, core::Observer& observer) {
    SurfaceData surface = read_closed_surface(options.path);
    if (options.edge_length) {
        dsc3d::RemeshParameters parameters{.edge_length = *options.edge_length};
        if (options.feature_angle) parameters.feature_angle = *options.feature_angle;
        surface = dsc3d::remeshed(surface, parameters);
    }
    if (is_in_vessel(options)) return in_vessel(of_one_label(std::move(surface)), options, observer);
    return around(surface, surface, options, observer);
}

}  // namespace

InterfaceData shape_surface(const ShapeOptions& options) {
    const Point3& centre = options.centre;
    switch (options.shape) {
        case Shape::sphere: {
            const double radius = options.radius.value_or(0.3);
            const double length = options.edge_length.value_or(0.15 * radius);
            return of_one_label(dsc3d::icosphere(centre, radius, dsc3d::icosphere_frequency(radius, length)));
        }
        case Shape::two_spheres: {
            const double radius = options.radius.value_or(0.15), gap = options.gap.value_or(0.01);
            const double length = options.edge_length.value_or(0.15 * radius);
            return of_one_label(dsc3d::two_spheres(centre, radius, gap, dsc3d::icosphere_frequency(radius, length)));
        }
        case Shape::torus: {
            const double major = options.radius.value_or(0.3), minor = options.minor_radius.value_or(0.1);
            return of_one_label(dsc3d::torus(centre, major, minor, options.edge_length.value_or(0.45 * minor)));
        }
        case Shape::dumbbell: {
            const dsc3d::DumbbellSize size = {.half_distance = options.spread.value_or(1) / 2,
                                              .ball_radius = options.radius.value_or(0.3),
                                              .neck_radius = options.minor_radius.value_or(0.1)};
            return of_one_label(dsc3d::dumbbell(centre, size, options.edge_length.value_or(0.5 * size.neck_radius)));
        }
        case Shape::box: {
            const Point3 size = options.size.value_or(Point3(1, 1, 1));
            const double length = options.edge_length.value_or(size.maxCoeff() / 10);
            return of_one_label(dsc3d::box_surface(box_around(centre, size), length));
        }
        case Shape::slotted_cube: {
            const double side = options.size.value_or(Point3::Constant(0.4)).x();
            const dsc3d::SlottedCubeSize size = {.side = side,
                                                 .slot_width = options.slot_width.value_or(side / 4),
                                                 .slot_depth = options.slot_depth.value_or(side / 2)};
            return of_one_label(dsc3d::slotted_cube(centre, size, options.edge_length.value_or(size.slot_width / 2)));
        }
        case Shape::labelled_block: {
            const Point3 size = options.size.value_or(Point3::Constant(0.4));
            return dsc3d::labelled_block(box_around(centre, size), options.edge_length.value_or(size.maxCoeff() / 8));
        }
        case Shape::file: break;
    }
    DSC_ASSERT(false);
    return {};
}

dsc3d::Walls domain_walls(const ShapeOptions& options) {
    if (!options.container.empty()) return dsc3d::container_walls(read_closed_surface(options.container));
    if (!options.sphere) return {};
    return {std::make_shared<dsc3d::SphereWall>(options.sphere->centre, options.sphere->radius)};
}

InitialMesh initial_mesh(const ShapeOptions& options, core::Observer& observer) {
    if (options.shape == Shape::file)
        return is_tet_file(options.path) ? from_tets(options) : from_surface(options, observer);
    const InterfaceData data = shape_surface(options);
    if (is_in_vessel(options)) return in_vessel(data, options, observer);
    return around(data, data.surface, options, observer);
}

}  // namespace dsc::flow
