// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/curl_noise.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "core/errors.h"
#include "core/random.h"

namespace dsc::motion {

namespace {

using std::numbers::pi;
constexpr int samples_per_wave = 10;    // of the lattice on which the largest speed is looked for
constexpr double worth_climbing = 0.8;  // [largest speed of the lattice]
constexpr double finest_step = 1e-3;    // of the climb [lattice spacing]

template <int Dimension>
constexpr int potential_size = Dimension == 3 ? 3 : 1;

/// The potential has one component in the plane (the stream function) and three in space.
template <int Dimension>
class CurlNoise {
public:
    explicit CurlNoise(const CurlNoiseParameters<Dimension>& parameters)
        : parameters_(parameters), size_(parameters.high - parameters.low) {
        core::Random random(parameters.seed);
        for (int i = 0; i < parameters.waves; ++i) waves_.push_back(random_wave(random));
        const double speed = largest_speed();
        scale_ = speed > 0 ? parameters.max_speed / speed : 0;
    }

    Vector<Dimension> velocity(const Vector<Dimension>& x) const { return scale_ * curl(x); }

private:
    using Potential = Vector<potential_size<Dimension>>;
    using Gradient = Eigen::Matrix<double, potential_size<Dimension>, Dimension>;

    struct Wave {
        Vector<Dimension> direction;  ///< gradient of the phase
        Potential amplitude;
        Potential phase;
    };

    /// Whole numbers of wave lengths across the box, so that the noise repeats itself.
    Wave random_wave(core::Random& random) const {
        const auto limit = static_cast<int>(parameters_.max_frequency);
        Eigen::Matrix<int, Dimension, 1> numbers;
        do {
            for (int& n : numbers)
                n = static_cast<int>(random.below(static_cast<std::uint64_t>(2 * limit + 1))) - limit;
        } while (numbers.isZero() || numbers.squaredNorm() > parameters_.max_frequency * parameters_.max_frequency);
        Wave wave;
        wave.direction = 2 * pi * numbers.template cast<double>().cwiseQuotient(size_);
        // Divided by the frequency, for all waves to carry the same speed.
        for (double& a : wave.amplitude) a = random.uniform(-1, 1) / wave.direction.norm();
        for (double& p : wave.phase) p = random.uniform(0, 2 * pi);
        return wave;
    }

    /// Rises from 0 at the wall to 1 with two smooth derivatives, and its slope.
    std::array<double, 2> fading(double share) const {
        const double s = std::clamp(share / parameters_.wall_layer, 0.0, 1.0);
        return {s * s * s * (10 + s * (6 * s - 15)), 30 * s * s * (1 - s) * (1 - s) / parameters_.wall_layer};
    }

    /// The product of the fadings from all sides, and its gradient.
    double wall_factor(const Vector<Dimension>& x, Vector<Dimension>& gradient) const {
        Vector<Dimension> factors, slopes;
        for (int k = 0; k < Dimension; ++k) {
            const double share = (x[k] - parameters_.low[k]) / size_[k];
            const bool is_low = share < 0.5;
            const auto [factor, slope] = fading(is_low ? share : 1 - share);
            factors[k] = factor;
            slopes[k] = (is_low ? slope : -slope) / size_[k];
        }
        for (int k = 0; k < Dimension; ++k) {
            gradient[k] = slopes[k];
            for (int j = 0; j < Dimension; ++j) gradient[k] *= j == k ? 1 : factors[j];
        }
        return factors.prod();
    }

    Vector<Dimension> curl(const Vector<Dimension>& x) const {
        Potential potential = Potential::Zero();
        Gradient gradient = Gradient::Zero();
        for (const Wave& wave : waves_) {
            const double angle = wave.direction.dot(x - parameters_.low);
            for (int i = 0; i < potential_size<Dimension>; ++i) {
                potential[i] += wave.amplitude[i] * std::cos(angle + wave.phase[i]);
                gradient.row(i) -= wave.amplitude[i] * std::sin(angle + wave.phase[i]) * wave.direction.transpose();
            }
        }
        if (parameters_.has_walls) {
            Vector<Dimension> slope;
            const double factor = wall_factor(x, slope);
            gradient = factor * gradient + potential * slope.transpose();
        }
        if constexpr (Dimension == 3) {
            return {gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0), gradient(1, 0) - gradient(0, 1)};
        } else {
            return {gradient(0, 1), -gradient(0, 0)};
        }
    }

    double speed(const Vector<Dimension>& x) const { return curl(x).norm(); }

    double largest_speed() const {
        const int n = samples_per_wave * static_cast<int>(std::ceil(parameters_.max_frequency));
        std::vector<Vector<Dimension>> places;
        std::vector<double> speeds;
        const int count = static_cast<int>(std::lround(std::pow(n, Dimension)));
        for (int i = 0; i < count; ++i) {
            Vector<Dimension> x = parameters_.low;
            for (int k = 0, rest = i; k < Dimension; ++k, rest /= n) x[k] += size_[k] * (rest % n + 0.5) / n;
            places.push_back(x);
            speeds.push_back(speed(x));
        }
        const double found = *std::ranges::max_element(speeds);
        double largest = found;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (speeds[i] >= worth_climbing * found && is_local_maximum(speeds, static_cast<int>(i), n)) {
                largest = std::max(largest, climbed(places[i], speeds[i], n));
            }
        }
        return largest;
    }

    static bool is_local_maximum(const std::vector<double>& speeds, int i, int n) {
        for (int k = 0, stride = 1; k < Dimension; ++k, stride *= n) {
            const int coordinate = i / stride % n;
            if (coordinate > 0 && speeds[static_cast<std::size_t>(i - stride)] > speeds[static_cast<std::size_t>(i)])
                return false;
            if (coordinate + 1 < n &&
                speeds[static_cast<std::size_t>(i + stride)] > speeds[static_cast<std::size_t>(i)])
                return false;
        }
        return true;
    }

    /// The speed at the top, by steps along the axes that are halved when none of them leads up.
    double climbed(Vector<Dimension> x, double height, int n) const {
        for (double step = 0.5; step > finest_step;) {
            bool is_higher = false;
            for (int k = 0; k < 2 * Dimension; ++k) {
                Vector<Dimension> next = x;
                const double length = step * size_[k / 2] / n;
                next[k / 2] += k % 2 == 0 ? length : -length;
                next = next.cwiseMax(parameters_.low).cwiseMin(parameters_.high);
                const double there = speed(next);
                if (there > height) x = next, height = there, is_higher = true;
            }
            if (!is_higher) step /= 2;
        }
        return height;
    }

    CurlNoiseParameters<Dimension> parameters_;
    Vector<Dimension> size_;
    std::vector<Wave> waves_;
    double scale_ = 1;
};

template <int Dimension>
VelocityField<Dimension> noise_field(const CurlNoiseParameters<Dimension>& parameters) {
    parameters.validate();
    return [noise = std::make_shared<const CurlNoise<Dimension>>(parameters)](const Vector<Dimension>& x, double) {
        return noise->velocity(x);
    };
}

void require(bool condition, const char* field, const char* range) {
    if (!condition) throw core::UsageError(std::string(field) + ": has to be " + range);
}

}  // namespace

template <int Dimension>
void CurlNoiseParameters<Dimension>::validate() const {
    const Vector<Dimension> size = high - low;
    require(size.minCoeff() > 0 && size.allFinite(), "high", "larger than low in every coordinate");
    require(wall_layer > 0 && wall_layer <= 0.5, "wall_layer", "in (0, 0.5]");
    require(waves >= 1, "waves", "at least 1");
    require(max_frequency >= 1 && max_frequency <= 20, "max_frequency", "in [1, 20]");
    require(max_speed >= 0 && std::isfinite(max_speed), "max_speed", "at least 0");
}
template struct CurlNoiseParameters<2>;
template struct CurlNoiseParameters<3>;

VelocityField<2> curl_noise(const CurlNoiseParameters<2>& parameters) { return noise_field<2>(parameters); }
VelocityField<3> curl_noise(const CurlNoiseParameters<3>& parameters) { return noise_field<3>(parameters); }

}  // namespace dsc::motion
