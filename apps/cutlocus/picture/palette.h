// SPDX-License-Identifier: GPL-3.0-or-later
// Colours and marks that mean the same in every picture; they differ in grey print too.
#pragma once

#include "apps/cutlocus/picture/chart_canvas.h"

namespace dsc::cutlocus::palette {

inline constexpr const char* locus_colour = "#c1121f";
inline constexpr const char* vertex_colour = "#6a040f";
inline constexpr const char* geodesic_colour = "#9a9a9a";
inline constexpr const char* circle_colour = "#4f7fb8";
inline constexpr const char* front_colour = "#e07b00";
inline constexpr const char* conjugate_colour = "#2a7f3f";

inline const io::SvgStyle locus{.stroke = locus_colour, .stroke_width = 2.6};
inline const io::SvgStyle geodesics{.stroke = geodesic_colour, .stroke_width = 0.55};
inline const io::SvgStyle circles{.stroke = circle_colour, .stroke_width = 0.8};
inline const io::SvgStyle conjugates{.stroke = conjugate_colour, .stroke_width = 1.6};

inline const MarkStyle generator{MarkShape::dot, "#000000", 5};
inline const MarkStyle end{MarkShape::ring, vertex_colour, 3.8};
inline const MarkStyle branch{MarkShape::dot, vertex_colour, 4.2};
inline const MarkStyle frontier{MarkShape::square, vertex_colour, 3};

}  // namespace dsc::cutlocus::palette
