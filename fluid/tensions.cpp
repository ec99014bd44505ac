// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/tensions.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"

namespace dsc::fluid {

void Tensions::validate(std::size_t phases) const {
    const auto is_valid = [](double tension) { return tension >= 0 && std::isfinite(tension); };
    if (free_surface.size() != phases) throw core::UsageError("tension: one is needed for each phase");
    if (!std::all_of(free_surface.begin(), free_surface.end(), is_valid) || !is_valid(between_phases))
        throw core::UsageError("tension: can't be negative");
    if (!(std::abs(wetting) <= 1)) throw core::UsageError("wetting: has to be in [-1, 1]");
}

template <int Dimension>
std::vector<char> held_facets(std::span<const Facet<Dimension>> facets,
                              std::span<const WallContact<Dimension>> contacts) {
    std::vector<std::pair<std::uint32_t, int>> touching;  // vertex, wall
    touching.reserve(contacts.size());
    for (const auto& contact : contacts) touching.emplace_back(contact.vertex, contact.wall);
    std::sort(touching.begin(), touching.end());
    const auto walls_of = [&](std::uint32_t v) {
        return std::equal_range(touching.begin(), touching.end(), std::pair(v, 0),
                                [](const auto& a, const auto& b) { return a.first < b.first; });
    };
    std::vector<char> result(facets.size(), 0);
    for (std::size_t f = 0; f < facets.size() && !touching.empty(); ++f) {
        if (facets[f].opposite) continue;
        const auto& vertices = facets[f].vertices;
        const auto [first, last] = walls_of(vertices[0]);
        result[f] = std::any_of(first, last, [&](const auto& contact) {
            return std::all_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) {
                return std::binary_search(touching.begin(), touching.end(), std::pair(v, contact.second));
            });
        });
    }
    return result;
}

template <int Dimension>
std::vector<SurfaceElement<Dimension>> surface_elements(const SimplexMesh<Dimension>& mesh,
                                                        std::span<const Facet<Dimension>> facets,
                                                        std::span<const WallContact<Dimension>> contacts,
                                                        const Tensions& tensions) {
    const std::vector<char> is_held = held_facets(facets, contacts);
    std::vector<SurfaceElement<Dimension>> result;
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const Facet<Dimension>& facet = facets[f];
        double tension = 0;
        if (facet.opposite) {
            if (mesh.phases[facet.cell] != mesh.phases[*facet.opposite]) tension = tensions.between_phases;
        } else {
            tension = tensions.free_surface[static_cast<std::size_t>(mesh.phases[facet.cell])];
            if (is_held[f] != 0) tension *= tensions.wetting;
        }
        if (tension != 0) result.push_back({facet.vertices, tension});
    }
    return result;
}

#define DSC_INSTANTIATE(D)                                                                                     \
    template std::vector<char> held_facets(std::span<const Facet<D>>, std::span<const WallContact<D>>);        \
    template std::vector<SurfaceElement<D>> surface_elements(const SimplexMesh<D>&, std::span<const Facet<D>>, \
                                                             std::span<const WallContact<D>>, const Tensions&);
DSC_INSTANTIATE(2)
DSC_INSTANTIATE(3)
#undef DSC_INSTANTIATE

}  // namespace dsc::fluid
