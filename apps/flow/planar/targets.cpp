// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/targets.h"

#include <numbers>
#include <utility>

#include "apps/flow/velocity_file.h"
#include "dsc2d/curve/curvature_step.h"
#include "dsc2d/curve/edge_offsetting.h"
#include "dsc2d/interface.h"
#include "motion/curl_noise.h"
#include "motion/expression_field.h"
#include "motion/fields.h"
#include "motion/rigid.h"
#include "motion/runge_kutta.h"

namespace dsc::flow::planar {

using dsc2d::Complex;
using dsc2d::Interface;
using dsc2d::VertexId;

namespace {

// A curve whose edges are shorter than this has vanished [edge_length].
constexpr double vanished = 1e-2;

// Targets of the interface vertices inside the domain; those on its boundary stay.
std::vector<std::optional<Point2>> moved(const Complex& complex, const Interface& interface,
                                         const std::vector<Point2>& displacements) {
    std::vector<std::optional<Point2>> targets(complex.vertex_capacity());
    for (std::size_t i = 0; i < displacements.size(); ++i) {
        const VertexId v = interface.vertices[i];
        if (!complex.is_boundary(v)) targets[v.index()] = complex.position(v) + displacements[i];
    }
    return targets;
}

template <class Flow>
Targets along(Flow flow) {
    return [flow = std::move(flow)](const Complex& complex, double time, double dt) {
        std::vector<std::optional<Point2>> targets(complex.vertex_capacity());
        for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
            const VertexId v(i);
            if (!complex.is_deleted(v) && complex.is_interface(v) && !complex.is_boundary(v))
                targets[i] = flow.at(complex.position(v), time, time + dt);
        }
        return targets;
    };
}

using RungeKutta = motion::RungeKuttaFlow<2>;

}  // namespace

Targets motion_targets(const MotionOptions& motion, const Eigen::AlignedBox2d& domain, double edge_length,
                       double until) {
    switch (motion.motion) {
        case Motion::rotate: {
            const double speed = motion.angle * std::numbers::pi / 180 / until;
            return along(motion::Rotation<2>({motion.about.value_or(domain.center()), speed}));
        }
        case Motion::curvature:
            return [parameters = dsc2d::CurvatureParameters{.shortest_edge = vanished * edge_length}](
                       const Complex& complex, double, double dt) {
                const Interface interface(complex);
                std::vector<std::uint8_t> is_fixed;
                for (const VertexId v : interface.vertices) is_fixed.push_back(complex.is_boundary(v) ? 1 : 0);
                return moved(complex, interface, curvature_displacements(interface, dt, is_fixed, parameters));
            };
        case Motion::offset:
            return [speed = motion.distance / until](const Complex& complex, double, double dt) {
                const Interface interface(complex);
                return moved(complex, interface, offset_displacements(interface, speed * dt, {}));
            };
        case Motion::vortex: return along(RungeKutta(motion::vortex_in_square(motion.period)));
        case Motion::translate: return along(motion::Translation<2>(motion.velocity));
        case Motion::curl_noise:
            return along(RungeKutta(motion::curl_noise(motion::CurlNoiseParameters<2>{.low = domain.min(),
                                                                                      .high = domain.max(),
                                                                                      .has_walls = motion.has_walls,
                                                                                      .max_frequency = motion.frequency,
                                                                                      .max_speed = motion.speed,
                                                                                      .seed = motion.seed})));
        case Motion::shear:
            return along(RungeKutta(
                motion::shear_field(motion.direction, motion.gradient, motion.about.value_or(domain.center()))));
        case Motion::grid: return along(RungeKutta(velocity_from_file<2>(motion.path, motion.array)));
        case Motion::expression: break;
    }
    return along(RungeKutta(motion::expression_field<2>(motion.expressions)));
}

}  // namespace dsc::flow::planar
