// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/fields.h"

#include <cmath>
#include <numbers>

#include "core/errors.h"

namespace dsc::motion {

namespace {

using std::numbers::pi;
constexpr double perpendicular = 1e-12;  // cosine of what counts as a right angle

double squared_sine(double x) {
    const double s = std::sin(x);
    return s * s;
}

/// The factor in time.
class Reversal {
public:
    explicit Reversal(std::optional<double> period) : period_(period) {
        if (period && !(*period > 0 && std::isfinite(*period))) throw core::UsageError("period: has to be positive");
    }
    double operator()(double time) const { return period_ ? std::cos(pi * time / *period_) : 1; }

private:
    std::optional<double> period_;
};

Vector<2> vortex(double x, double y) {
    return {squared_sine(pi * x) * std::sin(2 * pi * y), -std::sin(2 * pi * x) * squared_sine(pi * y)};
}

template <int Dimension>
VelocityField<Dimension> shear(const Vector<Dimension>& direction, const Vector<Dimension>& gradient,
                               const Vector<Dimension>& about) {
    if (!(std::abs(direction.dot(gradient)) <= perpendicular * direction.norm() * gradient.norm())) {
        throw core::UsageError("shear: the direction has to be perpendicular to the gradient");
    }
    return [=](const Vector<Dimension>& x, double) -> Vector<Dimension> { return direction * gradient.dot(x - about); };
}

}  // namespace

VelocityField<3> enright_deformation(std::optional<double> period) {
    return [factor = Reversal(period)](const Vector<3>& p, double time) -> Vector<3> {
        const double sx = std::sin(2 * pi * p.x()), sy = std::sin(2 * pi * p.y()), sz = std::sin(2 * pi * p.z());
        return factor(time) * Vector<3>(2 * squared_sine(pi * p.x()) * sy * sz, -sx * squared_sine(pi * p.y()) * sz,
                                        -sx * sy * squared_sine(pi * p.z()));
    };
}

VelocityField<2> vortex_in_square(std::optional<double> period) {
    return [factor = Reversal(period)](const Vector<2>& p, double time) -> Vector<2> {
        return factor(time) * vortex(p.x(), p.y());
    };
}

VelocityField<3> vortex_in_cube(std::optional<double> period) {
    return [factor = Reversal(period)](const Vector<3>& p, double time) {
        const Vector<2> v = factor(time) * vortex(p.x(), p.y());
        return Vector<3>(v.x(), v.y(), 0);
    };
}

VelocityField<2> shear_field(const Vector<2>& direction, const Vector<2>& gradient, const Vector<2>& about) {
    return shear<2>(direction, gradient, about);
}
VelocityField<3> shear_field(const Vector<3>& direction, const Vector<3>& gradient, const Vector<3>& about) {
    return shear<3>(direction, gradient, about);
}

}  // namespace dsc::motion
