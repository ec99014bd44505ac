// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of numbers on the command line: "0.5,0.5,1".
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace dsc::apps {

/// Throws core::UsageError, naming the option, unless the text is a list of finite numbers.
std::vector<double> parsed_numbers(const std::string& option, const std::string& text);

/// The same for a point: as many numbers as it has coordinates, 2 or 3.
template <int Dimension>
Eigen::Matrix<double, Dimension, 1> parsed_point(const std::string& option, const std::string& text);

}  // namespace dsc::apps
