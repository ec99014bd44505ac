// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/bridge.h"

#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

#include "core/errors.h"

namespace dsc::reconstruct {

namespace {

// Sum over the vertices of area times the square of the Laplacian: the bending of a thin plate. The Laplacian of a
// vertex counts when the vertex or a neighbour is free, which clamps the plate to the tangents around it.
class Plate {
public:
    Plate(Workbench& bench, std::span<const VertexId> free) : bench_(bench), free_(free.begin(), free.end()) {
        std::vector<VertexId> around = free_;
        for (const VertexId v : free_) {
            bench_.gather_ring(v, ring_);
            for (const auto& [b, c] : ring_) around.push_back(b);
        }
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        bending_ = std::move(around);
    }

    /// Where the free vertices rest. Equal weights: all edges count alike, as on a surface whose shape isn't known yet;
    /// else the cotangents of the surface as it is. Empty when there is no such place.
    std::vector<Point3> rest(bool has_equal_weights) {
        const auto n = static_cast<Eigen::Index>(free_.size());
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::MatrixX3d constant = Eigen::MatrixX3d::Zero(static_cast<Eigen::Index>(bending_.size()), 3);
        for (std::size_t row = 0; row < bending_.size(); ++row) {
            const VertexId v = bending_[row];
            double area = 0, total = 0;
            bench_.gather_ring(v, ring_);
            const auto add = [&](VertexId other, double weight) {
                const auto found = std::lower_bound(free_.begin(), free_.end(), other);
                if (found != free_.end() && *found == other) {
                    entries.emplace_back(static_cast<int>(row), static_cast<int>(found - free_.begin()), weight);
                } else {
                    constant.row(static_cast<Eigen::Index>(row)) += weight * bench_.position(other).transpose();
                }
            };
            for (const auto& [b, c] : ring_) area += triangle_area(v, b, c) / 3;
            const double scale = has_equal_weights ? 1 / static_cast<double>(ring_.size()) : 1 / std::sqrt(area);
            for (const auto& [b, c] : ring_) {
                // Each of the triangle's edges at v has half of its weight from here.
                const double at_b = has_equal_weights ? 0.5 : 0.5 * cotangent(c, v, b);
                const double at_c = has_equal_weights ? 0.5 : 0.5 * cotangent(b, v, c);
                add(b, scale * at_b);
                add(c, scale * at_c);
                total += scale * (at_b + at_c);
            }
            add(v, -total);
        }
        Eigen::SparseMatrix<double> laplacian(static_cast<Eigen::Index>(bending_.size()), n);
        laplacian.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SparseMatrix<double> energy = laplacian.transpose() * laplacian;
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(energy);
        if (solver.info() != Eigen::Success) return {};
        const Eigen::MatrixX3d places = solver.solve(-(laplacian.transpose() * constant));
        if (!places.allFinite()) return {};
        std::vector<Point3> result;
        for (Eigen::Index i = 0; i < n; ++i) result.emplace_back(places.row(i).transpose());
        return result;
    }

private:
    double triangle_area(VertexId a, VertexId b, VertexId c) const {
        return 0.5 * (bench_.position(b) - bench_.position(a)).cross(bench_.position(c) - bench_.position(a)).norm();
    }
    // Of the angle at `apex`, between the limits that keep the system well posed on triangles of no area.
    double cotangent(VertexId apex, VertexId a, VertexId b) const {
        constexpr double least = 0.02, most = 20;
        const Vector3 to_a = bench_.position(a) - bench_.position(apex),
                      to_b = bench_.position(b) - bench_.position(apex);
        const double sine = to_a.cross(to_b).norm();
        return sine > 0 ? std::clamp(to_a.dot(to_b) / sine, least, most) : most;
    }

    Workbench& bench_;
    std::vector<VertexId> free_, bending_;  ///< ascending
    std::vector<std::array<VertexId, 2>> ring_;
};

// Ascending.
std::vector<VertexId> vertices_in_gaps(Workbench& bench, const Cloud& cloud, const KdTree& tree,
                                       const BridgeParameters& parameters) {
    const auto is_beyond = [&](VertexId v, double spacings) {
        const KdTree::Neighbour near = tree.nearest(bench.position(v));
        const double distance = spacings * cloud.spacing[near.index];
        return near.squared_distance > distance * distance;
    };
    core::Attribute<VertexId, std::uint8_t> is_in_gap(bench.complex().vertex_attributes(), 0);
    std::vector<VertexId> result;
    const auto add = [&](VertexId v, double spacings) {
        if (is_in_gap[v] != 0 || !is_beyond(v, spacings)) return;
        is_in_gap[v] = 1;
        result.push_back(v);
    };
    std::vector<std::array<VertexId, 2>> ring;
    for (const VertexId v : bench.interface_vertices()) {
        const std::size_t begin = result.size();
        bool has_rim = false;
        add(v, parameters.depth);
        for (std::size_t i = begin; i < result.size(); ++i) {
            bench.gather_ring(result[i], ring);
            for (const auto& [b, c] : ring) {
                add(b, parameters.rim);
                has_rim = has_rim || is_in_gap[b] == 0;
            }
        }
        // A part that nothing clamps has no place of rest.
        if (!has_rim) result.resize(begin);
    }
    std::sort(result.begin(), result.end());
    return result;
}

}  // namespace

void BridgeParameters::validate() const {
    if (!(rim > 0)) throw core::UsageError("rim: has to be positive");
    if (!(depth >= rim)) throw core::UsageError("depth: has to be at least rim");
    if (rounds < 0) throw core::UsageError("rounds: has to be at least 0");
}

std::size_t bridge_gaps(Workbench& bench, const Cloud& cloud, const KdTree& tree, const BridgeParameters& parameters,
                        core::Observer& observer) {
    parameters.validate();
    const std::vector<VertexId> free = vertices_in_gaps(bench, cloud, tree, parameters);
    core::Attribute<VertexId, Point3> target(bench.complex().vertex_attributes(), Point3(Point3::Zero()));
    for (int round = 0; round < parameters.rounds && !free.empty(); ++round) {
        observer.check_cancelled();
        const std::vector<Point3> places = Plate(bench, free).rest(2 * round < parameters.rounds);
        if (places.empty()) break;
        const double share = 1.0 / (parameters.rounds - round);
        for (std::size_t i = 0; i < free.size(); ++i) {
            const Point3& from = bench.position(free[i]);
            target[free[i]] = from + share * (places[i] - from);
        }
        bench.move(free, target);
        bench.keep_up();
    }
    return free.size();
}

}  // namespace dsc::reconstruct
