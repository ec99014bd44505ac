// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/contact_line.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "core/sort_unique.h"

namespace dsc::dsc3d {

namespace {

// v and its neighbours on the line: the normals of its own few triangles alone are noisy.
std::vector<VertexId> along_line(RatedMesh& mesh, VertexId v) {
    const Complex& complex = mesh.complex();
    std::vector<VertexId> line = {v};
    for (const TetId t : mesh.walker().star(v))
        for (const EdgeId e : complex.edges(t)) {
            const auto [a, b] = complex.vertices(e);
            if ((a == v || b == v) && complex.is_boundary(e) && complex.is_interface(e)) line.push_back(a == v ? b : a);
        }
    core::sort_unique(line);
    return line;
}

// Whether the way leads into the domain.
bool leads_inside(RatedMesh& mesh, VertexId v, const Eigen::Vector3d& way) {
    double inwards = 0;
    for (const TetId t : mesh.walker().star(v))
        for (const VertexId u : mesh.complex().vertices(t)) inwards += way.dot(mesh.position(u) - mesh.position(v));
    return inwards > 0;
}

/// Of the interface around one or more vertices, weighted by area, without the triangles at the contact line: what
/// follows from them must not depend on where the line is.
struct RingMean {
    Point3 place = Point3::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    double area = 0;

    void add(RatedMesh& mesh, VertexId v, InterfaceRing& ring) {
        std::vector<Point3> line;
        for (const TetId t : mesh.walker().star(v))
            for (const VertexId u : mesh.complex().vertices(t))
                if (mesh.complex().is_boundary(u)) line.push_back(mesh.position(u));
        const auto is_on_line = [&](const Point3& p) { return std::find(line.begin(), line.end(), p) != line.end(); };
        const surface::OneRing sheets = ring.gather(mesh, v);
        for (const surface::RingTriangle& triangle : sheets.triangles) {
            if (is_on_line(triangle.a) || is_on_line(triangle.b)) continue;
            const Eigen::Vector3d scaled = (triangle.a - sheets.centre).cross(triangle.b - sheets.centre);
            place += scaled.norm() * (sheets.centre + triangle.a + triangle.b) / 3;
            normal += scaled;
            area += scaled.norm();
        }
    }
    /// How much of the area the normals, as long as theirs, come to together: 1 in a plane.
    double coherence() const { return normal.norm() / area; }
    void finish() {
        place /= area;
        normal.normalize();
    }
};

RingMean mean_of(RatedMesh& mesh, VertexId v, InterfaceRing& ring) {
    RingMean mean;
    mean.add(mesh, v, ring);
    mean.finish();
    return mean;
}

// Joined to v by an edge of the interface, inside the domain.
std::vector<VertexId> neighbours_inside(RatedMesh& mesh, VertexId v) {
    const Complex& complex = mesh.complex();
    std::vector<VertexId> found;
    for (const TetId t : mesh.walker().star(v))
        for (const EdgeId e : complex.edges(t)) {
            const auto [a, b] = complex.vertices(e);
            const VertexId other = a == v ? b : a;
            if ((a == v || b == v) && complex.is_interface(e) && !complex.is_boundary(other)) found.push_back(other);
        }
    core::sort_unique(found);
    return found;
}

/// How the sheet goes on behind the contact line at v: the way from there into the sheet, and the normal curvature in
/// this direction in the rows of vertices behind it, positive where the sheet turns away from its normal.
struct SheetBehind {
    Eigen::Vector3d way = Eigen::Vector3d::Zero();
    double curvature = 0;
};

SheetBehind sheet_behind(RatedMesh& mesh, VertexId v, InterfaceRing& ring) {
    SheetBehind sheet;
    const std::vector<VertexId> first = neighbours_inside(mesh, v);
    if (first.empty()) return sheet;
    for (const VertexId u : first)
        sheet.way += (mesh.position(u) - mesh.position(v)) / static_cast<double>(first.size());
    const Eigen::Vector3d along = sheet.way.normalized();
    double weight = 0;
    for (const VertexId u : first) {
        const RingMean here = mean_of(mesh, u, ring);
        if (here.area == 0) continue;
        for (const VertexId w : neighbours_inside(mesh, u)) {
            const RingMean there = mean_of(mesh, w, ring);
            if (there.area == 0) continue;
            const Eigen::Vector3d step = there.place - here.place;
            const double aligned = along.dot(step);
            if (!(aligned > 0.7 * step.norm())) continue;
            sheet.curvature += (there.normal - here.normal).dot(step) / step.squaredNorm() * aligned;
            weight += aligned;
        }
    }
    if (weight > 0) sheet.curvature /= weight;
    return sheet;
}

/// Of sheets near a vertex of the line, within its wall.
struct Quadric {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d motion = Eigen::Vector3d::Zero();   ///< along the normals, as asked for
    Eigen::Vector3d normals = Eigen::Vector3d::Zero();  ///< their sum
    double area = 0;

    Eigen::Vector3d least_slip(const Eigen::Vector3d& wanted, const ContactLineParameters& parameters) const {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
        const double least = std::max(area * std::pow(std::sin(parameters.least_angle * std::numbers::pi / 180), 2),
                                      parameters.least_ratio * solver.eigenvalues()[2]);
        Eigen::Vector3d slip = Eigen::Vector3d::Zero();
        for (Eigen::Index i = 0; i < 3; ++i) {
            if (!(solver.eigenvalues()[i] > least)) continue;
            const Eigen::Vector3d direction = solver.eigenvectors().col(i);
            slip += direction.dot(wanted) / solver.eigenvalues()[i] * direction;
        }
        return slip;
    }
};

// `vertices`: whose sheets count.
Quadric quadric_at(RatedMesh& mesh, VertexId v, std::span<const VertexId> vertices, const Eigen::Vector3d& off,
                   InterfaceRing& ring) {
    Quadric quadric;
    for (const VertexId u : vertices) {
        const surface::OneRing sheets = ring.gather(mesh, u);
        for (const surface::RingTriangle& triangle : sheets.triangles) {
            const Eigen::Vector3d scaled = (triangle.a - sheets.centre).cross(triangle.b - sheets.centre);
            const double area = scaled.norm();
            if (area == 0) continue;
            const Eigen::Vector3d normal = scaled / area;
            const Eigen::Vector3d within = mesh.surface().allowed_on_boundary(v, normal);
            quadric.matrix += area * within * within.transpose();
            quadric.motion += area * normal.dot(off) * within;
            quadric.normals += area * within;
            quadric.area += area;
        }
    }
    return quadric;
}

// By the sheets at the line.
Eigen::Vector3d slip_of_sheets(RatedMesh& mesh, VertexId v, const Eigen::Vector3d& off, const SheetBehind& sheet,
                               InterfaceRing& ring, const ContactLineParameters& parameters) {
    const Quadric quadric = quadric_at(mesh, v, along_line(mesh, v), off, ring);
    Eigen::Vector3d slip = quadric.least_slip(quadric.motion, parameters);
    const double length = sheet.way.norm();
    if (length > 0) {
        // What comes out of the wall goes on as a parabola does whose axis is the normal.
        const double exposed = (off - slip).dot(sheet.way) / length;
        const double bend =
            std::clamp(sheet.curvature * (length + exposed), -parameters.largest_bend, parameters.largest_bend);
        slip = quadric.least_slip(quadric.motion - 0.5 * bend * exposed * quadric.normals, parameters);
    }
    const Quadric own = quadric_at(mesh, v, std::array{v}, off, ring);
    if (slip.dot(own.normals) <= 0 || !leads_inside(mesh, v, off)) return slip;
    // Flared as the last row of triangles may be by an accident of contact, the rows behind it decide.
    const Quadric behind = quadric_at(mesh, v, neighbours_inside(mesh, v), off, ring);
    slip = behind.least_slip(behind.motion, parameters);
    return slip.dot(behind.normals) > 0 ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : slip;
}

// Of their rings, which are one smooth sheet; none where they are not, or not there.
std::optional<RingMean> smooth_mean(RatedMesh& mesh, std::span<const VertexId> vertices, InterfaceRing& ring,
                                    const ContactLineParameters& parameters) {
    RingMean mean;
    for (const VertexId u : vertices) mean.add(mesh, u, ring);
    if (!(mean.coherence() > parameters.least_coherence)) return std::nullopt;
    mean.finish();
    return mean;
}

// Behind the first row.
std::vector<VertexId> second_row(RatedMesh& mesh, std::span<const VertexId> first) {
    std::vector<VertexId> second;
    for (const VertexId u : first) {
        const std::vector<VertexId> around = neighbours_inside(mesh, u);
        second.insert(second.end(), around.begin(), around.end());
    }
    core::sort_unique(second);
    std::erase_if(second, [&](VertexId w) { return std::find(first.begin(), first.end(), w) != first.end(); });
    return second;
}

// To where the nearest row behind the line that is a smooth sheet will meet the wall; none where there is no such row.
std::optional<Eigen::Vector3d> slip_of_rows(RatedMesh& mesh, VertexId v, const Eigen::Vector3d& off, double curvature,
                                            InterfaceRing& ring, const ContactLineParameters& parameters) {
    std::vector<VertexId> row = neighbours_inside(mesh, v);
    std::optional<RingMean> mean = smooth_mean(mesh, row, ring, parameters);
    if (!mean) {
        row = second_row(mesh, row);
        mean = smooth_mean(mesh, row, ring, parameters);
    }
    if (!mean) return std::nullopt;
    const Eigen::Vector3d& normal = mean->normal;
    const Eigen::Vector3d within = mesh.surface().allowed_on_boundary(v, normal);
    if (within.norm() < std::sin(parameters.least_angle * std::numbers::pi / 180)) return std::nullopt;
    const Eigen::Vector3d way = mean->place + off - mesh.position(v);
    // The parabola of the curvature depends on how far the line is from the row in the end.
    double distance = normal.dot(way);
    for (int i = 0; i < 2; ++i) {
        const double length = (way - distance / within.squaredNorm() * within).norm();
        const double bend = std::clamp(curvature * length, -parameters.largest_bend, parameters.largest_bend);
        distance = normal.dot(way) - 0.5 * bend * length;
    }
    // What is pulled off is not widened.
    if (distance > 0 && leads_inside(mesh, v, off)) return Eigen::Vector3d::Zero();
    const double longest = std::abs(normal.dot(off)) / within.norm() + parameters.recovery * off.norm();
    const Eigen::Vector3d slip = distance / within.squaredNorm() * within;
    return slip * std::min(1.0, longest / std::max(longest, slip.norm()));
}

}  // namespace

Eigen::Vector3d contact_line_slip(RatedMesh& mesh, VertexId v, const Eigen::Vector3d& off, InterfaceRing& ring,
                                  const ContactLineParameters& parameters) {
    if (off.isZero(0)) return Eigen::Vector3d::Zero();
    const SheetBehind sheet = sheet_behind(mesh, v, ring);
    const auto slip = slip_of_rows(mesh, v, off, sheet.curvature, ring, parameters);
    return slip ? *slip : slip_of_sheets(mesh, v, off, sheet, ring, parameters);
}

}  // namespace dsc::dsc3d
