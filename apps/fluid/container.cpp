// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/container.h"

namespace dsc::fluid_app {

namespace {

constexpr double relative_tolerance = 1e-9;  // of the size of the container

}  // namespace

Container::Container(const Scene& scene)
    : box_(scene.domain), tolerance_(relative_tolerance * scene.domain.sizes().maxCoeff()) {
    if (!scene.vessel) return;
    sphere_ = std::make_shared<dsc3d::SphereWall>(scene.vessel->centre, scene.vessel->radius);
    tolerance_ = relative_tolerance * scene.vessel->radius;
}

bool Container::contains(const Point3& p) const {
    if (sphere_) return (p - sphere_->centre()).norm() <= sphere_->radius() + tolerance_;
    return box_.exteriorDistance(p) <= tolerance_;
}

template <class Take>
void Container::for_each_wall(const Point3& p, Take&& take) const {
    if (sphere_) {
        take(0, sphere_->radius() - (p - sphere_->centre()).norm(), sphere_->normal(p));
        return;
    }
    for (int k = 0; k < 3; ++k) {
        take(2 * k, p[k] - box_.min()[k], Point3(-Point3::Unit(k)));
        take(2 * k + 1, box_.max()[k] - p[k], Point3(Point3::Unit(k)));
    }
}

void Container::add_contacts(std::uint32_t vertex, const Point3& p,
                             std::vector<fluid::WallContact<3>>& contacts) const {
    for_each_wall(p, [&](int wall, double gap, const Point3& outwards) {
        if (gap <= tolerance_) contacts.push_back({vertex, outwards, 0, wall});
    });
}

void Container::add_arrivals(std::uint32_t vertex, const Point3& p, const Point3& velocity, double dt,
                             std::vector<fluid::WallContact<3>>& contacts) const {
    for_each_wall(p, [&](int wall, double gap, const Point3& outwards) {
        if (gap < dt * velocity.dot(outwards)) contacts.push_back({vertex, outwards, gap / dt, wall});
    });
}

Point3 Container::kept_inside(const Point3& p) const {
    return sphere_ && (p - sphere_->centre()).norm() > sphere_->radius() ? sphere_->nearest(p) : p;
}

dsc3d::Walls Container::walls() const { return sphere_ ? dsc3d::Walls{sphere_} : dsc3d::Walls{}; }

}  // namespace dsc::fluid_app
