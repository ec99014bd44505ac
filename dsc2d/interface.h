// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of a complex: as vertices and segments for what moves it, and as curves for what shows it.
// Source: thesis 4.3 (the interface is made of the edges between different labels). Guarantee: segments and curves have
// the higher label on their left, so that outlines of objects run counterclockwise; the order is that of the handles.
// Cost: linear in the complex.
//
//     const dsc2d::Interface interface(complex);
//     for (const dsc2d::InterfaceSegment& s : interface.segments) use(interface.vertices[s.a], s.vector);
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dsc2d/complex.h"

namespace dsc::dsc2d {

struct InterfaceSegment {
    std::uint32_t a, b;  ///< numbers in Interface::vertices
    Point2 vector;       ///< from a to b, across the seam where there is one
};

struct Interface {
    std::vector<VertexId> vertices;  ///< ascending
    std::vector<InterfaceSegment> segments;

    explicit Interface(const Complex& complex);
};

/// A place of a vertex: on a torus, the lattice cell tells its copies apart.
struct CurvePoint {
    VertexId vertex;
    LatticeVector cell;
    Point2 place;  ///< position(vertex) + translation(cell)
};

/// A part of the interface between junctions or ends on the domain's boundary, or a closed one.
struct InterfaceCurve {
    std::vector<CurvePoint> points;  ///< a closed curve ends with its first point, or a copy of it in another cell
    int left = 0, right = 0;         ///< labels

    bool is_closed() const { return points.front().vertex == points.back().vertex; }
};

std::vector<InterfaceCurve> interface_curves(const Complex& complex);

}  // namespace dsc::dsc2d
