// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/generate/structured.h"

#include "core/errors.h"

namespace dsc::dsc2d {

Complex structured_complex(const Domain& domain, int columns, int rows) {
    if (columns < (domain.is_periodic(0) ? 3 : 1) || rows < (domain.is_periodic(1) ? 3 : 1))
        throw core::UsageError("structured complex: needs at least 1 cell in each direction, 3 in a periodic one");
    const int width = domain.is_periodic(0) ? columns : columns + 1;
    const int height = domain.is_periodic(1) ? rows : rows + 1;

    std::vector<Point2> points;
    points.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            // The far sides are sums of grid points, not products, so that they are straight to the last bit.
            points.push_back(domain.origin() +
                             (i == columns ? Point2(domain.basis().col(0))
                                           : domain.snapped(domain.basis().col(0) * (static_cast<double>(i) / columns))) +
                             (j == rows ? Point2(domain.basis().col(1))
                                        : domain.snapped(domain.basis().col(1) * (static_cast<double>(j) / rows))));

    std::vector<TriangleInput> triangles;
    triangles.reserve(2 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const auto add = [&](std::array<std::array<int, 2>, 3> corners) {
        TriangleInput triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [i, j] = corners[k];
            triangle.vertices[k] = static_cast<std::uint32_t>(i % width + width * (j % height));
            triangle.cells[k] = {i / width, j / height};
        }
        triangles.push_back(triangle);
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            // Alternating diagonals favour no direction.
            if ((i + j) % 2 == 0) {
                add({{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
                add({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
            } else {
                add({{{i, j}, {i + 1, j}, {i, j + 1}}});
                add({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
            }
        }
    return Complex(domain, points, triangles);
}

}  // namespace dsc::dsc2d
