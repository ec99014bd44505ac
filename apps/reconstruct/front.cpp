// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "apps/reconstruct/dipole_sum.h"
#include "apps/reconstruct/octree_points.h"
#include "core/parallel.h"
#include "core/require.h"
#include "dsc3d/components.h"
#include "dsc3d/generate/delaunay.h"
#include "dsc3d/generate/fit.h"
#include "dsc3d/generate/manifold_interface.h"

namespace dsc::reconstruct {

namespace {

using dsc3d::TetId;
using dsc3d::VertexId;

// Smaller leaves where points with opposite normals are near.
std::vector<double> wanted_cells(const Cloud& cloud, const KdTree& tree, std::span<const Vector3> normals, double noise,
                                 const FrontParameters& parameters) {
    std::vector<double> cells(cloud.size());
    core::parallel_for(cloud.size(), {.threads = cloud.threads}, [&](std::size_t i) {
        const double spacing = cloud.spacing[i];
        const double widest = std::max(parameters.cell * spacing, 4 * noise);
        double cell = widest;
        std::vector<KdTree::Neighbour> near;
        tree.within(cloud.points[i], parameters.cells_across * widest, near);
        for (const KdTree::Neighbour& other : near) {
            if (normals[i].dot(normals[other.index]) > -0.5) continue;
            const Vector3 way = cloud.points[other.index] - cloud.points[i];
            const double across = std::abs(way.dot(normals[i]));
            // One right behind or in front of the other, and not by noise.
            if (across < 6 * noise) continue;
            if (way.norm() > 1.4 * across + 0.5 * spacing) continue;
            cell = std::min(cell, across / parameters.cells_across);
        }
        cells[i] = std::max({cell, parameters.least_cell * spacing, std::min(4 * noise, widest)});
    });
    // What single points say is not to be trusted: the second least of a neighbourhood counts.
    std::vector<double> result(cloud.size());
    core::parallel_for(cloud.size(), {.threads = cloud.threads}, [&](std::size_t i) {
        double least = cells[i], second = std::numeric_limits<double>::infinity();
        for (const std::uint32_t j : cloud.neighbours_of(i)) {
            if (cells[j] < least) {
                second = least, least = cells[j];
            } else {
                second = std::min(second, cells[j]);
            }
        }
        result[i] = std::min(second, std::max(parameters.cell * cloud.spacing[i], 4 * noise));
    });
    return result;
}

// At least as asked for, and such that halving it leads to the median of the wanted sides.
double half_side_of_box(std::vector<double> cells, double margin) {
    const auto middle = cells.begin() + static_cast<std::ptrdiff_t>(cells.size() / 2);
    std::nth_element(cells.begin(), middle, cells.end());
    double half_side = 0.5 * *middle;
    while (half_side < 0.5 + margin) half_side *= 2;
    return half_side;
}

// Signed distance from the planes of the nearest points, negative inside. The sign is that of the winding number; where
// that is in doubt, as it may be within a plate of few points, and all nearest points agree, it is theirs.
std::vector<double> levels(const Cloud& cloud, const KdTree& tree, const Orientation& orientation, double noise,
                           std::span<const Point3> places) {
    std::vector<Vector3> moments(cloud.size());
    std::vector<double> widths(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        moments[i] = orientation.areas[i] * orientation.normals[i];
        widths[i] = std::max(cloud.spacing[i], 3 * noise);
    }
    const DipoleSum sum(tree, cloud.points, cloud.threads);
    const std::vector<double> winding = sum.winding_numbers(sum.targets(places), moments, widths);
    std::vector<double> result(places.size());
    core::parallel_for(places.size(), {.threads = cloud.threads}, [&](std::size_t i) {
        constexpr std::size_t few = 8;
        std::vector<KdTree::Neighbour> near;
        tree.nearest(places[i], few, near);
        const double spacing = std::max(cloud.spacing[near.front().index], 2 * noise);
        double height = 0, weights = 0;
        std::size_t in_front = 0;
        for (const KdTree::Neighbour& point : near) {
            const double weight = 1 / (point.squared_distance + 0.25 * spacing * spacing);
            const double own_height = (places[i] - cloud.points[point.index]).dot(orientation.normals[point.index]);
            height += weight * own_height;
            weights += weight;
            in_front += own_height > 0 ? 1 : 0;
        }
        height /= weights;
        constexpr double doubt = 0.3;
        const bool is_agreed = in_front == 0 || in_front == near.size();
        const bool is_inside = is_agreed && std::abs(winding[i] - 0.5) < doubt ? in_front == 0 : winding[i] > 0.5;
        // Where the two disagree the surface is near.
        if ((height < 0) != is_inside) height = (is_inside ? -0.1 : 0.1) * spacing;
        result[i] = height != 0 ? height : (is_inside ? -1e-3 : 1e-3) * spacing;
    });
    return result;
}

// Regions whose surface has no points, of either label, take the label around them. The region at the box stays.
void drop_unsupported_parts(Front& front, const KdTree& tree, double least_support) {
    dsc3d::Mesh& mesh = *front.mesh;
    dsc3d::Complex& complex = mesh.complex();
    struct Part {
        std::size_t vertices = 0, supported = 0;
        bool is_at_box = false;
        int label = 0;
        std::vector<TetId> tets;
    };
    for (bool has_changed = true; has_changed;) {
        has_changed = false;
        front.cavities = 0;
        core::DisjointSets sets = dsc3d::components(complex);
        std::map<std::size_t, Part> parts;
        std::vector<std::pair<std::size_t, VertexId>> touched;
        for (std::uint32_t i = 0; i < complex.tet_capacity(); ++i) {
            const TetId t(i);
            if (complex.is_deleted(t)) continue;
            const std::size_t root = sets.find(i);
            Part& part = parts[root];
            part.label = complex.label(t);
            part.tets.push_back(t);
            for (const VertexId v : complex.vertices(t)) {
                part.is_at_box = part.is_at_box || complex.is_boundary(v);
                if (complex.is_interface(v)) touched.emplace_back(root, v);
            }
        }
        std::sort(touched.begin(), touched.end());
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        for (const auto& [root, v] : touched) {
            Part& part = parts[root];
            ++part.vertices;
            const KdTree::Neighbour near = tree.nearest(mesh.position(v));
            if (std::sqrt(near.squared_distance) <= front.cell[near.index]) ++part.supported;
        }
        for (auto& [root, part] : parts) {
            if (part.is_at_box) continue;
            const bool is_supported =
                static_cast<double>(part.supported) >= least_support * static_cast<double>(part.vertices) &&
                part.vertices >= 8;
            if (is_supported) {
                front.cavities += part.label == outside_label ? 1 : 0;
                continue;
            }
            for (const TetId t : part.tets)
                complex.set_label(t, part.label == inside_label ? outside_label : inside_label);
            ++front.dropped_parts;
            has_changed = true;
        }
    }
}

}  // namespace

void FrontParameters::validate() const {
    core::require(cell > 0, "cell", "positive");
    core::require(cells_across > 0, "cells_across", "positive");
    core::require(least_cell > 0 && least_cell <= cell, "least_cell", "in (0, cell]");
    core::require(growth > 0, "growth", "positive");
    core::require(margin > 0, "margin", "positive");
    core::require(least_support >= 0 && least_support <= 1, "least_support", "in [0, 1]");
}

Front labelled_front(const Cloud& cloud, const Orientation& orientation, double noise,
                     std::optional<double> edge_length, const FrontParameters& parameters, core::Observer& observer) {
    parameters.validate();
    const KdTree tree(cloud.points);
    Front front;
    observer.progress("making cells", -1, "");
    front.cell = edge_length ? std::vector<double>(cloud.size(), *edge_length / Front::edge_per_cell)
                             : wanted_cells(cloud, tree, orientation.normals, noise, parameters);
    const std::vector<Point3> places =
        octree_points(tree, front.cell, parameters.growth, half_side_of_box(front.cell, parameters.margin));
    observer.check_cancelled();
    front.mesh = std::make_unique<dsc3d::Mesh>(dsc3d::delaunay(places));
    observer.check_cancelled();
    observer.progress("labelling", -1, "");
    std::vector<double> values = levels(cloud, tree, orientation, noise, places);
    for (std::uint32_t i = 0; i < values.size(); ++i)
        if (front.mesh->complex().is_boundary(VertexId(i))) values[i] = std::max(values[i], 0.1 * cloud.median_spacing);
    dsc3d::fit(*front.mesh, values, {.inside = inside_label});
    dsc3d::make_interface_manifold(*front.mesh, inside_label, outside_label);
    drop_unsupported_parts(front, tree, parameters.least_support);
    return front;
}

}  // namespace dsc::reconstruct
