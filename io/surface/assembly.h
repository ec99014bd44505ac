// SPDX-License-Identifier: GPL-3.0-or-later
// Where every reader of surfaces puts what it finds: the checks that all formats share.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "geometry/surface_data.h"

namespace dsc::io::surface {

class SurfaceAssembly {
public:
    /// `first_number` is the number of the first vertex in the file.
    SurfaceAssembly(std::string source, std::int64_t first_number)
        : source_(std::move(source)), first_number_(first_number) {}

    void reserve_vertices(std::size_t count) { data_.vertices.reserve(count); }
    void reserve_triangles(std::size_t count) { data_.triangles.reserve(count); }

    std::size_t vertex_count() const { return data_.vertices.size(); }
    void add_vertex(double x, double y, double z) { data_.vertices.emplace_back(x, y, z); }

    /// Adds the polygon of the vertices with these numbers, as triangles; calls `reject(problem, cure)`, which has to
    /// throw, when there can't be such a one.
    template <class Reject>
    void add_polygon(std::span<const std::int64_t> numbers, const Reject& reject) {
        if (!is_polygon(numbers)) {
            const Problem problem = problem_of(numbers);
            reject(problem.what, problem.cure);
        }
        for (std::size_t k = 2; k < numbers.size(); ++k) {
            data_.triangles.push_back({index(numbers[0]), index(numbers[k - 1]), index(numbers[k])});
        }
    }
    template <class Reject>
    void add_polygon(std::span<const std::int64_t> numbers, std::int64_t label, const Reject& reject) {
        if (label != static_cast<int>(label)) {
            reject("the label " + std::to_string(label) + " is too large", "use labels of at most 31 bits");
        }
        add_polygon(numbers, reject);
        data_.labels.resize(data_.triangles.size(), static_cast<int>(label));
    }

    /// The whole; throws core::InputError when there is no triangle.
    geometry::SurfaceData finish();

private:
    struct Problem {
        std::string what;
        std::string cure;
    };

    bool has_vertex(std::int64_t number) const {
        return number >= first_number_ && static_cast<std::uint64_t>(number - first_number_) < vertex_count();
    }
    bool is_polygon(std::span<const std::int64_t> numbers) const {
        bool is_good = numbers.size() >= 3;
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            is_good = is_good && has_vertex(numbers[k]) && (k == 0 || numbers[k] != numbers[0]) &&
                      (k < 2 || numbers[k] != numbers[k - 1]);
        }
        return is_good;
    }
    Problem problem_of(std::span<const std::int64_t> numbers) const;
    std::uint32_t index(std::int64_t number) const { return static_cast<std::uint32_t>(number - first_number_); }

    std::string source_;
    std::int64_t first_number_;
    geometry::SurfaceData data_;
};

}  // namespace dsc::io::surface
