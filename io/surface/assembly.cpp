// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/assembly.h"

#include <algorithm>
#include <utility>

#include "core/errors.h"

namespace dsc::io::surface {

SurfaceAssembly::Problem SurfaceAssembly::problem_of(std::span<const std::int64_t> numbers) const {
    if (numbers.size() < 3) return {"a face has fewer than 3 vertices", "remove it"};
    for (const std::int64_t number : numbers) {
        if (has_vertex(number)) continue;
        if (vertex_count() == 0) return {"a face comes before all vertices", "put the vertices first"};
        const auto last = first_number_ + static_cast<std::int64_t>(vertex_count()) - 1;
        return {"vertex " + std::to_string(number) + " does not exist",
                "use " + std::to_string(first_number_) + " to " + std::to_string(last)};
    }
    return {"a face has the same vertex twice", "correct or remove it"};
}

geometry::SurfaceData SurfaceAssembly::finish() {
    if (data_.triangles.empty()) {
        throw core::InputError(source_, "", "contains no faces", "give a surface, not points");
    }
    if (std::ranges::all_of(data_.labels, [](int label) { return label == 0; })) data_.labels = {};
    return std::move(data_);
}

}  // namespace dsc::io::surface
