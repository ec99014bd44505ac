// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/targets.h"

#include <numbers>

#include "apps/flow/names.h"
#include "core/errors.h"

namespace dsc::flow {

namespace {

// Targets of all interface vertices inside the domain; those on its boundary stay.
template <class Map>
std::vector<std::optional<Point3>> mapped(const dsc3d::Mesh& mesh, const Map& map) {
    const dsc3d::Complex& complex = mesh.complex();
    std::vector<std::optional<Point3>> targets(complex.vertex_capacity());
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
        const dsc3d::VertexId v(i);
        if (!complex.is_deleted(v) && complex.is_interface(v) && !complex.is_boundary(v))
            targets[i] = map(mesh.position(v));
    }
    return targets;
}

}  // namespace

Targets motion_targets(const MotionOptions& motion, const Eigen::AlignedBox3d& domain, double until) {
    switch (motion.motion) {
        case Motion::rotate: {
            const Point3 about = motion.about.value_or(domain.center());
            const double speed = motion.angle * std::numbers::pi / 180 / until;
            return [about, speed, axis = motion.axis](const dsc3d::Mesh& mesh, double, double dt) {
                const Eigen::Matrix3d turn = Eigen::AngleAxisd(speed * dt, axis.normalized()).toRotationMatrix();
                return mapped(mesh, [&](const Point3& p) -> Point3 { return about + turn * (p - about); });
            };
        }
        case Motion::translate:
            return [velocity = *motion.velocity](const dsc3d::Mesh& mesh, double, double dt) {
                return mapped(mesh, [&](const Point3& p) -> Point3 { return p + dt * velocity; });
            };
        default: throw core::UsageError("--motion " + name_of(motion_names, motion.motion) + " is not there yet");
    }
}

}  // namespace dsc::flow
