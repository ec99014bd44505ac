// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/tetrahedron_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/assert.h"

namespace dsc::geometry {

namespace {

using Eigen::Vector3d;

// The vectors that all measures are made of. Face normals point outwards from a positive tetrahedron and are twice the
// area long; face i is opposite vertex i of a, b, c, d.
struct Shape {
    Vector3d ab, ac, ad, bc, bd;
    std::array<Vector3d, 4> normal;
    double six_volume;

    Shape(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
        : ab(b - a), ac(c - a), ad(d - a), bc(c - b), bd(d - b) {
        normal[1] = ad.cross(ac);
        normal[2] = ab.cross(ad);
        normal[3] = ac.cross(ab);
        normal[0] = bc.cross(bd);
        six_volume = -ab.dot(normal[1]);
    }
    Vector3d cd() const { return ad - ac; }
};

// The edges in the order ab, ac, ad, bc, bd, cd and the two faces that meet there.
constexpr std::array<std::array<int, 2>, 6> faces_at_edge = {{{2, 3}, {1, 3}, {1, 2}, {0, 3}, {0, 2}, {0, 1}}};

std::array<Vector3d, 6> edges(const Shape& shape) {
    return {shape.ab, shape.ac, shape.ad, shape.bc, shape.bd, shape.cd()};
}

// The sine of the dihedral angle between faces i and j is 6 V l / (|n_i| |n_j|), l the length of their edge.
double least_sine(const Shape& shape, double bias) {
    const std::array<double, 6> squared_length = {shape.ab.squaredNorm(), shape.ac.squaredNorm(),
                                                  shape.ad.squaredNorm(), shape.bc.squaredNorm(),
                                                  shape.bd.squaredNorm(), shape.cd().squaredNorm()};
    std::array<double, 4> squared_area;
    for (int i = 0; i < 4; ++i) squared_area[i] = shape.normal[i].squaredNorm();
    double least = 1e300;
    for (int e = 0; e < 6; ++e) {
        const auto [i, j] = faces_at_edge[e];
        double squared = squared_length[e] / (squared_area[i] * squared_area[j]);
        if (bias != 1 && shape.normal[i].dot(shape.normal[j]) > 0) squared *= bias * bias;
        least = std::min(least, squared);
    }
    const double sine = shape.six_volume * std::sqrt(least);
    return std::isfinite(sine) ? sine : 0;
}

int sine_terms(const Shape& shape, double bias, std::array<QualityTerm, 6>& terms) {
    const std::array<Vector3d, 6> edge = edges(shape);
    // Gradient of the logarithm of each factor with respect to a.
    const Vector3d volume_part = shape.normal[0] / -shape.six_volume;
    std::array<Vector3d, 4> area_part;
    std::array<double, 4> area;
    for (int i = 0; i < 4; ++i) area[i] = shape.normal[i].norm();
    const std::array<Vector3d, 4> opposite_edge = {Vector3d::Zero(), edge[5], -edge[4], edge[3]};
    area_part[0].setZero();
    for (int i = 1; i < 4; ++i) area_part[i] = opposite_edge[i].cross(shape.normal[i]) / (area[i] * area[i]);
    for (int e = 0; e < 6; ++e) {
        const auto [i, j] = faces_at_edge[e];
        double value = shape.six_volume * edge[e].norm() / (area[i] * area[j]);
        if (bias != 1 && shape.normal[i].dot(shape.normal[j]) > 0) value *= bias;
        Vector3d log_gradient = volume_part - area_part[i] - area_part[j];
        if (e < 3) log_gradient -= edge[e] / edge[e].squaredNorm();
        terms[e] = {value, value * log_gradient};
    }
    return 6;
}

double sum_of_squared_lengths(const Shape& shape) {
    return shape.ab.squaredNorm() + shape.ac.squaredNorm() + shape.ad.squaredNorm() + shape.bc.squaredNorm() +
           shape.bd.squaredNorm() + shape.cd().squaredNorm();
}

// 6 sqrt(2) V / l_rms^3 with 6 l_rms^2 the sum of the squared lengths.
double volume_length(const Shape& shape) {
    const double mean = sum_of_squared_lengths(shape) / 6;
    return mean > 0 ? std::sqrt(2.0) * shape.six_volume / (mean * std::sqrt(mean)) : 0;
}

int volume_length_terms(const Shape& shape, std::array<QualityTerm, 6>& terms) {
    const double sum = sum_of_squared_lengths(shape);
    const double value = volume_length(shape);
    const Vector3d sum_gradient = -2 * (shape.ab + shape.ac + shape.ad);
    terms[0] = {value, value * (shape.normal[0] / -shape.six_volume - 1.5 * sum_gradient / sum)};
    return 1;
}

// With u = |ab|^2 (ac x ad) + |ac|^2 (ad x ab) + |ad|^2 (ab x ac): R = |u| / (12 V), r = 3 V / (area of all faces), so
// 3 r / R = 6 (6V)^2 / (|u| sum |n_i|).
Vector3d circumcenter_vector(const Shape& shape) {
    return -(shape.ab.squaredNorm() * shape.normal[1] + shape.ac.squaredNorm() * shape.normal[2] +
             shape.ad.squaredNorm() * shape.normal[3]);
}

double radius_ratio(const Shape& shape) {
    double areas = 0;
    for (const Vector3d& n : shape.normal) areas += n.norm();
    const double denominator = areas * circumcenter_vector(shape).norm();
    return denominator > 0 ? 6 * shape.six_volume * std::abs(shape.six_volume) / denominator : 0;
}

int radius_ratio_terms(const Shape& shape, std::array<QualityTerm, 6>& terms) {
    const Vector3d u = circumcenter_vector(shape);
    double areas = 0;
    for (const Vector3d& n : shape.normal) areas += n.norm();
    const std::array<Vector3d, 4> opposite_edge = {Vector3d::Zero(), shape.cd(), -shape.bd, shape.bc};
    Vector3d areas_gradient = Vector3d::Zero();
    for (int i = 1; i < 4; ++i) areas_gradient += opposite_edge[i].cross(shape.normal[i]) / shape.normal[i].norm();
    // u depends on a through all three vectors at a: du = sum over the edges e at a of -2 (e . da) n_e - |e|^2 dn_e,
    // and dn_1 = -da x (ac - ad), cyclically.
    const Vector3d cd = shape.cd();
    const double b2 = shape.ab.squaredNorm(), c2 = shape.ac.squaredNorm(), d2 = shape.ad.squaredNorm();
    const Vector3d weighted = b2 * cd - c2 * shape.bd + d2 * shape.bc;
    const Vector3d half_gradient = 2 * (u.dot(shape.normal[1]) * shape.ab + u.dot(shape.normal[2]) * shape.ac +
                                        u.dot(shape.normal[3]) * shape.ad) -
                                   weighted.cross(u);
    const double value = radius_ratio(shape);
    terms[0] = {value, value * (2 * shape.normal[0] / -shape.six_volume - areas_gradient / areas -
                                half_gradient / u.squaredNorm())};
    return 1;
}

// Powers of the lengths up to the eighth have to stay within the range of a double. Where they don't, all is measured
// in another unit, a power of two, which changes no bit: 1 where lengths are usual, 0 where they are all zero.
double unit_per_length(const Shape& shape) {
    const double squared = std::max({shape.ab.squaredNorm(), shape.ac.squaredNorm(), shape.ad.squaredNorm()});
    if (squared > 1e-40 && squared < 1e40) return 1;
    const double length = std::max(
        {shape.ab.lpNorm<Eigen::Infinity>(), shape.ac.lpNorm<Eigen::Infinity>(), shape.ad.lpNorm<Eigen::Infinity>()});
    if (!(length > 0) || !std::isfinite(length)) return 0;
    return std::ldexp(1.0, std::clamp(-std::ilogb(length), -1022, 1022));
}

double quality_of(QualityMeasure measure, const Shape& shape, double bias) {
    switch (measure) {
        case QualityMeasure::minimum_sine: return least_sine(shape, 1);
        case QualityMeasure::minimum_biased_sine: return least_sine(shape, bias);
        case QualityMeasure::volume_length: return volume_length(shape);
        case QualityMeasure::radius_ratio: break;
    }
    return radius_ratio(shape);
}

int terms_of(QualityMeasure measure, const Shape& shape, std::array<QualityTerm, 6>& terms, double bias) {
    DSC_ASSERT(shape.six_volume > 0);
    switch (measure) {
        case QualityMeasure::minimum_sine: return sine_terms(shape, 1, terms);
        case QualityMeasure::minimum_biased_sine: return sine_terms(shape, bias, terms);
        case QualityMeasure::volume_length: return volume_length_terms(shape, terms);
        case QualityMeasure::radius_ratio: break;
    }
    return radius_ratio_terms(shape, terms);
}

}  // namespace

double quality(QualityMeasure measure, const Point3& a, const Point3& b, const Point3& c, const Point3& d,
               double bias) {
    const Shape shape(a, b, c, d);
    const double unit = unit_per_length(shape);
    if (unit == 1) return quality_of(measure, shape, bias);
    return unit > 0 ? quality_of(measure, Shape(unit * a, unit * b, unit * c, unit * d), bias) : 0;
}

int quality_terms(QualityMeasure measure, const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                  std::array<QualityTerm, 6>& terms, double bias) {
    const Shape shape(a, b, c, d);
    const double unit = unit_per_length(shape);
    if (unit == 1) return terms_of(measure, shape, terms, bias);
    const int count = terms_of(measure, Shape(unit * a, unit * b, unit * c, unit * d), terms, bias);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) terms[i].gradient *= unit;
    return count;
}

std::array<double, 6> dihedral_cotangents(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    const Shape shape(a, b, c, d);
    const std::array<Vector3d, 6> edge = edges(shape);
    std::array<double, 6> cotangent;
    for (int e = 0; e < 6; ++e) {
        const auto [i, j] = faces_at_edge[e];
        cotangent[e] = -shape.normal[i].dot(shape.normal[j]) / (shape.six_volume * edge[e].norm());
    }
    return cotangent;
}

std::array<double, 6> dihedral_angles(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    const Shape shape(a, b, c, d);
    const std::array<Vector3d, 6> edge = edges(shape);
    std::array<double, 6> angle;
    for (int e = 0; e < 6; ++e) {
        const auto [i, j] = faces_at_edge[e];
        angle[e] = std::atan2(shape.six_volume * edge[e].norm(), -shape.normal[i].dot(shape.normal[j]));
    }
    return angle;
}

}  // namespace dsc::geometry
