// SPDX-License-Identifier: GPL-3.0-or-later
// Is it a metric, and does it have the periods it claims? To be asked once about a metric from outside.
// Guarantee: finds values that are not finite, a tensor that is not positive definite, and a wrong period, wherever
// they are wider than the grid spacing; narrow zeros of the determinant are searched for downhill from the grid. Cost:
// grid² + some thousand evaluations of the tensor, 256 of the local geometry per period; milliseconds.
#pragma once

#include <string_view>

#include "geodesic/metric.h"

namespace dsc::geodesic {

struct MetricCheckParameters {
    int grid = 64;                   ///< points per direction, >= 2
    Point2 center{0, 0};             ///< middle of the checked strip in a direction without a period
    double reach = 1;                ///< half the width of that strip
    double period_tolerance = 1e-9;  ///< allowed relative change of the tensor, Christoffel symbols and K over a period
};

/// Throws core::InputError that names `source` (an option, a file), the place (u, v) and what is wrong there.
void check_metric(const Metric& metric, std::string_view source, const MetricCheckParameters& parameters = {});

}  // namespace dsc::geodesic
