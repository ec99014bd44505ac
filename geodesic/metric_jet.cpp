// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/metric_jet.h"

#include <tuple>

namespace dsc::geodesic {

namespace {

using Component = MetricJet::Component;

/// Christoffel symbols of the first kind [ij, k], or their derivative in one direction.
struct FirstKind {
    double uu_u, uu_v, uv_u, uv_v, vv_u, vv_v;
};

FirstKind first_kind(const MetricJet& jet) {
    const auto& [E, F, G] = std::tie(jet.E, jet.F, jet.G);
    return {E.u / 2, F.u - E.v / 2, E.v / 2, G.u / 2, F.v - G.u / 2, G.v / 2};
}

FirstKind first_kind_u(const MetricJet& jet) {
    const auto& [E, F, G] = std::tie(jet.E, jet.F, jet.G);
    return {E.uu / 2, F.uu - E.uv / 2, E.uv / 2, G.uu / 2, F.uv - G.uu / 2, G.uv / 2};
}

FirstKind first_kind_v(const MetricJet& jet) {
    const auto& [E, F, G] = std::tie(jet.E, jet.F, jet.G);
    return {E.uv / 2, F.uv - E.vv / 2, E.vv / 2, G.uv / 2, F.vv - G.uv / 2, G.vv / 2};
}

MetricTensor tensor_of(const MetricJet& jet) { return {jet.E.value, jet.F.value, jet.G.value}; }

/// Raises the index: the vector a with g a = (p, q).
Vector2 raised(const MetricTensor& g, double determinant, double p, double q) {
    return {(g.G * p - g.F * q) / determinant, (g.E * q - g.F * p) / determinant};
}

/// Derivative of a raised symbol: g a' = (p', q') - g' a.
Vector2 raised_derivative(const MetricTensor& g, double determinant, const MetricTensor& slope, const Vector2& a,
                          double p, double q) {
    return raised(g, determinant, p - slope.E * a.x() - slope.F * a.y(), q - slope.F * a.x() - slope.G * a.y());
}

/// (EG - F²)² K: the Gauss term scaled, and the two products of symbols with the adjugate of the tensor.
double scaled_curvature(const MetricTensor& g, double determinant, double gauss, const FirstKind& s) {
    return gauss * determinant - g.G * s.uu_u * s.vv_u + g.F * (s.uu_u * s.vv_v + s.uu_v * s.vv_u) -
           g.E * s.uu_v * s.vv_v + g.G * s.uv_u * s.uv_u - 2 * g.F * s.uv_u * s.uv_v + g.E * s.uv_v * s.uv_v;
}

/// Derivative of scaled_curvature by the product rule; primes are derivatives in one direction.
double scaled_curvature_slope(const MetricTensor& g, double determinant, double gauss, const FirstKind& s,
                              const MetricTensor& g1, double determinant1, double gauss1, const FirstKind& s1) {
    return gauss1 * determinant + scaled_curvature(g1, determinant1, gauss, s) -
           g.G * (s1.uu_u * s.vv_u + s.uu_u * s1.vv_u) +
           g.F * (s1.uu_u * s.vv_v + s.uu_u * s1.vv_v + s1.uu_v * s.vv_u + s.uu_v * s1.vv_u) -
           g.E * (s1.uu_v * s.vv_v + s.uu_v * s1.vv_v) + 2 * g.G * s.uv_u * s1.uv_u -
           2 * g.F * (s1.uv_u * s.uv_v + s.uv_u * s1.uv_v) + 2 * g.E * s.uv_v * s1.uv_v;
}

}  // namespace

MetricJet embedding_jet(const ScalarJet& x, const ScalarJet& y, const ScalarJet& z) {
    const auto vector = [&](double ScalarJet::*part) { return Eigen::Vector3d{x.*part, y.*part, z.*part}; };
    const Eigen::Vector3d u = vector(&ScalarJet::u), v = vector(&ScalarJet::v);
    const Eigen::Vector3d uu = vector(&ScalarJet::uu), uv = vector(&ScalarJet::uv), vv = vector(&ScalarJet::vv);
    const Eigen::Vector3d uuu = vector(&ScalarJet::uuu), uuv = vector(&ScalarJet::uuv);
    const Eigen::Vector3d uvv = vector(&ScalarJet::uvv), vvv = vector(&ScalarJet::vvv);
    MetricJet jet;
    jet.E = {u.dot(u),
             2 * u.dot(uu),
             2 * u.dot(uv),
             2 * (uu.dot(uu) + u.dot(uuu)),
             2 * (uu.dot(uv) + u.dot(uuv)),
             2 * (uv.dot(uv) + u.dot(uvv))};
    jet.F = {u.dot(v),
             uu.dot(v) + u.dot(uv),
             uv.dot(v) + u.dot(vv),
             uuu.dot(v) + 2 * uu.dot(uv) + u.dot(uuv),
             uuv.dot(v) + uu.dot(vv) + uv.dot(uv) + u.dot(uvv),
             uvv.dot(v) + 2 * uv.dot(vv) + u.dot(vvv)};
    jet.G = {v.dot(v),
             2 * v.dot(uv),
             2 * v.dot(vv),
             2 * (uv.dot(uv) + v.dot(uuv)),
             2 * (uv.dot(vv) + v.dot(uvv)),
             2 * (vv.dot(vv) + v.dot(vvv))};
    jet.gauss = uu.dot(vv) - uv.dot(uv);
    jet.gauss_u = uuu.dot(vv) + uu.dot(uvv) - 2 * uv.dot(uuv);
    jet.gauss_v = uuv.dot(vv) + uu.dot(vvv) - 2 * uv.dot(uvv);
    return jet;
}

MetricJet tensor_jet(const ScalarJet& E, const ScalarJet& F, const ScalarJet& G) {
    const auto component = [](const ScalarJet& f) { return Component{f.value, f.u, f.v, f.uu, f.uv, f.vv}; };
    return {component(E),
            component(F),
            component(G),
            F.uv - (E.vv + G.uu) / 2,
            F.uuv - (E.uvv + G.uuu) / 2,
            F.uvv - (E.vvv + G.uuv) / 2};
}

LocalGeometry local_geometry(const MetricJet& jet) {
    LocalGeometry local;
    const MetricTensor g = local.tensor = tensor_of(jet);
    const double determinant = g.determinant();
    const FirstKind s = first_kind(jet);
    const Vector2 uu = raised(g, determinant, s.uu_u, s.uu_v), uv = raised(g, determinant, s.uv_u, s.uv_v),
                  vv = raised(g, determinant, s.vv_u, s.vv_v);
    local.christoffel_u = {uu.x(), uv.x(), vv.x()};
    local.christoffel_v = {uu.y(), uv.y(), vv.y()};

    const double scaled = scaled_curvature(g, determinant, jet.gauss, s);
    local.curvature = scaled / (determinant * determinant);
    const auto slope = [&](const MetricTensor& g1, double gauss1, const FirstKind& s1) {
        const double determinant1 = g1.E * g.G + g.E * g1.G - 2 * g.F * g1.F;
        const double scaled1 = scaled_curvature_slope(g, determinant, jet.gauss, s, g1, determinant1, gauss1, s1);
        return (scaled1 / determinant - 2 * local.curvature * determinant1) / determinant;
    };
    local.curvature_gradient = {slope({jet.E.u, jet.F.u, jet.G.u}, jet.gauss_u, first_kind_u(jet)),
                                slope({jet.E.v, jet.F.v, jet.G.v}, jet.gauss_v, first_kind_v(jet))};
    return local;
}

ConnectionJet connection_jet(const MetricJet& jet) {
    ConnectionJet connection;
    const MetricTensor g = connection.tensor = tensor_of(jet);
    const double determinant = g.determinant();
    const MetricTensor g_u{jet.E.u, jet.F.u, jet.G.u}, g_v{jet.E.v, jet.F.v, jet.G.v};
    const FirstKind s = first_kind(jet), s_u = first_kind_u(jet), s_v = first_kind_v(jet);
    const auto fill = [&](std::size_t i, double FirstKind::*p, double FirstKind::*q) {
        const Vector2 a = raised(g, determinant, s.*p, s.*q);
        const Vector2 a_u = raised_derivative(g, determinant, g_u, a, s_u.*p, s_u.*q);
        const Vector2 a_v = raised_derivative(g, determinant, g_v, a, s_v.*p, s_v.*q);
        connection.christoffel_u[i] = a.x();
        connection.christoffel_v[i] = a.y();
        connection.christoffel_u_gradient[i] = {a_u.x(), a_v.x()};
        connection.christoffel_v_gradient[i] = {a_u.y(), a_v.y()};
    };
    fill(0, &FirstKind::uu_u, &FirstKind::uu_v);
    fill(1, &FirstKind::uv_u, &FirstKind::uv_v);
    fill(2, &FirstKind::vv_u, &FirstKind::vv_v);
    return connection;
}

}  // namespace dsc::geodesic
