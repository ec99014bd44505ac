// SPDX-License-Identifier: GPL-3.0-or-later
// Values at the vertices of a mesh, linear in each cell, at any place: what vertices get that mesh improvement has made
// or moved. Source: thesis 6.4.1, figure 6.3 and equation (6.2): a place outside of the fluid has the value of its
// projection onto the surface. Here the mesh is the advected one, so that advection itself needs no interpolation.
// Guarantee: affine fields are exact inside; a value is a mean of those of one cell, so that no new extremes come up;
// the same bits for the same input. Cost: linear to build; constant for places inside, linear in the surface outside.
//
//     const fluid::Interpolation<3> advected(mesh);
//     const Vector<3> u = advected.value_at(place, velocities);
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "fluid/facets.h"

namespace dsc::fluid {

template <int Dimension>
class Interpolation {
public:
    /// The mesh has to live as long, and to have a cell.
    explicit Interpolation(const SimplexMesh<Dimension>& mesh);

    /// Vertices and weights of a place; weights are not negative and sum to one.
    struct Place {
        std::array<std::uint32_t, Dimension + 1> vertices;
        Eigen::Matrix<double, Dimension + 1, 1> weights;
    };
    Place locate(const Vector<Dimension>& place) const;

    template <class Value>
    Value value_at(const Vector<Dimension>& place, const std::vector<Value>& values) const {
        const Place found = locate(place);
        Value sum = found.weights[0] * values[found.vertices[0]];
        for (int i = 1; i <= Dimension; ++i)
            sum += found.weights[i] * values[found.vertices[static_cast<std::size_t>(i)]];
        return sum;
    }

private:
    Eigen::Matrix<int, Dimension, 1> bin_of(const Vector<Dimension>& place) const;
    std::size_t number(const Eigen::Matrix<int, Dimension, 1>& bin) const;
    Place project(const Vector<Dimension>& place) const;

    const SimplexMesh<Dimension>& mesh_;
    std::vector<Facet<Dimension>> surface_;
    Eigen::AlignedBox<double, Dimension> box_;
    double bin_size_ = 1;
    Eigen::Matrix<int, Dimension, 1> bins_;
    std::vector<std::uint32_t> first_;  ///< of each bin, in cells_
    std::vector<std::uint32_t> cells_;
};

}  // namespace dsc::fluid
