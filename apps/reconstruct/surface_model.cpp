// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/surface_model.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "apps/reconstruct/quadratic_patch.h"
#include "core/errors.h"
#include "surface/triangle.h"

namespace dsc::reconstruct {

void SurfaceModelParameters::validate() const {
    if (points < 6) throw core::UsageError("points: has to be at least 6");
    if (patch_points < 6 || patch_points > points)
        throw core::UsageError("patch_points: has to be at least 6 and at most points");
    if (!(side_angle > 0 && side_angle < 90)) throw core::UsageError("side_angle: has to be in (0, 90)");
    if (!(crease_angle > 0 && crease_angle < 90)) throw core::UsageError("crease_angle: has to be in (0, 90)");
    if (!(most_standard_error > 0)) throw core::UsageError("most_standard_error: has to be positive");
    if (least_side_points < 3) throw core::UsageError("least_side_points: has to be at least 3");
}

SurfaceModel::SurfaceModel(const Cloud& cloud, const KdTree& tree, std::span<const Vector3> normals, double noise,
                           const SurfaceModelParameters& parameters)
    : cloud_(cloud),
      tree_(tree),
      normals_(normals),
      noise_(noise),
      parameters_(parameters),
      side_cosine_(std::cos(surface::radians(parameters.side_angle))) {
    parameters.validate();
}

// The patch of the points of the side, over the plane through x and then over its own tangent plane; nearly a plane
// when the points are few.
SurfaceModel::Sample SurfaceModel::fitted(Near near, const Point3& x, const Vector3& normal) const {
    constexpr int enough_for_quadratic = 9;
    constexpr double plane_stiffness = 50;
    Sample sample{x, normal, 0};
    const double reach = std::sqrt(near.back().squared_distance);
    for (int step = 0; step < 2; ++step) {
        QuadraticPatch patch(sample.point, sample.normal, reach);
        for (const KdTree::Neighbour& neighbour : near)
            if (normals_[neighbour.index].dot(sample.normal) >= side_cosine_) patch.add(cloud_.points[neighbour.index]);
        sample.points = patch.points();
        if (sample.points < 3) return sample;
        patch.stiffen(1e-4, sample.points < enough_for_quadratic ? plane_stiffness : 5e-5 + 0.025 * noise_ / reach);
        patch.solve();
        // Next to a place without points a patch may be anywhere; a plane is not.
        if (patch.standard_error() > parameters_.most_standard_error) {
            patch.stiffen(0, plane_stiffness);
            patch.solve();
        }
        sample.point = patch.point();
        sample.normal = patch.normal();
    }
    return sample;
}

std::optional<SurfacePlace> SurfaceModel::smooth_place(const Point3& x, const Vector3& normal) const {
    std::vector<KdTree::Neighbour> near;
    tree_.nearest(x, static_cast<std::size_t>(parameters_.patch_points), near);
    const Sample sample = fitted(near, x, normal);
    if (sample.points < parameters_.least_side_points) return std::nullopt;
    return SurfacePlace{sample.point, {sample.normal}, 1};
}

// Groups of normals, that of the nearest point first.
std::vector<Vector3> SurfaceModel::side_normals(Near near) const {
    std::vector<Vector3> sides;
    std::vector<std::uint32_t> rest;
    for (const KdTree::Neighbour& neighbour : near) rest.push_back(neighbour.index);
    while (!rest.empty()) {
        Vector3 mean = normals_[rest.front()];
        for (int round = 0; round < 2; ++round) {
            Vector3 sum = Vector3::Zero();
            for (const std::uint32_t i : rest)
                if (normals_[i].dot(mean) > side_cosine_) sum += normals_[i];
            if (sum.squaredNorm() > 0) mean = sum.normalized();
        }
        const std::size_t before = rest.size();
        const std::uint32_t first = rest.front();
        std::erase_if(rest, [&](std::uint32_t i) { return i == first || normals_[i].dot(mean) > side_cosine_; });
        if (before - rest.size() >= static_cast<std::size_t>(parameters_.least_side_points)) sides.push_back(mean);
    }
    return sides;
}

// The place near x where the patches with these normals meet: the least way to the intersection of their tangent
// planes, again and again. None when they don't, or meet so gently that they are one piece.
std::optional<SurfacePlace> SurfaceModel::meeting(Near near, const Point3& x, std::span<const Vector3> normals) const {
    SurfacePlace place{x, {}, static_cast<int>(normals.size())};
    std::array<Sample, 3> samples;
    for (std::size_t i = 0; i < normals.size(); ++i) samples[i].normal = normals[i];
    const double crease_cosine = std::cos(surface::radians(parameters_.crease_angle));
    constexpr int steps = 4;
    for (int step = 0; step < steps; ++step) {
        Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3> planes(static_cast<Eigen::Index>(normals.size()), 3);
        Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> heights(static_cast<Eigen::Index>(normals.size()));
        for (std::size_t i = 0; i < normals.size(); ++i) {
            samples[i] = fitted(near, place.point, samples[i].normal);
            if (samples[i].points < parameters_.least_side_points) return std::nullopt;
            planes.row(static_cast<Eigen::Index>(i)) = samples[i].normal.transpose();
            heights[static_cast<Eigen::Index>(i)] = (samples[i].point - place.point).dot(samples[i].normal);
        }
        for (std::size_t i = 0; i < normals.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (samples[i].normal.dot(samples[j].normal) > crease_cosine) return std::nullopt;
        const Eigen::JacobiSVD<Eigen::MatrixXd> solver(planes, Eigen::ComputeThinU | Eigen::ComputeThinV);
        // Three planes that meet in a line make no corner.
        if (solver.singularValues().minCoeff() < 0.2) return std::nullopt;
        place.point += solver.solve(heights);
    }
    for (std::size_t i = 0; i < normals.size(); ++i) place.normals[i] = samples[i].normal;
    return place;
}

SurfacePlace SurfaceModel::place(const Point3& x, double corner_reach, double crease_reach) const {
    std::vector<KdTree::Neighbour> near;
    tree_.nearest(x, static_cast<std::size_t>(parameters_.points), near);
    const std::vector<Vector3> sides = side_normals(near);
    const double far = 1.5 * cloud_.spacing[near.front().index] + 2 * noise_;
    std::optional<SurfacePlace> best;
    double least = corner_reach;
    const auto consider = [&](std::span<const Vector3> normals) {
        const std::optional<SurfacePlace> found = meeting(near, x, normals);
        if (!found) return;
        const double distance = (found->point - x).norm();
        if (distance > least || std::sqrt(tree_.nearest(found->point).squared_distance) > far) return;
        least = distance;
        best = found;
    };
    if (sides.size() >= 3) {
        for (std::size_t i = 0; i < sides.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                for (std::size_t k = 0; k < j; ++k) consider(std::array{sides[k], sides[j], sides[i]});
        if (best) return *best;
    }
    least = crease_reach;
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) consider(std::array{sides[j], sides[i]});
    if (best) return *best;
    const Vector3 normal = sides.empty() ? normals_[near.front().index] : sides.front();
    const std::size_t nearest = std::min(near.size(), static_cast<std::size_t>(parameters_.patch_points));
    const Sample sample = fitted(Near(near).first(nearest), x, normal);
    return {sample.point, {sample.normal}, 1};
}

}  // namespace dsc::reconstruct
