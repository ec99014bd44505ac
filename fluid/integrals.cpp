// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/integrals.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace dsc::fluid {

template <>
Rotation<2> moment<2>(const Vector<2>& arm, const Vector<2>& vector) {
    return Rotation<2>(arm.x() * vector.y() - arm.y() * vector.x());
}

template <>
Rotation<3> moment<3>(const Vector<3>& arm, const Vector<3>& vector) {
    return arm.cross(vector);
}

template <>
Vector<2> rotational_velocity<2>(const Rotation<2>& rotation, const Vector<2>& arm) {
    return rotation.value() * Vector<2>(-arm.y(), arm.x());
}

template <>
Vector<3> rotational_velocity<3>(const Rotation<3>& rotation, const Vector<3>& arm) {
    return rotation.cross(arm);
}

template <int Dimension>
Motion<Dimension> motion_of(std::span<const Vector<Dimension>> positions, std::span<const double> masses,
                            std::span<const Vector<Dimension>> velocities) {
    Motion<Dimension> result;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Vector<Dimension> momentum = masses[i] * velocities[i];
        result.mass += masses[i];
        result.centre += masses[i] * positions[i];
        result.momentum += momentum;
        result.angular_momentum += moment<Dimension>(positions[i], momentum);
    }
    if (result.mass > 0) result.centre /= result.mass;
    return result;
}

template <int Dimension>
double kinetic_energy(std::span<const double> masses, std::span<const Vector<Dimension>> velocities) {
    double sum = 0;
    for (std::size_t i = 0; i < masses.size(); ++i) sum += 0.5 * masses[i] * velocities[i].squaredNorm();
    return sum;
}

template <int Dimension>
double potential_energy(std::span<const Vector<Dimension>> positions, std::span<const double> masses,
                        const Vector<Dimension>& gravity) {
    double sum = 0;
    for (std::size_t i = 0; i < masses.size(); ++i) sum -= masses[i] * gravity.dot(positions[i]);
    return sum;
}

template <int Dimension>
void correct_motion(std::span<const Vector<Dimension>> positions, std::span<const double> masses,
                    const Motion<Dimension>& wanted, std::span<Vector<Dimension>> velocities) {
    constexpr int rotations = Rotation<Dimension>::RowsAtCompileTime;
    constexpr double least_inertia = 1e-12;  // relative
    const Motion<Dimension> found = motion_of<Dimension>(positions, masses, velocities);
    if (!(found.mass > 0)) return;
    const Vector<Dimension> drift = (wanted.momentum - found.momentum) / found.mass;
    const Rotation<Dimension> missing =
        wanted.angular_momentum - found.angular_momentum - moment<Dimension>(found.centre, found.mass * drift);
    Eigen::Matrix<double, rotations, rotations> inertia = Eigen::Matrix<double, rotations, rotations>::Zero();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Vector<Dimension> arm = positions[i] - found.centre;
        for (int k = 0; k < rotations; ++k)
            inertia.col(k) +=
                masses[i] * moment<Dimension>(arm, rotational_velocity<Dimension>(Rotation<Dimension>::Unit(k), arm));
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, rotations, rotations>> axes(inertia);
    Rotation<Dimension> rotation = Rotation<Dimension>::Zero();
    for (int k = 0; k < rotations; ++k)
        if (axes.eigenvalues()[k] > least_inertia * axes.eigenvalues()[rotations - 1])
            rotation += axes.eigenvectors().col(k).dot(missing) / axes.eigenvalues()[k] * axes.eigenvectors().col(k);
    for (std::size_t i = 0; i < positions.size(); ++i)
        velocities[i] += drift + rotational_velocity<Dimension>(rotation, positions[i] - found.centre);
}

#define DSC_INSTANTIATE(D)                                                                                         \
    template Motion<D> motion_of(std::span<const Vector<D>>, std::span<const double>, std::span<const Vector<D>>); \
    template double kinetic_energy(std::span<const double>, std::span<const Vector<D>>);                           \
    template double potential_energy(std::span<const Vector<D>>, std::span<const double>, const Vector<D>&);       \
    template void correct_motion(std::span<const Vector<D>>, std::span<const double>, const Motion<D>&,            \
                                 std::span<Vector<D>>);
DSC_INSTANTIATE(2)
DSC_INSTANTIATE(3)
#undef DSC_INSTANTIATE

}  // namespace dsc::fluid
