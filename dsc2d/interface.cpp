// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/interface.h"

#include <optional>

namespace dsc::dsc2d {

namespace {

// The half-edge of an interface edge that has the higher label on its left.
HalfedgeId oriented(const Complex& complex, EdgeId e) {
    const HalfedgeId h = Complex::halfedge(e);
    const bool is_left = complex.label(complex.face(h)) > complex.label(complex.face(Complex::opposite(h)));
    return is_left ? h : Complex::opposite(h);
}

bool is_interface(const Complex& complex, EdgeId e) { return !complex.is_deleted(e) && complex.is_interface(e); }

class CurveTracer {
public:
    explicit CurveTracer(const Complex& complex) : complex_(complex), is_seen_(complex.edge_capacity(), 0) {}

    std::vector<InterfaceCurve> run() {
        for (std::uint32_t i = 0; i < complex_.vertex_capacity(); ++i) {
            const VertexId v(i);
            if (complex_.is_deleted(v) || !is_end(v)) continue;
            for (const HalfedgeId h : complex_.outgoing(v))
                if (complex_.is_interface(h) && oriented(complex_, Complex::edge(h)) == h) trace(h);
        }
        for (std::uint32_t i = 0; i < complex_.edge_capacity(); ++i)
            if (is_interface(complex_, EdgeId(i)) && !is_seen_[i]) trace(oriented(complex_, EdgeId(i)));
        return std::move(curves_);
    }

private:
    bool is_end(VertexId v) const {
        return complex_.is_interface(v) && (complex_.interface_degree(v) != 2 || complex_.is_boundary(v));
    }

    void trace(HalfedgeId h) {
        InterfaceCurve curve{.left = complex_.label(complex_.face(h)),
                             .right = complex_.label(complex_.face(Complex::opposite(h)))};
        LatticeVector cell = LatticeVector::Zero();
        const auto add = [&](VertexId v) {
            curve.points.push_back({v, cell, complex_.position(v) + complex_.domain().translation(cell)});
        };
        add(complex_.from(h));
        for (std::optional<HalfedgeId> at = h; at; at = following(*at)) {
            is_seen_[Complex::edge(*at).index()] = 1;
            cell += complex_.offset(*at);
            add(complex_.to(*at));
        }
        curves_.push_back(std::move(curve));
    }

    std::optional<HalfedgeId> following(HalfedgeId h) const {
        const VertexId v = complex_.to(h);
        if (is_end(v)) return std::nullopt;
        for (const HalfedgeId out : complex_.outgoing(v))
            if (complex_.is_interface(out) && !is_seen_[Complex::edge(out).index()]) return out;
        return std::nullopt;
    }

    const Complex& complex_;
    std::vector<std::uint8_t> is_seen_;
    std::vector<InterfaceCurve> curves_;
};

}  // namespace

Interface::Interface(const Complex& complex) {
    std::vector<std::uint32_t> number(complex.vertex_capacity());
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
        const VertexId v(i);
        if (complex.is_deleted(v) || !complex.is_interface(v)) continue;
        number[i] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(v);
    }
    for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i) {
        if (!is_interface(complex, EdgeId(i))) continue;
        const HalfedgeId h = oriented(complex, EdgeId(i));
        segments.push_back({number[complex.from(h).index()], number[complex.to(h).index()], complex.vector(h)});
    }
}

std::vector<InterfaceCurve> interface_curves(const Complex& complex) { return CurveTracer(complex).run(); }

}  // namespace dsc::dsc2d
