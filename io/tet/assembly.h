// SPDX-License-Identifier: GPL-3.0-or-later
// Where every reader puts what it finds: the checks and the conventions that all formats share.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "geometry/tet_data.h"

namespace dsc::io::tet {

/// Exchanges the last two vertices of every tetrahedron, which turns its sign.
void turn(geometry::TetData& data);

class TetAssembly {
public:
    /// `first_number` is the number of the first vertex in the file.
    TetAssembly(std::string source, std::int64_t first_number)
        : source_(std::move(source)), first_number_(first_number) {}

    void reserve_vertices(std::size_t count) { data_.vertices.reserve(count); }
    void reserve_tets(std::size_t count);

    std::size_t vertex_count() const { return data_.vertices.size(); }
    void add_vertex(double x, double y, double z) { data_.vertices.emplace_back(x, y, z); }

    /// Adds the tetrahedron of the vertices with these numbers; calls `reject(problem, cure)`, which has to throw, when
    /// there can't be such a one.
    template <class Reject>
    void add_tet(const std::array<std::int64_t, 4>& numbers, std::int64_t label, const Reject& reject) {
        if (!has_vertices(numbers) || !are_different(numbers) || !is_label(label)) {
            const Problem problem = problem_of(numbers, label);
            reject(problem.what, problem.cure);
        }
        std::array<std::uint32_t, 4>& tet = data_.tets.emplace_back();
        for (std::size_t k = 0; k < 4; ++k) tet[k] = static_cast<std::uint32_t>(numbers[k] - first_number_);
        data_.labels.push_back(static_cast<int>(label));
    }

    /// The whole, turned to positive volume; throws core::InputError when there is no tetrahedron.
    geometry::TetData finish();

private:
    struct Problem {
        std::string what;
        std::string cure;
    };

    bool has_vertex(std::int64_t number) const {
        return number >= first_number_ && static_cast<std::uint64_t>(number - first_number_) < vertex_count();
    }
    bool has_vertices(const std::array<std::int64_t, 4>& n) const {
        return has_vertex(n[0]) && has_vertex(n[1]) && has_vertex(n[2]) && has_vertex(n[3]);
    }
    static bool are_different(const std::array<std::int64_t, 4>& n) {
        return n[0] != n[1] && n[0] != n[2] && n[0] != n[3] && n[1] != n[2] && n[1] != n[3] && n[2] != n[3];
    }
    static bool is_label(std::int64_t label) { return label == static_cast<int>(label); }
    Problem problem_of(const std::array<std::int64_t, 4>& numbers, std::int64_t label) const;

    std::string source_;
    std::int64_t first_number_;
    geometry::TetData data_;
};

}  // namespace dsc::io::tet
