// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid motions as flows: points move by the rotation matrix or the translation itself, so that shapes stay as they are
// to rounding, and substeps follow the arc. Source: thesis 4.4.1.1. Cost: constant.
//
//     const motion::Rotation<3> flow({.about = centre, .axis = {0, 0, 1}, .angular_velocity = 2 * std::numbers::pi});
#pragma once

#include <Eigen/Geometry>

#include "core/errors.h"
#include "motion/velocity.h"

namespace dsc::motion {

template <int Dimension>
struct RotationParameters;

template <>
struct RotationParameters<2> {
    Vector<2> about = Vector<2>::Zero();
    double angular_velocity = 1;  ///< counterclockwise [rad/time]
};

template <>
struct RotationParameters<3> {
    Vector<3> about = Vector<3>::Zero();  ///< a point of the axis
    Vector<3> axis = Vector<3>::UnitZ();  ///< of any length but zero
    double angular_velocity = 1;          ///< counterclockwise, seen from the tip of the axis [rad/time]
};

template <int Dimension>
class Rotation final : public FlowMap<Dimension> {
public:
    /// Throws core::UsageError for an axis that is zero or not finite.
    explicit Rotation(const RotationParameters<Dimension>& parameters) : parameters_(parameters) {
        if constexpr (Dimension == 3) {
            const double length = parameters.axis.norm();
            if (!(length > 0) || !std::isfinite(length)) throw core::UsageError("axis: has to be a direction");
            parameters_.axis /= length;
        }
    }

    Vector<Dimension> at(const Vector<Dimension>& start, double t0, double t) const override {
        const double angle = parameters_.angular_velocity * (t - t0);
        return parameters_.about + matrix(angle) * (start - parameters_.about);
    }

    Vector<Dimension> velocity(const Vector<Dimension>& position) const {
        const Vector<Dimension> arm = position - parameters_.about;
        if constexpr (Dimension == 3) {
            return parameters_.angular_velocity * parameters_.axis.cross(arm);
        } else {
            return parameters_.angular_velocity * Vector<2>(-arm.y(), arm.x());
        }
    }
    VelocityField<Dimension> velocity_field() const {
        return [rotation = *this](const Vector<Dimension>& x, double) { return rotation.velocity(x); };
    }

private:
    Eigen::Matrix<double, Dimension, Dimension> matrix(double angle) const {
        if constexpr (Dimension == 3) {
            return Eigen::AngleAxisd(angle, parameters_.axis).toRotationMatrix();
        } else {
            return Eigen::Rotation2Dd(angle).toRotationMatrix();
        }
    }

    RotationParameters<Dimension> parameters_;
};

template <int Dimension>
class Translation final : public FlowMap<Dimension> {
public:
    explicit Translation(const Vector<Dimension>& velocity) : velocity_(velocity) {}

    Vector<Dimension> at(const Vector<Dimension>& start, double t0, double t) const override {
        return start + (t - t0) * velocity_;
    }

private:
    Vector<Dimension> velocity_;
};

}  // namespace dsc::motion
