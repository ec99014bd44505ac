// SPDX-License-Identifier: GPL-3.0-or-later
// The members of plain meshes, for all that goes through them: see core/fields.h.
#pragma once

#include "core/fields.h"
#include "geometry/interface_data.h"
#include "geometry/surface_data.h"
#include "geometry/tet_data.h"

namespace dsc::geometry {

template <class Visitor, core::ConstOrNot<TetData> Value>
void fields(Visitor& visitor, Value& data) {
    auto& [vertices, tets, labels] = data;
    visitor(vertices, tets, labels);
}

template <class Visitor, core::ConstOrNot<SurfaceData> Value>
void fields(Visitor& visitor, Value& data) {
    auto& [vertices, triangles, labels] = data;
    visitor(vertices, triangles, labels);
}

template <class Visitor, core::ConstOrNot<InterfaceData> Value>
void fields(Visitor& visitor, Value& data) {
    auto& [surface, sides] = data;
    visitor(surface, sides);
}

}  // namespace dsc::geometry
