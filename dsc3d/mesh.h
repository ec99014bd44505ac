// SPDX-License-Identifier: GPL-3.0-or-later
// A tetrahedral mesh: a complex and the positions of its vertices, with conversion from and to plain arrays.
// Source: thesis 2.2 (topology apart from geometry). Guarantee: a mesh made from data is positive by exact predicate,
// manifold and conforming.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/attribute.h"
#include "dsc3d/complex/complex.h"
#include "geometry/predicates.h"
#include "geometry/tet_data.h"

namespace dsc::dsc3d {

using geometry::Point3;

class Mesh {
public:
    /// Vertices that no tetrahedron uses are dropped. Throws core::InputError, naming `source` and the element, for an
    /// index out of range, a repeated vertex, a face of more than two tetrahedra, a non-manifold edge or vertex, a
    /// coordinate that is not finite, a flat or an inverted tetrahedron (a mesh that is mirrored as a whole is turned).
    explicit Mesh(const geometry::TetData& data, const std::string& source = "mesh");

    Complex& complex() { return complex_; }
    const Complex& complex() const { return complex_; }

    const Point3& position(VertexId v) const { return position_[v]; }
    /// Precondition: every tetrahedron at v stays positive.
    void set_position(VertexId v, const Point3& position) { position_[v] = position; }
    const core::Attribute<VertexId, Point3>& positions() const { return position_; }

    bool is_positive(const std::array<VertexId, 4>& tet) const {
        return geometry::is_positive(position_[tet[0]], position_[tet[1]], position_[tet[2]], position_[tet[3]]);
    }

    /// The tetrahedra and the vertices they use, in the order of their handles.
    geometry::TetData data() const;

private:
    Complex complex_;
    core::Attribute<VertexId, Point3> position_;
};

/// validate() of the complex, and exact orientation of every tetrahedron.
std::vector<std::string> validate(const Mesh& mesh, std::size_t limit = 20);

}  // namespace dsc::dsc3d
