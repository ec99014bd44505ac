// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/improve/indicators.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dsc::dsc3d {

namespace {

constexpr std::array<double, 7> threshold_degrees = {1, 5, 10, 15, 25, 35, 45};

}  // namespace

QualityIndicators::QualityIndicators(const RatedMesh& mesh) : worst(std::numeric_limits<double>::infinity()) {
    std::array<double, 7> threshold;
    for (std::size_t k = 0; k < threshold.size(); ++k)
        threshold[k] = std::sin(threshold_degrees[k] * std::numbers::pi / 180);
    for (std::uint32_t i = 0; i < mesh.complex().tet_capacity(); ++i) {
        if (mesh.complex().is_deleted(TetId(i))) continue;
        const double quality = mesh.quality(TetId(i));
        worst = std::min(worst, quality);
        for (std::size_t k = 0; k < threshold.size(); ++k) means[k] += std::min(quality, threshold[k]);
    }
    for (double& mean : means) mean /= static_cast<double>(mesh.complex().tet_count());
}

bool QualityIndicators::is_better_than(const QualityIndicators& before, double least_gain) const {
    if (worst >= before.worst + least_gain) return true;
    for (std::size_t k = 0; k < means.size(); ++k)
        if (means[k] >= before.means[k] + least_gain) return true;
    return false;
}

void QualityIndicators::raise_to(const QualityIndicators& other) {
    worst = std::max(worst, other.worst);
    for (std::size_t k = 0; k < means.size(); ++k) means[k] = std::max(means[k], other.means[k]);
}

}  // namespace dsc::dsc3d
