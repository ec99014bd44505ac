// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/normals.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/errors.h"
#include "core/parallel.h"
#include "surface/triangle.h"

namespace dsc::reconstruct {

namespace {

struct Plane {
    Point3 centre;
    Vector3 normal;
    double deviation;  ///< of its points, root of the mean square
};

class PlaneFit {
public:
    void add(const Point3& p, double weight) {
        weight_ += weight;
        sum_ += weight * p;
        squares_ += weight * p * p.transpose();
    }
    Plane plane() const {
        const Point3 centre = sum_ / weight_;
        const Eigen::Matrix3d moments = squares_ / weight_ - centre * centre.transpose();
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
        solver.computeDirect(moments);
        return {centre, solver.eigenvectors().col(0).normalized(), std::sqrt(std::max(0.0, solver.eigenvalues()[0]))};
    }

private:
    double weight_ = 0;
    Point3 sum_ = Point3::Zero();
    Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
};

// In coordinates around the point, where squares lose no digits.
std::vector<Plane> fitted_planes(const Cloud& cloud, std::size_t count) {
    std::vector<Plane> planes(cloud.size());
    core::parallel_for(cloud.size(), {.threads = cloud.threads}, [&](std::size_t i) {
        PlaneFit fit;
        fit.add(Point3::Zero(), 1);
        for (const std::uint32_t j : cloud.neighbours_of(i).first(count)) fit.add(cloud.points[j] - cloud.points[i], 1);
        planes[i] = fit.plane();
        planes[i].centre += cloud.points[i];
    });
    return planes;
}

// Of the points of a plane, as an unbiased estimate.
double median_variance(const std::vector<Plane>& planes, std::size_t neighbours) {
    std::vector<double> values;
    values.reserve(planes.size());
    for (const Plane& plane : planes) values.push_back(plane.deviation * plane.deviation);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    const double points = static_cast<double>(neighbours) + 1;
    return values[values.size() / 2] * points / std::max(1.0, points - 3);
}

}  // namespace

void NormalParameters::validate() const {
    if (!(agreement > 0 && agreement < 90)) throw core::UsageError("agreement: has to be in (0, 90)");
    if (plane_points < 4) throw core::UsageError("plane_points: has to be at least 4");
    if (!(noticeable_noise >= 0)) throw core::UsageError("noticeable_noise: has to be at least 0");
    if (rounds < 0) throw core::UsageError("rounds: has to be at least 0");
}

double estimated_noise(const Cloud& cloud) {
    const std::size_t many = std::min<std::size_t>(24, cloud.neighbour_count), few = many / 2;
    if (few < 4) return 0;
    const double variance_of_few = median_variance(fitted_planes(cloud, few), few);
    const double variance_of_many = median_variance(fitted_planes(cloud, many), many);
    // Curvature makes the square of the deviation four times as large for twice as many neighbours.
    return std::sqrt(std::max(0.0, (4 * variance_of_few - variance_of_many) / 3));
}

std::vector<Vector3> cloud_axes(const Cloud& cloud, double noise, const NormalParameters& parameters) {
    parameters.validate();
    const std::size_t n = cloud.size();
    const std::size_t few = std::min<std::size_t>(parameters.plane_points, cloud.neighbour_count);
    const bool is_noisy = noise > parameters.noticeable_noise * cloud.median_spacing;
    const std::vector<Plane> planes = fitted_planes(cloud, is_noisy ? cloud.neighbour_count : few);

    std::vector<Vector3> axes(n);
    core::parallel_for(n, {.threads = cloud.threads}, [&](std::size_t i) {
        double best = std::numeric_limits<double>::infinity();
        const auto consider = [&](std::size_t j) {
            const Plane& plane = planes[j];
            const double offset = (cloud.points[i] - plane.centre).dot(plane.normal);
            const double score = plane.deviation * plane.deviation + offset * offset;
            if (score >= best) return;
            best = score;
            axes[i] = plane.normal;
        };
        consider(i);
        for (const std::uint32_t j : cloud.neighbours_of(i)) consider(j);
    });

    const double least_cosine = std::cos(surface::radians(parameters.agreement));
    for (int round = 0; round < parameters.rounds; ++round) {
        std::vector<Vector3> next(n);
        core::parallel_for(n, {.threads = cloud.threads}, [&](std::size_t i) {
            const double tolerance = 3 * noise + 0.3 * cloud.spacing[i];
            PlaneFit fit;
            fit.add(Point3::Zero(), 1);
            int agreeing = 0;
            for (const std::uint32_t j : cloud.neighbours_of(i)) {
                const double cosine = std::abs(axes[i].dot(axes[j]));
                if (cosine < least_cosine) continue;
                const Vector3 way = cloud.points[j] - cloud.points[i];
                const double offset = std::abs(way.dot(axes[i])) / (tolerance + 0.25 * way.norm());
                if (offset > 1) continue;
                const double similarity = (cosine - least_cosine) / (1 - least_cosine);
                fit.add(way, similarity * (1 - offset * offset));
                ++agreeing;
            }
            next[i] = agreeing >= 3 ? fit.plane().normal : axes[i];
        });
        axes.swap(next);
    }
    return axes;
}

}  // namespace dsc::reconstruct
