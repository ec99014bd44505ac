// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/targets.h"

#include <numbers>
#include <utility>

#include "apps/flow/velocity_file.h"
#include "dsc3d/interface.h"
#include "motion/curl_noise.h"
#include "motion/expression_field.h"
#include "motion/fields.h"
#include "motion/rigid.h"
#include "motion/runge_kutta.h"
#include "surface/face_offsetting.h"
#include "surface/implicit_curvature.h"
#include "surface/vertex_rings.h"

namespace dsc::flow {

namespace {

// Targets of all interface vertices; those on the boundary of the domain slide on it.
template <class Map>
std::vector<std::optional<Point3>> mapped(const dsc3d::Mesh& mesh, const Map& map) {
    const dsc3d::Complex& complex = mesh.complex();
    std::vector<std::optional<Point3>> targets(complex.vertex_capacity());
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
        const dsc3d::VertexId v(i);
        if (!complex.is_deleted(v) && complex.is_interface(v)) targets[i] = map(mesh.position(v));
    }
    return targets;
}

// The same by the places in the interface: `positions` has one for each of its vertices.
std::vector<std::optional<Point3>> placed(const dsc3d::Mesh& mesh, const dsc3d::Interface& interface,
                                          const std::vector<Point3>& positions) {
    std::vector<std::optional<Point3>> targets(mesh.complex().vertex_capacity());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        targets[interface.vertices[i].index()] = positions[i];
    }
    return targets;
}

template <class Flow>
Targets along(Flow flow) {
    return [flow = std::move(flow)](const dsc3d::Mesh& mesh, double time, double dt) -> StepMotion {
        const auto path = [flow, time, dt](const Point3& p, double share) -> Point3 {
            return flow.at(p, time, time + share * dt);
        };
        return {mapped(mesh, [&](const Point3& p) -> Point3 { return flow.at(p, time, time + dt); }), path};
    };
}

// Of the way of a vertex.
constexpr double largest_correction = 0.25;

using RungeKutta = motion::RungeKuttaFlow<3>;

// Thesis 4.4.1.2, with the semi-implicit step, which is stable for every dt, made of second order by extrapolation: the
// error of two half steps is half of that of a whole one. Where the difference is too large for that, as when a part
// vanishes, less of it is used.
StepMotion curvature_targets(const dsc3d::Mesh& mesh, double, double dt) {
    const dsc3d::Interface interface(mesh);
    std::vector<std::uint8_t> is_fixed;
    for (const dsc3d::VertexId v : interface.vertices) is_fixed.push_back(mesh.complex().is_boundary(v) ? 1 : 0);
    const geometry::SurfaceData& start = interface.data.surface;
    const std::vector<Point3> whole = surface::implicit_curvature_step(start, dt, is_fixed);
    geometry::SurfaceData middle = start;
    middle.vertices = surface::implicit_curvature_step(start, dt / 2, is_fixed);
    std::vector<Point3> positions = surface::implicit_curvature_step(middle, dt / 2, is_fixed);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Eigen::Vector3d correction = positions[i] - whole[i];
        const double largest = largest_correction * (positions[i] - start.vertices[i]).norm();
        positions[i] += correction * (correction.norm() > largest ? largest / correction.norm() : 1.0);
    }
    return {placed(mesh, interface, positions), nullptr};
}

// Thesis 4.4.1.3. Normals point to the lower label: out of objects, into the background.
StepMotion offset_targets(const dsc3d::Mesh& mesh, double distance) {
    const dsc3d::Interface interface(mesh);
    const surface::VertexRings rings(interface.data.surface);
    std::vector<surface::RingTriangle> buffer;
    std::vector<Point3> positions = interface.data.surface.vertices;
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        positions[i] += surface::offset_displacement(rings.ring(i, buffer), distance, {});
    return {placed(mesh, interface, positions), nullptr};
}

}  // namespace

Targets motion_targets(const MotionOptions& motion, const Eigen::AlignedBox3d& domain, double until) {
    switch (motion.motion) {
        case Motion::rotate: {
            const double speed = motion.angle * std::numbers::pi / 180 / until;
            return along(motion::Rotation<3>({motion.about.value_or(domain.center()), motion.axis, speed}));
        }
        case Motion::curvature: return curvature_targets;
        case Motion::offset:
            return [speed = *motion.distance / until](const dsc3d::Mesh& mesh, double, double dt) {
                return offset_targets(mesh, speed * dt);
            };
        case Motion::enright: return along(RungeKutta(motion::enright_deformation(motion.period)));
        case Motion::vortex: return along(RungeKutta(motion::vortex_in_cube(motion.period)));
        case Motion::translate: return along(motion::Translation<3>(*motion.velocity));
        case Motion::curl_noise:
            return along(RungeKutta(motion::curl_noise(motion::CurlNoiseParameters<3>{.low = domain.min(),
                                                                                      .high = domain.max(),
                                                                                      .has_walls = true,
                                                                                      .max_frequency = motion.frequency,
                                                                                      .max_speed = motion.speed,
                                                                                      .seed = motion.seed})));
        case Motion::shear:
            return along(RungeKutta(
                motion::shear_field(motion.direction, motion.gradient, motion.about.value_or(domain.center()))));
        case Motion::grid: return along(RungeKutta(velocity_from_file<3>(motion.path, motion.array)));
        case Motion::expression: break;
    }
    return along(RungeKutta(motion::expression_field<3>(*motion.expressions)));
}

}  // namespace dsc::flow
