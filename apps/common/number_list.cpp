// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/common/number_list.h"

#include <algorithm>
#include <optional>

#include "core/errors.h"
#include "io/number.h"

namespace dsc::apps {

std::vector<double> parsed_numbers(const std::string& option, const std::string& text) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::optional<double> number = io::parse_finite(text.substr(begin, end - begin));
        if (!number) throw core::UsageError(option + ": \"" + text + "\" is not a list of finite numbers");
        numbers.push_back(*number);
        begin = end + 1;
    }
    return numbers;
}

template <int Dimension>
Eigen::Matrix<double, Dimension, 1> parsed_point(const std::string& option, const std::string& text) {
    const std::vector<double> numbers = parsed_numbers(option, text);
    if (numbers.size() != Dimension)
        throw core::UsageError(option + ": \"" + text + "\" is not " +
                               (Dimension == 2 ? "two numbers x,y" : "three numbers x,y,z"));
    return Eigen::Matrix<double, Dimension, 1>(numbers.data());
}

template Eigen::Matrix<double, 2, 1> parsed_point<2>(const std::string& option, const std::string& text);
template Eigen::Matrix<double, 3, 1> parsed_point<3>(const std::string& option, const std::string& text);

}  // namespace dsc::apps
