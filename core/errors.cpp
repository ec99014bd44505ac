// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/errors.h"

#include <cstdio>
#include <cstdlib>

#include "core/assert.h"

namespace dsc::core {

namespace {

std::string one_line(const std::string& source, const std::string& place, const std::string& problem,
                     const std::string& cure) {
    std::string line = source;
    if (!place.empty()) line += ": " + place;
    line += ": " + problem;
    if (!cure.empty()) line += "; " + cure;
    return line;
}

}  // namespace

InputError::InputError(std::string source, std::string place, std::string problem, std::string cure)
    : Error(one_line(source, place, problem, cure)), source_(std::move(source)), place_(std::move(place)) {}

#if !defined(NDEBUG) || defined(DSC_CHECKED)
void assertion_failed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: assertion failed: %s\n", file, line, condition);
    std::abort();
}
#endif

}  // namespace dsc::core
