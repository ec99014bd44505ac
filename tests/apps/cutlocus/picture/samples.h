// SPDX-License-Identifier: GPL-3.0-or-later
// Cut loci that the tests of the pictures share, computed once.
#pragma once

#include <numbers>

#include "apps/cutlocus/cutlocus.h"
#include "geodesic/expression_metric.h"
#include "geodesic/torus.h"

namespace dsc::tests {

struct PictureSample {
    const geodesic::Metric& metric;
    geodesic::Point2 p;
    cutlocus::CutLocus locus;
};

inline cutlocus::CutLocus sample_locus(const geodesic::Metric& metric, const geodesic::Point2& p) {
    core::Observer silent;
    cutlocus::CutLocusParameters parameters;
    parameters.front_spacing = 0.02;
    parameters.snapshots = 12;
    return cut_locus(metric, p, parameters, silent);
}

/// Vertices of every degree; neither an arc nor p lies on a seam of the chart around (0, 0).
inline const PictureSample& torus_sample() {
    static const geodesic::TorusOfRevolution torus(2, 2);
    static const geodesic::Point2 p(0.7, 0.15 * std::numbers::pi);
    static const PictureSample sample{torus, p, sample_locus(torus, p)};
    return sample;
}

/// The opposite meridian and the inner equator lie on the seams.
inline const PictureSample& seam_sample() {
    static const geodesic::TorusOfRevolution torus(2, 1);
    static const PictureSample sample{torus, {0, 0}, sample_locus(torus, {0, 0})};
    return sample;
}

/// A metric without an embedding.
inline const PictureSample& flat_sample() {
    static const geodesic::ExpressionMetric flat("E=1; F=0.5; G=1", {1.0, 1.0});
    static const geodesic::Point2 p(0.1, 0.2);
    static const PictureSample sample{flat, p, sample_locus(flat, p)};
    return sample;
}

}  // namespace dsc::tests
