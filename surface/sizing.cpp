// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sizing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "core/assert.h"
#include "core/errors.h"
#include "core/require.h"
#include "surface/curvature.h"
#include "surface/thickness.h"
#include "surface/triangle.h"
#include "surface/vertex_rings.h"

namespace dsc::surface {

namespace {

void take_less(std::vector<double>& lengths, const std::vector<double>& others, double factor) {
    for (std::size_t v = 0; v < lengths.size(); ++v) lengths[v] = std::min(lengths[v], factor * others[v]);
}

double length_of_field(const SizingParameters& parameters, const Point3& place) {
    const double length = parameters.field(place);
    if (length > 0) return length;
    throw core::UsageError("sizing: the field is " + std::to_string(length) + " at (" + std::to_string(place.x()) +
                           ", " + std::to_string(place.y()) + ", " + std::to_string(place.z()) +
                           "); it has to be positive");
}

}  // namespace

void SizingParameters::validate() const {
    core::require(length > 0 && std::isfinite(length), "length", "positive");
    core::require(is_uniform() || (min_length > 0 && min_length <= length), "min_length", "in (0, length]");
    core::require(!max_turn || (*max_turn > 0 && *max_turn <= 90), "max_turn", "in (0, 90]");
    core::require(!edges_across || *edges_across > 0, "edges_across", "positive");
    core::require(gradation > 0, "gradation", "positive");
}

std::vector<double> lengths_by_curvature(const geometry::SurfaceData& surface, double max_turn) {
    const VertexRings rings(surface);
    std::vector<RingTriangle> buffer;
    std::vector<double> lengths(surface.vertices.size(), std::numeric_limits<double>::infinity());
    for (std::uint32_t v = 0; v < lengths.size(); ++v) {
        const Curvature c = curvature(rings.ring(v, buffer));
        if (c.max_principal() > 0) lengths[v] = 2 * std::sin(max_turn / 2) / c.max_principal();
    }
    return lengths;
}

void limit_gradation(const geometry::SurfaceData& surface, double gradation, std::span<double> lengths) {
    DSC_ASSERT(lengths.size() == surface.vertices.size());
    // As Dijkstra: a length that is settled is the least one left, so that it is not lowered again.
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (std::uint32_t v = 0; v < lengths.size(); ++v) queue.emplace(lengths[v], v);
    const VertexRings rings(surface);
    while (!queue.empty()) {
        const auto [length, v] = queue.top();
        queue.pop();
        if (length > lengths[v]) continue;
        for (const std::uint32_t t : rings.triangles(v)) {
            for (const std::uint32_t w : surface.triangles[t]) {
                const double limit = length + gradation * (surface.vertices[w] - surface.vertices[v]).norm();
                if (lengths[w] > limit) {
                    lengths[w] = limit;
                    queue.emplace(limit, w);
                }
            }
        }
    }
}

std::vector<double> wanted_lengths(const geometry::SurfaceData& surface, const SizingParameters& parameters) {
    parameters.validate();
    std::vector<double> lengths(surface.vertices.size(), parameters.length);
    if (parameters.is_uniform()) return lengths;
    if (parameters.max_turn) take_less(lengths, lengths_by_curvature(surface, radians(*parameters.max_turn)), 1);
    if (parameters.edges_across) take_less(lengths, thickness(surface), 1 / *parameters.edges_across);
    for (std::size_t v = 0; v < lengths.size(); ++v) {
        if (parameters.field) lengths[v] = std::min(lengths[v], length_of_field(parameters, surface.vertices[v]));
        lengths[v] = std::max(lengths[v], parameters.min_length);
    }
    limit_gradation(surface, parameters.gradation, lengths);
    return lengths;
}

}  // namespace dsc::surface
