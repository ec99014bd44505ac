// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/initial_complex.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numbers>

#include "apps/flow/planar/polygon_file.h"
#include "core/assert.h"
#include "core/errors.h"
#include "dsc2d/generate/complex_around.h"
#include "dsc2d/generate/shapes.h"
#include "dsc2d/interface.h"
#include "dsc2d/validate.h"
#include "geometry/polygon_check.h"
#include "io/planar_mesh.h"

namespace dsc::flow::planar {

using Box = Eigen::AlignedBox2d;
using dsc2d::Complex;
using dsc2d::Region;

namespace {

struct Outlines {
    std::vector<Region> regions;
    double edge_length = 0;
};

Box bounds(const std::vector<Region>& regions) {
    Box box;
    for (const Region& region : regions)
        for (const Point2& p : region.outline) box.extend(p);
    return box;
}

// The unit square when it leaves a quarter of the size on each side, else twice the size: then there is room to turn.
Box default_domain(const Box& shape) {
    const double size = shape.sizes().maxCoeff();
    const Point2 room = Point2::Constant(size / 4), half = Point2::Constant(size);
    const Box unit(Point2(0, 0), Point2(1, 1));
    if (unit.contains(Box(shape.min() - room, shape.max() + room))) return unit;
    return {shape.center() - half, shape.center() + half};
}

Outlines from_file(const ShapeOptions& options) {
    Outlines result{.regions = read_polygons(options.path, options.edge_length)};
    result.edge_length = options.edge_length.value_or(bounds(result.regions).sizes().maxCoeff() / 60);
    for (Region& region : result.regions) region.outline = dsc2d::divided(region.outline, result.edge_length);
    return result;
}

Outlines by_name(const ShapeOptions& options) {
    const Point2& centre = options.centre;
    const auto length = [&](double standard) { return options.edge_length.value_or(standard); };
    switch (options.shape) {
        case Shape::disc: {
            const double radius = options.radius.value_or(0.3), edge = length(0.1 * radius);
            return {dsc2d::disc(centre, radius, edge), edge};
        }
        case Shape::two_discs: {
            const double radius = options.radius.value_or(0.15), edge = length(0.1 * radius);
            return {dsc2d::two_discs(centre, radius, options.gap.value_or(0.01), edge), edge};
        }
        case Shape::ring: {
            const double radius = options.radius.value_or(0.3), half_width = options.minor_radius.value_or(0.1);
            const double edge = length(0.25 * half_width);
            return {dsc2d::ring(centre, radius, half_width, edge), edge};
        }
        case Shape::dumbbell: {
            const dsc2d::DumbbellSize size = {.half_distance = options.spread.value_or(1) / 2,
                                              .disc_radius = options.radius.value_or(0.3),
                                              .neck = options.minor_radius.value_or(0.1)};
            const double edge = length(0.25 * size.neck);
            return {dsc2d::dumbbell(centre, size, edge), edge};
        }
        case Shape::slotted_disc: {
            const double radius = options.radius.value_or(0.3), width = options.slot_width.value_or(radius / 3);
            const double edge = length(width / 4);
            return {dsc2d::slotted_disc(centre, radius, width, options.slot_depth.value_or(5 * radius / 3), edge),
                    edge};
        }
        case Shape::polygon: {
            const double radius = options.radius.value_or(0.3), edge = length(0.1 * radius);
            const auto corners = dsc2d::regular_polygon(centre, radius, options.sides, true);
            return {{{dsc2d::divided(corners, edge), 1}}, edge};
        }
        case Shape::box: {
            const Point2 size = options.size.value_or(Point2(1, 1));
            const double edge = length(size.maxCoeff() / 20);
            return {dsc2d::rectangle(centre, size, edge), edge};
        }
        case Shape::labelled_block: {
            const Point2 size = options.size.value_or(Point2(0.4, 0.4));
            const double edge = length(size.maxCoeff() / 16);
            return {dsc2d::labelled_block(centre, size, edge), edge};
        }
        case Shape::file: break;
    }
    return from_file(options);
}

void require_room(const ShapeOptions& options, const Outlines& outlines, const Box& domain) {
    const std::string source = options.shape == Shape::file ? options.path : "the shape";
    for (const Region& region : outlines.regions) {
        for (const Point2& p : region.outline) {
            if (options.is_torus || (domain.min().array() < p.array() && p.array() < domain.max().array()).all())
                continue;
            throw core::InputError(source, fmt::format("at ({:.6g}, {:.6g})", p.x(), p.y()), "leaves the box",
                                   "give a larger --domain");
        }
    }
}

// Coordinates lie on the grid of the domain, whose spacing grows with the distance from the origin.
void require_resolution(const std::string& source, const dsc2d::Domain& domain, double edge_length) {
    constexpr double least_spacings = 1000;
    if (edge_length >= least_spacings * domain.quantum()) return;
    throw core::InputError(source, "",
                           fmt::format("the edge length {:.3g} is too small for coordinates near ({:.3g}, {:.3g})",
                                       edge_length, domain.origin().x(), domain.origin().y()),
                           "move the shape to the origin, or give a greater --edge-length");
}

double mean_length(const dsc2d::Interface& interface) {
    double sum = 0;
    for (const dsc2d::InterfaceSegment& s : interface.segments) sum += s.vector.norm();
    return sum / static_cast<double>(interface.segments.size());
}

// The walls of a domain are the sides of a box: a mesh that ends elsewhere would lose what is moved there.
void require_box(const std::string& source, const Complex& complex) {
    constexpr double rounding = 1e-9;
    const auto text = [](const Point2& p) { return fmt::format("({:.6g}, {:.6g})", p.x(), p.y()); };
    const std::string cure = "fill a whole box with triangles that share their vertices, label 0 being outside";
    Box box;
    for (std::uint32_t v = 0; v < complex.vertex_capacity(); ++v) box.extend(complex.position(dsc2d::VertexId(v)));
    for (std::uint32_t e = 0; e < complex.edge_capacity(); ++e) {
        const dsc2d::HalfedgeId h = Complex::halfedge(dsc2d::EdgeId(e));
        if (!complex.is_boundary(dsc2d::EdgeId(e))) continue;
        const Point2 &a = complex.position(complex.from(h)), &b = complex.position(complex.to(h));
        const auto are_both_on = [&](const Point2& corner) {
            return (a.array() == corner.array() && b.array() == corner.array()).any();
        };
        if (are_both_on(box.min()) || are_both_on(box.max())) continue;
        throw core::InputError(
            source, "edge from " + text(a) + " to " + text(b),
            "the mesh ends here, inside its bounding box from " + text(box.min()) + " to " + text(box.max()), cure);
    }
    const double area = total_area(complex);
    if (std::abs(area - box.volume()) > rounding * box.volume())
        throw core::InputError(
            source, "",
            fmt::format("its triangles overlap: their area is {:.9g}, that of their bounding box {:.9g}", area,
                        box.volume()),
            cure);
}

InitialComplex from_mesh(const ShapeOptions& options) {
    if (options.domain) throw core::UsageError("--domain: a planar mesh from a file is its own domain");
    if (options.is_torus) throw core::UsageError("--torus: a planar mesh from a file is its own domain");
    const geometry::SurfaceData data = io::read_planar_mesh(options.path);
    std::vector<Point2> points;
    Box box;
    for (const Eigen::Vector3d& p : data.vertices) {
        points.emplace_back(p.head<2>());
        box.extend(points.back());
    }
    if (!(box.sizes().minCoeff() > 0))
        throw core::InputError(options.path, "", "all vertices lie on a line", "give a planar triangulation of a box");
    std::vector<dsc2d::TriangleInput> triangles;
    const dsc2d::LatticeVector zero = dsc2d::LatticeVector::Zero();
    for (std::size_t i = 0; i < data.triangles.size(); ++i)
        triangles.push_back({data.triangles[i], {zero, zero, zero}, data.label(i)});
    try {
        InitialComplex result{.complex = Complex(domain_of(box, options.is_torus), points, triangles), .domain = box};
        require_box(options.path, result.complex);
        const dsc2d::Interface interface(result.complex);
        if (interface.segments.empty())
            throw core::InputError(options.path, "", "all triangles have the same label, so there is nothing to move",
                                   "give each region a label of its own");
        result.edge_length = options.edge_length.value_or(mean_length(interface));
        return result;
    } catch (const core::InputError& error) {
        if (error.source() == options.path) throw;
        throw core::InputError(options.path, "", error.what(),
                               "give a planar triangulation (the numbers begin with 0)");
    }
}

}  // namespace

dsc2d::Domain domain_of(const Box& box, bool is_torus) {
    if (!is_torus) return dsc2d::Domain::box(box.min(), box.max());
    Eigen::Matrix2d periods = Eigen::Matrix2d::Zero();
    periods.diagonal() = box.sizes();
    return dsc2d::Domain::torus(periods, box.min());
}

InitialComplex initial_complex(const ShapeOptions& options, const core::Observer& observer) {
    if (options.shape == Shape::file && std::filesystem::path(options.path).extension() == ".mesh")
        return from_mesh(options);
    const Outlines outlines = by_name(options);
    const Box box = options.domain.value_or(default_domain(bounds(outlines.regions)));
    require_room(options, outlines, box);
    const std::string source = options.shape == Shape::file ? options.path : "the shape";
    const dsc2d::Domain domain = domain_of(box, options.is_torus);
    require_resolution(source, domain, outlines.edge_length);
    try {
        return {.complex = dsc2d::complex_around(domain, outlines.regions, outlines.edge_length, {}, observer),
                .domain = box,
                .edge_length = outlines.edge_length};
    } catch (const core::InputError& error) {
        throw core::InputError(source, "", error.what(), "");
    }
}

EdgeLimits edge_limits(const InitialComplex& initial) {
    constexpr double longest = 1.6, shortest = 0.4, room = 1.05;
    double least = std::numeric_limits<double>::infinity(), greatest = 0;
    for (const dsc2d::InterfaceSegment& s : dsc2d::Interface(initial.complex).segments) {
        least = std::min(least, s.vector.norm() / initial.edge_length);
        greatest = std::max(greatest, s.vector.norm() / initial.edge_length);
    }
    return {.edge_length = initial.edge_length,
            .shortest = std::min(shortest, least / room),
            .longest = std::max(longest, room * greatest)};
}

dsc2d::Parameters deformation(const EdgeLimits& edges, motion::TopologyPolicy topology) {
    dsc2d::Parameters parameters = {.edge_length = edges.edge_length, .topology = topology};
    parameters.interface_max_edge = edges.longest;
    parameters.interface_min_edge = edges.shortest;
    parameters.poor_angle = 25 * std::numbers::pi / 180;
    parameters.needle_angle = 20 * std::numbers::pi / 180;
    parameters.needle_min_length = 2;
    parameters.smoothing_sweeps = 2;
    return parameters;
}

}  // namespace dsc::flow::planar
