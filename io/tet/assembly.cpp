// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tet/assembly.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "core/errors.h"

namespace dsc::io::tet {

namespace {

// In units of the extent of the tetrahedra: neither very large nor very small coordinates leave the range of double.
double total_signed_volume(const geometry::TetData& data) {
    Eigen::AlignedBox3d box;
    for (const auto& tet : data.tets) {
        for (const std::uint32_t vertex : tet) box.extend(data.vertices[vertex]);
    }
    const double unit = 1 / box.sizes().maxCoeff();
    double sum = 0;
    for (const auto& tet : data.tets) {
        const Eigen::Vector3d& a = data.vertices[tet[0]];
        const Eigen::Vector3d b = (data.vertices[tet[1]] - a) * unit;
        const Eigen::Vector3d c = (data.vertices[tet[2]] - a) * unit;
        const Eigen::Vector3d d = (data.vertices[tet[3]] - a) * unit;
        sum += b.cross(c).dot(d);
    }
    return sum;
}

}  // namespace

void turn(geometry::TetData& data) {
    for (auto& tet : data.tets) std::swap(tet[2], tet[3]);
}

void TetAssembly::reserve_tets(std::size_t count) {
    data_.tets.reserve(count);
    data_.labels.reserve(count);
}

TetAssembly::Problem TetAssembly::problem_of(const std::array<std::int64_t, 4>& numbers, std::int64_t label) const {
    for (const std::int64_t number : numbers) {
        if (has_vertex(number)) continue;
        const auto last = first_number_ + static_cast<std::int64_t>(vertex_count()) - 1;
        return {"vertex " + std::to_string(number) + " does not exist",
                "use " + std::to_string(first_number_) + " to " + std::to_string(last)};
    }
    if (!are_different(numbers)) {
        return {"the tetrahedron has the same vertex twice", "correct or remove it"};
    }
    return {"the label " + std::to_string(label) + " is too large", "use labels of at most 31 bits"};
}

geometry::TetData TetAssembly::finish() {
    if (data_.tets.empty()) {
        throw core::InputError(source_, "", "contains no tetrahedra", "give a volume mesh, not a surface");
    }
    if (std::all_of(data_.labels.begin(), data_.labels.end(), [](int label) { return label == 0; })) {
        data_.labels = {};
    }
    if (total_signed_volume(data_) < 0) turn(data_);
    return std::move(data_);
}

}  // namespace dsc::io::tet
