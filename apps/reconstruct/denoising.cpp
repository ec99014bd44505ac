// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/denoising.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/reconstruct/quadratic_patch.h"
#include "core/errors.h"
#include "core/parallel.h"
#include "surface/triangle.h"

namespace dsc::reconstruct {

namespace {

struct Sample {
    Point3 point;
    Vector3 normal;
};

class Denoising {
public:
    Denoising(std::span<const Point3> points, double noise, const DenoisingParameters& parameters)
        : points_(points),
          tree_(points),
          noise_(noise),
          parameters_(parameters),
          side_cosine_(std::cos(surface::radians(parameters.side_angle))) {}

    // The widest patch at a point whose height agrees with those of all narrower ones.
    Sample best_patch(std::size_t i, std::span<const Vector3> normals) const {
        std::vector<KdTree::Neighbour> near;
        tree_.nearest(points_[i], static_cast<std::size_t>(parameters_.most_points), near);
        const Vector3& n = normals[i];
        Sample best{points_[i], n};
        double least = -std::numeric_limits<double>::infinity(), most = -least;
        for (double wanted = parameters_.least_points;; wanted *= parameters_.growth) {
            const std::size_t count = std::min(near.size(), static_cast<std::size_t>(wanted));
            QuadraticPatch patch(points_[i], n, std::sqrt(near[count - 1].squared_distance));
            for (const KdTree::Neighbour& neighbour : std::span(near).first(count))
                if (normals[neighbour.index].dot(n) > side_cosine_) patch.add(points_[neighbour.index]);
            constexpr int enough = 9;
            if (patch.points() >= enough) {
                patch.stiffen(1e-4, 1e-4);
                patch.solve();
                const double height = (patch.point() - points_[i]).dot(n);
                const double error = parameters_.confidence * noise_ * patch.standard_error();
                least = std::max(least, height - error);
                most = std::min(most, height + error);
                if (least > most) break;
                best = {patch.point(), patch.normal()};
            }
            if (count == near.size()) break;
        }
        return best;
    }

private:
    std::span<const Point3> points_;
    KdTree tree_;
    double noise_;
    const DenoisingParameters& parameters_;
    double side_cosine_;
};

}  // namespace

void DenoisingParameters::validate() const {
    if (!(noticeable_noise >= 0)) throw core::UsageError("noticeable_noise: has to be at least 0");
    if (least_points < 9) throw core::UsageError("least_points: has to be at least 9");
    if (most_points < least_points) throw core::UsageError("most_points: has to be at least least_points");
    if (!(growth > 1)) throw core::UsageError("growth: has to be above 1");
    if (!(confidence > 0)) throw core::UsageError("confidence: has to be positive");
    if (!(side_angle > 0 && side_angle < 90)) throw core::UsageError("side_angle: has to be in (0, 90)");
    if (rounds < 0) throw core::UsageError("rounds: has to be at least 0");
    if (!(share_left >= 0 && share_left < 1)) throw core::UsageError("share_left: has to be in [0, 1)");
}

double denoise(Cloud& cloud, std::vector<Vector3>& normals, double noise, const DenoisingParameters& parameters) {
    parameters.validate();
    if (noise <= parameters.noticeable_noise * cloud.median_spacing || parameters.rounds == 0) return noise;
    const std::vector<Point3> measured = cloud.points;
    const Denoising denoising(measured, noise, parameters);
    for (int round = 0; round < parameters.rounds; ++round) {
        std::vector<Vector3> next(normals.size());
        core::parallel_for(measured.size(), {.threads = cloud.threads}, [&](std::size_t i) {
            const Sample sample = denoising.best_patch(i, normals);
            cloud.points[i] = sample.point;
            next[i] = sample.normal;
        });
        normals.swap(next);
    }
    return parameters.share_left * noise;
}

}  // namespace dsc::reconstruct
