// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/free_coordinates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace dsc::fluid {

namespace {

constexpr double least_independence = 1e-3;  // sine of the angle between normals that count as two

// An orthonormal frame whose first `fixed` columns span the normals seen so far.
template <int Dimension>
struct Frame {
    Eigen::Matrix<double, Dimension, Dimension> axes = Eigen::Matrix<double, Dimension, Dimension>::Zero();
    Vector<Dimension> speeds = Vector<Dimension>::Zero();
    int fixed = 0;

    void fix(const Vector<Dimension>& normal, double speed) {
        Vector<Dimension> rest = normal;
        for (int k = 0; k < fixed; ++k) {
            const double along = axes.col(k).dot(normal);
            rest -= along * axes.col(k);
            speed -= along * speeds[k];
        }
        const double independence = rest.norm();
        if (independence < least_independence) return;
        axes.col(fixed) = rest / independence;
        speeds[fixed++] = speed / independence;
    }
    // The coordinate axes that are farthest from what is there already.
    void complete() {
        for (int k = fixed; k < Dimension; ++k) {
            Vector<Dimension> best = Vector<Dimension>::Zero();
            for (int axis = 0; axis < Dimension; ++axis) {
                Vector<Dimension> rest = Vector<Dimension>::Unit(axis);
                for (int l = 0; l < k; ++l) rest -= axes(axis, l) * axes.col(l);
                if (rest.squaredNorm() > best.squaredNorm() + 1e-9) best = rest;
            }
            axes.col(k) = best.normalized();
        }
    }
};

}  // namespace

template <int Dimension>
FreeCoordinates free_coordinates(std::size_t vertex_count, std::span<const WallContact<Dimension>> contacts) {
    std::vector<std::size_t> order(contacts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return contacts[a].vertex < contacts[b].vertex; });
    FreeCoordinates result;
    const auto size = static_cast<Eigen::Index>(vertex_count) * Dimension;
    result.constrained = Eigen::VectorXd::Zero(size);
    std::vector<Eigen::Triplet<double, int>> entries;
    auto next = order.begin();
    for (std::uint32_t v = 0; v < vertex_count; ++v) {
        Frame<Dimension> frame;
        for (; next != order.end() && contacts[*next].vertex == v; ++next)
            frame.fix(contacts[*next].normal, contacts[*next].speed);
        frame.complete();
        for (int k = 0; k < Dimension; ++k) {
            if (k < frame.fixed) {
                result.constrained.template segment<Dimension>(Dimension * v) += frame.speeds[k] * frame.axes.col(k);
                continue;
            }
            const int column = static_cast<int>(result.vertex.size());
            for (int axis = 0; axis < Dimension; ++axis)
                if (frame.axes(axis, k) != 0)
                    entries.emplace_back(Dimension * static_cast<int>(v) + axis, column, frame.axes(axis, k));
            result.vertex.push_back(v);
        }
    }
    result.basis.resize(size, static_cast<Eigen::Index>(result.vertex.size()));
    result.basis.setFromTriplets(entries.begin(), entries.end());
    return result;
}

template FreeCoordinates free_coordinates(std::size_t, std::span<const WallContact<2>>);
template FreeCoordinates free_coordinates(std::size_t, std::span<const WallContact<3>>);

}  // namespace dsc::fluid
