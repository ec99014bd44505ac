// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/max_min_step.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace dsc::dsc3d {

namespace {

using geometry::QualityTerm;

constexpr int max_active = 5;
constexpr int max_exchanges = 40;

// The functions that hold the model's minimum, and their multipliers.
class ActiveSet {
public:
    ActiveSet(std::span<const QualityTerm> terms, double s) : terms_(terms), s_(s) {}

    bool contains(std::size_t k) const { return std::find(index_, index_ + size_, k) != index_ + size_; }
    bool is_full() const { return size_ == max_active; }
    void add(std::size_t k) {
        index_[size_] = k;
        multiplier_[size_] = size_ == 0 ? 1.0 : 0.0;
        ++size_;
    }

    // Moves the multipliers to the optimum over the active functions, dropping those that reach zero on the way.
    void settle() {
        for (;;) {
            const Eigen::Matrix<double, max_active, 1> target = unconstrained_optimum();
            double share = 1;
            int blocking = -1;
            for (int i = 0; i < size_; ++i) {
                if (target[i] >= 0) continue;
                const double until_zero = multiplier_[i] / (multiplier_[i] - target[i]);
                if (until_zero < share || blocking < 0) share = std::min(share, until_zero), blocking = i;
            }
            for (int i = 0; i < size_; ++i) multiplier_[i] += share * (target[i] - multiplier_[i]);
            if (blocking < 0) return;
            remove(blocking);
        }
    }

    Eigen::Vector3d step() const {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (int i = 0; i < size_; ++i) sum += multiplier_[i] * terms_[index_[i]].gradient;
        return s_ * sum;
    }

private:
    void remove(int i) {
        --size_;
        for (; i < size_; ++i) index_[i] = index_[i + 1], multiplier_[i] = multiplier_[i + 1];
    }

    // s G^T G l + value = t, sum l = 1. A trace of regularization keeps dependent gradients solvable.
    Eigen::Matrix<double, max_active, 1> unconstrained_optimum() const {
        using System = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_active + 1, max_active + 1>;
        using Right = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_active + 1, 1>;
        System system = System::Zero(size_ + 1, size_ + 1);
        Right right = Right::Zero(size_ + 1);
        double trace = 0;
        for (int i = 0; i < size_; ++i) {
            for (int j = 0; j < size_; ++j)
                system(i, j) = s_ * terms_[index_[i]].gradient.dot(terms_[index_[j]].gradient);
            trace += system(i, i);
            system(i, size_) = system(size_, i) = 1;
            right[i] = -terms_[index_[i]].value;
        }
        for (int i = 0; i < size_; ++i) system(i, i) += 1e-13 * trace + 1e-300;
        right[size_] = 1;
        const Right solution = system.partialPivLu().solve(right);
        Eigen::Matrix<double, max_active, 1> multipliers = Eigen::Matrix<double, max_active, 1>::Zero();
        multipliers.head(size_) = solution.head(size_);
        return multipliers;
    }

    std::span<const QualityTerm> terms_;
    double s_;
    int size_ = 0;
    std::size_t index_[max_active];
    double multiplier_[max_active];
};

}  // namespace

MaxMinStep max_min_step(std::span<const QualityTerm> terms, double s) {
    const auto lowest_at = [&](const Eigen::Vector3d& d) {
        std::size_t lowest = 0;
        double value = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < terms.size(); ++k) {
            const double here = terms[k].value + terms[k].gradient.dot(d);
            if (here < value) value = here, lowest = k;
        }
        return std::pair(lowest, value);
    };

    ActiveSet active(terms, s);
    MaxMinStep best = {Eigen::Vector3d::Zero(), lowest_at(Eigen::Vector3d::Zero()).second};
    double best_model = best.predicted;
    active.add(lowest_at(Eigen::Vector3d::Zero()).first);
    for (int exchange = 0; exchange < max_exchanges; ++exchange) {
        active.settle();
        const Eigen::Vector3d d = active.step();
        const auto [lowest, value] = lowest_at(d);
        const double model = value - d.squaredNorm() / (2 * s);
        if (model > best_model) {
            best_model = model;
            best = {d, value};
        }
        if (active.contains(lowest) || active.is_full()) break;
        active.add(lowest);
    }
    return best;
}

}  // namespace dsc::dsc3d
