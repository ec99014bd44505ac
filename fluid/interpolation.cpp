// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/interpolation.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/assert.h"

namespace dsc::fluid {

namespace {

constexpr double bins_per_cell = 4;  // at most
constexpr double rounding = 1e-12;   // of weights of a place in a cell

template <int Dimension>
Eigen::Matrix<double, Dimension + 1, 1> weights_in(const SimplexMesh<Dimension>& mesh, std::uint32_t cell,
                                                   const Vector<Dimension>& place) {
    const auto& corners = mesh.cells[cell];
    Eigen::Matrix<double, Dimension, Dimension> edges;
    for (int k = 0; k < Dimension; ++k)
        edges.col(k) = mesh.positions[corners[static_cast<std::size_t>(k) + 1]] - mesh.positions[corners[0]];
    Eigen::Matrix<double, Dimension + 1, 1> weights;
    weights.template tail<Dimension>() = edges.partialPivLu().solve(place - mesh.positions[corners[0]]);
    weights[0] = 1 - weights.template tail<Dimension>().sum();
    return weights;
}

// Weights of the place of a simplex of at most three corners that is nearest: its projection, or that of a side.
template <int Dimension>
Eigen::VectorXd nearest(const std::vector<Vector<Dimension>>& corners, const Vector<Dimension>& place) {
    const auto count = static_cast<Eigen::Index>(corners.size());
    if (count == 1) return Eigen::VectorXd::Ones(1);
    Eigen::MatrixXd edges(Dimension, count - 1);
    for (Eigen::Index k = 0; k + 1 < count; ++k) edges.col(k) = corners[static_cast<std::size_t>(k) + 1] - corners[0];
    Eigen::VectorXd weights(count);
    weights.tail(count - 1) = (edges.transpose() * edges).ldlt().solve(edges.transpose() * (place - corners[0]));
    weights[0] = 1 - weights.tail(count - 1).sum();
    if (weights.allFinite() && weights.minCoeff() >= 0) return weights;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t left_out = 0; left_out < corners.size(); ++left_out) {
        std::vector<Vector<Dimension>> side = corners;
        side.erase(side.begin() + static_cast<std::ptrdiff_t>(left_out));
        const Eigen::VectorXd of_side = nearest<Dimension>(side, place);
        Vector<Dimension> found = Vector<Dimension>::Zero();
        for (std::size_t i = 0; i < side.size(); ++i) found += of_side[static_cast<Eigen::Index>(i)] * side[i];
        if ((found - place).squaredNorm() >= least) continue;
        least = (found - place).squaredNorm();
        const auto at = static_cast<Eigen::Index>(left_out);
        weights << of_side.head(at), 0, of_side.tail(count - 1 - at);
    }
    return weights;
}

}  // namespace

template <int Dimension>
Interpolation<Dimension>::Interpolation(const SimplexMesh<Dimension>& mesh) : mesh_(mesh) {
    DSC_ASSERT(!mesh.cells.empty());
    for (const auto& facet : facets(mesh))
        if (!facet.opposite) surface_.push_back(facet);
    std::vector<Eigen::AlignedBox<double, Dimension>> boxes;
    double size = 0;
    for (const auto& cell : mesh.cells) {
        auto& box = boxes.emplace_back();
        for (const std::uint32_t v : cell) box.extend(mesh.positions[v]);
        box_.extend(box);
        size += box.sizes().maxCoeff();
    }
    bin_size_ = size / static_cast<double>(mesh.cells.size());
    const double most = bins_per_cell * static_cast<double>(mesh.cells.size()) + 1;
    while (((box_.sizes() / bin_size_).array() + 1).prod() > most) bin_size_ *= 1.25;
    bins_ = (box_.sizes() / bin_size_).template cast<int>().array() + 1;
    const auto visit = [&](auto&& enter) {
        for (std::uint32_t j = 0; j < mesh.cells.size(); ++j) {
            const auto low = bin_of(boxes[j].min()), high = bin_of(boxes[j].max());
            auto bin = low;
            for (bool goes_on = true; goes_on;) {
                enter(number(bin), j);
                int k = 0;
                while (k < Dimension && ++bin[k] > high[k]) bin[k] = low[k], ++k;
                goes_on = k < Dimension;
            }
        }
    };
    first_.assign(static_cast<std::size_t>(bins_.prod()) + 1, 0);
    visit([&](std::size_t bin, std::uint32_t) { ++first_[bin + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    cells_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    visit([&](std::size_t bin, std::uint32_t cell) { cells_[next[bin]++] = cell; });
}

template <int Dimension>
Eigen::Matrix<int, Dimension, 1> Interpolation<Dimension>::bin_of(const Vector<Dimension>& place) const {
    const Vector<Dimension> inside = place.cwiseMax(box_.min()).cwiseMin(box_.max());
    return ((inside - box_.min()) / bin_size_).template cast<int>().cwiseMin((bins_.array() - 1).matrix());
}

template <int Dimension>
std::size_t Interpolation<Dimension>::number(const Eigen::Matrix<int, Dimension, 1>& bin) const {
    int result = bin[Dimension - 1];
    for (int k = Dimension - 2; k >= 0; --k) result = result * bins_[k] + bin[k];
    return static_cast<std::size_t>(result);
}

template <int Dimension>
typename Interpolation<Dimension>::Place Interpolation<Dimension>::locate(const Vector<Dimension>& place) const {
    DSC_ASSERT(place.allFinite());
    if (box_.contains(place)) {
        const std::size_t bin = number(bin_of(place));
        for (std::uint32_t i = first_[bin]; i < first_[bin + 1]; ++i) {
            Eigen::Matrix<double, Dimension + 1, 1> weights = weights_in(mesh_, cells_[i], place);
            if (!(weights.minCoeff() >= -rounding)) continue;
            weights = weights.cwiseMax(0.0);
            return {mesh_.cells[cells_[i]], weights / weights.sum()};
        }
    }
    return project(place);
}

template <int Dimension>
typename Interpolation<Dimension>::Place Interpolation<Dimension>::project(const Vector<Dimension>& place) const {
    double least = std::numeric_limits<double>::infinity();
    Place result{};
    for (const auto& facet : surface_) {
        std::vector<Vector<Dimension>> corners;
        for (const std::uint32_t v : facet.vertices) corners.push_back(mesh_.positions[v]);
        const Eigen::VectorXd weights = nearest<Dimension>(corners, place);
        Vector<Dimension> found = Vector<Dimension>::Zero();
        for (std::size_t i = 0; i < Dimension; ++i) found += weights[static_cast<Eigen::Index>(i)] * corners[i];
        if ((found - place).squaredNorm() >= least) continue;
        least = (found - place).squaredNorm();
        result.weights.setZero();
        for (std::size_t i = 0; i < Dimension; ++i) {
            result.vertices[i] = facet.vertices[i];
            result.weights[static_cast<Eigen::Index>(i)] = weights[static_cast<Eigen::Index>(i)];
        }
        result.vertices[Dimension] = facet.vertices[0];
    }
    return result;
}

template class Interpolation<2>;
template class Interpolation<3>;

}  // namespace dsc::fluid
