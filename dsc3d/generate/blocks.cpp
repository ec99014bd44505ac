// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/errors.h"

namespace dsc::dsc3d {

using geometry::InterfaceData;

namespace {

constexpr double max_nodes = 1e8;

using Index = std::array<std::uint32_t, 3>;
using Planes = std::array<std::vector<double>, 3>;

// A grid of boxes between planes, each of one label; what it gives is the interface between the labels.
class Grid {
public:
    Grid(const char* shape, double edge_length) : shape_(shape), edge_length_(edge_length) {
        if (!(edge_length > 0) || !std::isfinite(edge_length)) fail("the edge length has to be positive");
    }

    [[noreturn]] void fail(const std::string& what) const { throw core::UsageError(std::string(shape_) + ": " + what); }

    /// Planes at `places`, and between each two of them as many as the edge length asks for.
    void divide(std::size_t axis, const std::vector<double>& places) {
        std::vector<double>& planes = planes_[axis];
        planes = {places.front()};
        for (std::size_t i = 1; i < places.size(); ++i) {
            const double low = places[i - 1], length = places[i] - low;
            if (!(length > 0) || !std::isfinite(length)) fail("its sizes have to be positive and fit together");
            const double parts = std::max(1.0, std::round(length / edge_length_));
            if (parts > max_nodes) fail("the edge length is too small");
            for (double k = 1; k < parts; ++k) planes.push_back(low + k / parts * length);
            planes.push_back(places[i]);
        }
    }

    /// `label`: of the box that holds the point; outside the grid it is 0.
    InterfaceData interface(const std::function<int(const Point3&)>& label) {
        double nodes = 1;
        for (const std::vector<double>& planes : planes_) nodes *= static_cast<double>(planes.size());
        if (nodes > max_nodes) fail("the edge length is too small");
        for (std::size_t axis = 0; axis < 3; ++axis) add_faces_across(axis, label);
        return std::move(data_);
    }

private:
    std::uint32_t cells(std::size_t axis) const { return static_cast<std::uint32_t>(planes_[axis].size() - 1); }

    void add_faces_across(std::size_t axis, const std::function<int(const Point3&)>& label) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto label_of = [&](const Index& cell) {
            Point3 middle;
            for (std::size_t k = 0; k < 3; ++k) {
                if (cell[k] >= cells(k)) return 0;
                middle[static_cast<Eigen::Index>(k)] = (planes_[k][cell[k]] + planes_[k][cell[k] + 1]) / 2;
            }
            return label(middle);
        };
        Index i;
        for (i[axis] = 0; i[axis] <= cells(axis); ++i[axis])
            for (i[v] = 0; i[v] < cells(v); ++i[v])
                for (i[u] = 0; i[u] < cells(u); ++i[u]) {
                    Index below = i;
                    --below[axis];
                    add_rectangle(i, u, v, label_of(below), label_of(i));
                }
    }

    // Normals point to the side of the lower label.
    void add_rectangle(Index at, std::size_t u, std::size_t v, int below, int above) {
        if (below == above) return;
        std::array<std::uint32_t, 4> corner;
        const bool is_even = (at[0] + at[1] + at[2]) % 2 == 0;
        corner[0] = node(at), ++at[u];
        corner[1] = node(at), ++at[v];
        corner[2] = node(at), --at[u];
        corner[3] = node(at);
        // Counterclockwise seen from above, the diagonal from the first one.
        if (!is_even) std::rotate(corner.begin(), corner.begin() + 1, corner.end());
        if (above > below) std::swap(corner[1], corner[3]);
        for (std::size_t k = 1; k < 3; ++k) {
            data_.surface.triangles.push_back({corner[0], corner[k], corner[k + 1]});
            data_.sides.push_back({std::min(below, above), std::max(below, above)});
        }
    }

    std::uint32_t node(const Index& i) {
        const std::uint64_t key =
            (static_cast<std::uint64_t>(i[2]) * planes_[1].size() + i[1]) * planes_[0].size() + i[0];
        const auto [place, is_new] = nodes_.try_emplace(key, static_cast<std::uint32_t>(data_.surface.vertices.size()));
        if (is_new) data_.surface.vertices.emplace_back(planes_[0][i[0]], planes_[1][i[1]], planes_[2][i[2]]);
        return place->second;
    }

    const char* shape_;
    double edge_length_;
    Planes planes_;
    InterfaceData data_;
    std::unordered_map<std::uint64_t, std::uint32_t> nodes_;
};

}  // namespace

geometry::SurfaceData box_surface(const Eigen::AlignedBox3d& box, double edge_length) {
    Grid grid("box", edge_length);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        grid.divide(axis, {box.min()[k], box.max()[k]});
    }
    return grid.interface([](const Point3&) { return 1; }).surface;
}

geometry::SurfaceData slotted_cube(const Point3& centre, const SlottedCubeSize& size, double edge_length) {
    Grid grid("slotted-cube", edge_length);
    const double half = size.side / 2, slot = size.slot_width / 2;
    const double bottom = centre.z() + half - size.slot_depth;
    grid.divide(0, {centre.x() - half, centre.x() - slot, centre.x() + slot, centre.x() + half});
    grid.divide(1, {centre.y() - half, centre.y() + half});
    grid.divide(2, {centre.z() - half, bottom, centre.z() + half});
    return grid
        .interface([&](const Point3& p) { return std::abs(p.x() - centre.x()) < slot && p.z() > bottom ? 0 : 1; })
        .surface;
}

InterfaceData labelled_block(const Eigen::AlignedBox3d& box, double edge_length) {
    Grid grid("labelled-block", edge_length);
    const Point3 centre = box.center();
    grid.divide(0, {box.min().x(), centre.x(), box.max().x()});
    grid.divide(1, {box.min().y(), box.max().y()});
    grid.divide(2, {box.min().z(), centre.z(), box.max().z()});
    return grid.interface([&](const Point3& p) { return p.x() < centre.x() ? 1 : p.z() < centre.z() ? 2 : 3; });
}

}  // namespace dsc::dsc3d
