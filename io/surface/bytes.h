// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in the bytes of a file, of either byte order.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

namespace dsc::io::surface {

/// The number that begins at `bytes`.
template <class Number>
Number number_at(const char* bytes, std::endian order) {
    char image[sizeof(Number)];
    std::memcpy(image, bytes, sizeof image);
    if (order != std::endian::native) std::reverse(image, image + sizeof image);
    Number number;
    std::memcpy(&number, image, sizeof image);
    return number;
}

/// Appends the number in little endian.
template <class Number>
void append_bytes(std::string& bytes, Number number) {
    char image[sizeof(Number)];
    std::memcpy(image, &number, sizeof image);
    if constexpr (std::endian::native == std::endian::big) std::reverse(image, image + sizeof image);
    bytes.append(image, sizeof image);
}

}  // namespace dsc::io::surface
