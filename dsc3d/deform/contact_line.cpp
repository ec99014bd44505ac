// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/contact_line.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
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

}  // namespace

Eigen::Vector3d contact_line_slip(RatedMesh& mesh, VertexId v, const Eigen::Vector3d& off, InterfaceRing& ring,
                                  const ContactLineParameters& parameters) {
    if (off.isZero(0)) return Eigen::Vector3d::Zero();
    Eigen::Matrix3d quadric = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    Eigen::Vector3d outwards = Eigen::Vector3d::Zero();
    double area = 0;
    for (const VertexId u : along_line(mesh, v)) {
        const surface::OneRing sheets = ring.gather(mesh, u);
        for (const surface::RingTriangle& triangle : sheets.triangles) {
            const Eigen::Vector3d scaled = (triangle.a - sheets.centre).cross(triangle.b - sheets.centre);
            const double a = scaled.norm();
            if (a == 0) continue;
            const Eigen::Vector3d normal = scaled / a;
            const Eigen::Vector3d within = mesh.surface().allowed_on_boundary(v, normal);
            quadric += a * within * within.transpose();
            right += a * normal.dot(off) * within;
            outwards += a * within;
            area += a;
        }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(quadric);
    const double steepest = solver.eigenvalues()[2];
    const double least = area * std::pow(std::sin(parameters.least_angle * std::numbers::pi / 180), 2);
    Eigen::Vector3d slip = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
        const double value = solver.eigenvalues()[i];
        if (!(value > least) || value < parameters.least_ratio * steepest) continue;
        const Eigen::Vector3d direction = solver.eigenvectors().col(i);
        slip += direction.dot(right) / value * direction;
    }
    return slip.dot(outwards) > 0 && leads_inside(mesh, v, off) ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : slip;
}

}  // namespace dsc::dsc3d
