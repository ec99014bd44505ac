// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/mesh.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "dsc3d/complex/validate.h"

namespace dsc::dsc3d {

namespace {

using geometry::Sign;
using geometry::TetData;

[[noreturn]] void reject_tet(const std::string& source, std::size_t tet, const std::string& problem,
                             const std::string& cure) {
    throw core::InputError(source, "tetrahedron " + std::to_string(tet) + " (counted from 0)", problem, cure);
}

void check_arrays(const TetData& data, const std::string& source) {
    if (data.tets.empty()) throw core::InputError(source, "", "there are no tetrahedra", "give at least one");
    if (!data.labels.empty() && data.labels.size() != data.tets.size())
        throw core::InputError(source, "", "there are not as many labels as tetrahedra", "give one each, or none");
    for (std::size_t i = 0; i < data.vertices.size(); ++i) {
        if (!data.vertices[i].allFinite())
            throw core::InputError(source, "vertex " + std::to_string(i) + " (counted from 0)",
                                   "a coordinate is not finite", "all have to be numbers");
        // Volumes have to stay within the range of a double.
        if (data.vertices[i].lpNorm<Eigen::Infinity>() > 1e100)
            throw core::InputError(source, "vertex " + std::to_string(i) + " (counted from 0)",
                                   "a coordinate exceeds 1e100", "use a larger unit of length");
    }
    for (std::size_t i = 0; i < data.tets.size(); ++i) {
        auto tet = data.tets[i];
        std::sort(tet.begin(), tet.end());
        if (tet[3] >= data.vertices.size())
            reject_tet(source, i, "vertex " + std::to_string(tet[3]) + " does not exist",
                       "there are " + std::to_string(data.vertices.size()) + " vertices");
        if (std::adjacent_find(tet.begin(), tet.end()) != tet.end())
            reject_tet(source, i, "a vertex occurs twice", "its four vertices have to differ");
    }
}

// True when all tetrahedra are mirrored. Flat ones, and some of either orientation, are an error.
bool is_mirrored(const TetData& data, const std::string& source) {
    const auto sign = [&](std::size_t i) {
        const auto& [a, b, c, d] = data.tets[i];
        return geometry::orientation(data.vertices[a], data.vertices[b], data.vertices[c], data.vertices[d]);
    };
    std::size_t negative = 0;
    for (std::size_t i = 0; i < data.tets.size(); ++i) {
        const Sign s = sign(i);
        if (s == Sign::zero) reject_tet(source, i, "it is flat", "its volume has to be positive");
        negative += s == Sign::negative ? 1 : 0;
    }
    if (negative == 0 || negative == data.tets.size()) return negative != 0;
    const Sign wrong = 2 * negative <= data.tets.size() ? Sign::negative : Sign::positive;
    std::size_t first = 0;
    while (sign(first) != wrong) ++first;
    reject_tet(source, first, "it is inverted against the other tetrahedra", "all have to have one orientation");
}

// The vertices in use, in their order.
std::vector<std::uint32_t> used_vertices(const TetData& data) {
    std::vector<std::uint8_t> is_used(data.vertices.size(), 0);
    for (const auto& tet : data.tets)
        for (const std::uint32_t v : tet) is_used[v] = 1;
    std::vector<std::uint32_t> used;
    for (std::uint32_t v = 0; v < is_used.size(); ++v)
        if (is_used[v] != 0) used.push_back(v);
    return used;
}

Complex make_complex(const TetData& data, const std::string& source) {
    check_arrays(data, source);
    const bool mirrored = is_mirrored(data, source);
    const std::vector<std::uint32_t> used = used_vertices(data);
    std::vector<std::uint32_t> number(data.vertices.size());
    for (std::uint32_t i = 0; i < used.size(); ++i) number[used[i]] = i;
    std::vector<NewTet> tets(data.tets.size());
    for (std::size_t i = 0; i < tets.size(); ++i) {
        for (std::size_t k = 0; k < 4; ++k) tets[i].vertices[k] = VertexId(number[data.tets[i][k]]);
        if (mirrored) std::swap(tets[i].vertices[2], tets[i].vertices[3]);
        tets[i].label = data.label(i);
    }
    return Complex(static_cast<std::uint32_t>(used.size()), tets, source);
}

}  // namespace

Mesh::Mesh(const TetData& data, const std::string& source)
    : complex_(make_complex(data, source)), position_(complex_.vertex_attributes()) {
    const std::vector<std::uint32_t> used = used_vertices(data);
    for (std::uint32_t i = 0; i < used.size(); ++i) position_[VertexId(i)] = data.vertices[used[i]];
}

TetData Mesh::data() const {
    TetData data;
    std::vector<std::uint32_t> number(complex_.vertex_capacity());
    data.vertices.reserve(complex_.vertex_count());
    for (std::uint32_t i = 0; i < complex_.vertex_capacity(); ++i) {
        if (complex_.is_deleted(VertexId(i))) continue;
        number[i] = static_cast<std::uint32_t>(data.vertices.size());
        data.vertices.push_back(position_[VertexId(i)]);
    }
    bool has_labels = false;
    data.tets.reserve(complex_.tet_count());
    data.labels.reserve(complex_.tet_count());
    for (std::uint32_t i = 0; i < complex_.tet_capacity(); ++i) {
        const TetId t(i);
        if (complex_.is_deleted(t)) continue;
        const TetVertices& v = complex_.vertices(t);
        data.tets.push_back({number[v[0].index()], number[v[1].index()], number[v[2].index()], number[v[3].index()]});
        data.labels.push_back(complex_.label(t));
        has_labels = has_labels || complex_.label(t) != 0;
    }
    if (!has_labels) data.labels.clear();
    return data;
}

std::vector<std::string> validate(const Mesh& mesh, std::size_t limit) {
    std::vector<std::string> problems = validate(mesh.complex(), limit);
    for (std::uint32_t i = 0; i < mesh.complex().tet_capacity() && problems.size() < limit; ++i) {
        const TetId t(i);
        if (!mesh.complex().is_deleted(t) && !mesh.is_positive(mesh.complex().vertices(t)))
            problems.push_back("tetrahedron " + std::to_string(i) + " is not positive");
    }
    return problems;
}

}  // namespace dsc::dsc3d
