// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/vessel.h"

#include <algorithm>

#include "core/errors.h"
#include "dsc3d/mesh.h"
#include "geometry/surface_check.h"

namespace dsc::dsc3d {

namespace {

/// Of the box around the vessel, in sizes of the vessel: room for tetrahedra that grow.
constexpr double margin = 0.2;

void require_vessel(const geometry::SurfaceData& vessel) {
    const geometry::SurfaceCheck check = geometry::check_surface(vessel);
    if (!check.is_closed() || !check.is_manifold() || !check.is_oriented() || !check.volume || !(*check.volume > 0))
        throw core::UsageError("the vessel has to be a closed manifold whose normals point outwards");
}

// Both surfaces, with a label of its own for what lies outside the vessel.
geometry::InterfaceData joined(const geometry::InterfaceData& interface, const geometry::SurfaceData& vessel,
                               int outside) {
    geometry::InterfaceData both = interface;
    const auto first = static_cast<std::uint32_t>(both.surface.vertices.size());
    both.surface.vertices.insert(both.surface.vertices.end(), vessel.vertices.begin(), vessel.vertices.end());
    for (const auto& [a, b, c] : vessel.triangles) {
        both.surface.triangles.push_back({first + a, first + b, first + c});
        both.sides.push_back({outside, 0});
    }
    return both;
}

}  // namespace

geometry::TetData tetrahedralize_within(const geometry::InterfaceData& interface, const geometry::SurfaceData& vessel,
                                        const TetrahedralizeParameters& parameters, core::Observer& observer) {
    require_vessel(vessel);
    if (interface.sides.size() != interface.surface.triangles.size())
        throw core::UsageError("the interface has not as many pairs of labels as triangles");
    int highest = 0;
    for (const auto& [front, back] : interface.sides) highest = std::max({highest, front, back});
    const int outside = highest + 1;
    Eigen::AlignedBox3d box;
    for (const Point3& p : vessel.vertices) box.extend(p);
    for (const Point3& p : interface.surface.vertices)
        if (!box.contains(p)) throw core::UsageError("the interface is not inside the vessel");
    const Eigen::Vector3d room = Eigen::Vector3d::Constant(margin * box.sizes().maxCoeff());
    const geometry::TetData all =
        tetrahedralize(joined(interface, vessel, outside), {box.min() - room, box.max() + room}, parameters, observer);

    geometry::TetData inside{.vertices = all.vertices};
    for (std::size_t i = 0; i < all.tets.size(); ++i) {
        if (all.labels[i] == outside) continue;
        inside.tets.push_back(all.tets[i]);
        inside.labels.push_back(all.labels[i]);
    }
    return Mesh(inside).data();
}

}  // namespace dsc::dsc3d
