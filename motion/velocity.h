// SPDX-License-Identifier: GPL-3.0-or-later
// What moves an interface: a velocity at each place and time, or the flow itself, which knows where a point is at any
// time of a step. Shared by 2D and 3D. Source: thesis 4.3 ("the vertices are advected"), 4.4.1.
//
//     const motion::RungeKuttaFlow<3> flow(motion::enright_deformation(3.0), 4);
//     const Point3 target = flow.at(position, t, t + dt);         // of a step
//     const Point3 halfway = flow.at(position, t, t + dt / 2);    // of a substep: on the path, not on its chord
#pragma once

#include <Eigen/Core>
#include <functional>

namespace dsc::motion {

template <int Dimension>
using Vector = Eigen::Matrix<double, Dimension, 1>;

/// The velocity at a position and a time. Has to be a function of these two alone, and safe to call from many threads.
template <int Dimension>
using VelocityField = std::function<Vector<Dimension>(const Vector<Dimension>& position, double time)>;

template <int Dimension>
class FlowMap {
public:
    virtual ~FlowMap() = default;

    /// Where the point that is at `start` at time `t0` is at time `t`, which may be before t0: its path, as t goes on.
    virtual Vector<Dimension> at(const Vector<Dimension>& start, double t0, double t) const = 0;
};

}  // namespace dsc::motion
