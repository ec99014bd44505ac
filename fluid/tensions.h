// SPDX-License-Identifier: GPL-3.0-or-later
// Which facets carry tension, and how much. Source: thesis 6.4.3: gamma on free surfaces, (alpha_1 - alpha_2) gamma
// where the fluid touches a solid, so that the contact angle is arccos(alpha_2 - alpha_1) (6.5). Cost: linear.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fluid/facets.h"
#include "fluid/free_coordinates.h"
#include "fluid/surface_energy.h"

namespace dsc::fluid {

struct Tensions {
    std::vector<double> free_surface = {0};  ///< gamma of each phase towards the void; >= 0
    double between_phases = 0;               ///< of any two of them; >= 0
    double wetting = 0;                      ///< alpha_1 - alpha_2; in [-1, 1]

    /// Throws core::UsageError that names the first field out of its range.
    void validate(std::size_t phases) const;
};

/// Of each facet: whether it is on the boundary of the fluid, and one solid touches all of its vertices.
template <int Dimension>
std::vector<char> held_facets(std::span<const Facet<Dimension>> facets,
                              std::span<const WallContact<Dimension>> contacts);

/// The facets between phases, and between a phase and void or solid, as far as they have tension.
template <int Dimension>
std::vector<SurfaceElement<Dimension>> surface_elements(const SimplexMesh<Dimension>& mesh,
                                                        std::span<const Facet<Dimension>> facets,
                                                        std::span<const WallContact<Dimension>> contacts,
                                                        const Tensions& tensions);

}  // namespace dsc::fluid
