// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/validate.h"

#include <optional>

#include "geometry/triangle.h"

namespace dsc::dsc2d {

namespace {

class Validator {
public:
    explicit Validator(const Complex& complex) : complex_(complex), interface_edges_(complex.vertex_capacity(), 0) {}

    std::vector<std::string> run() {
        for (std::uint32_t i = 0; i < complex_.edge_capacity(); ++i) {
            if (complex_.is_deleted(EdgeId(i))) continue;
            check_halfedge(Complex::halfedge(EdgeId(i)));
            check_halfedge(Complex::opposite(Complex::halfedge(EdgeId(i))));
            check_edge(EdgeId(i));
        }
        for (std::uint32_t i = 0; i < complex_.face_capacity(); ++i)
            if (!complex_.is_deleted(FaceId(i))) check_face(FaceId(i));
        for (std::uint32_t i = 0; i < complex_.vertex_capacity(); ++i)
            if (!complex_.is_deleted(VertexId(i))) check_vertex(VertexId(i));
        check_topology();
        return std::move(violations_);
    }

private:
    void report(const char* kind, std::uint32_t index, const char* problem) {
        violations_.push_back(std::string(kind) + " " + std::to_string(index) + ": " + problem);
    }

    void check_halfedge(HalfedgeId h) {
        const auto fail = [&](const char* problem) { report("half-edge", h.index(), problem); };
        if (!complex_.to(h).is_valid() || complex_.is_deleted(complex_.to(h))) return fail("ends at no vertex");
        if (complex_.prev(complex_.next(h)) != h) fail("is not the previous of its next");
        if (complex_.from(complex_.next(h)) != complex_.to(h)) fail("does not end where its next begins");
        if (complex_.face(complex_.next(h)) != complex_.face(h)) fail("has another face than its next");
        if (complex_.offset(h) != -complex_.offset(Complex::opposite(h))) fail("has an offset unlike its opposite's");
        for (int direction = 0; direction < 2; ++direction)
            if (!complex_.domain().is_periodic(direction) && complex_.offset(h)[direction] != 0)
                fail("crosses a seam that does not exist");
    }

    void check_edge(EdgeId e) {
        const HalfedgeId h = Complex::halfedge(e);
        const FaceId left = complex_.face(h), right = complex_.face(Complex::opposite(h));
        if (complex_.from(h) == complex_.to(h)) report("edge", e.index(), "joins a vertex to itself");
        if (!left.is_valid() && !right.is_valid()) report("edge", e.index(), "has no face");
        const bool separates = left.is_valid() && right.is_valid() && complex_.label(left) != complex_.label(right);
        if (complex_.is_interface(e) != separates) report("edge", e.index(), "has a wrong interface flag");
        if (separates) {
            ++interface_edges_[complex_.from(h).index()];
            ++interface_edges_[complex_.to(h).index()];
        }
    }

    void check_face(FaceId f) {
        const HalfedgeId h = complex_.halfedge(f);
        if (complex_.face(h) != f) return report("face", f.index(), "has a half-edge of another face");
        const HalfedgeId hn = complex_.next(h), hp = complex_.next(hn);
        if (complex_.next(hp) != h) return report("face", f.index(), "is not a triangle");
        const LatticeVector sum = complex_.offset(h) + complex_.offset(hn) + complex_.offset(hp);
        if (sum != LatticeVector::Zero()) report("face", f.index(), "has offsets that don't close");
        const auto [a, b, c] = complex_.corners(f);
        if (!geometry::is_counterclockwise(a, b, c)) report("face", f.index(), "is not strictly counterclockwise");
    }

    void check_vertex(VertexId v) {
        const auto fail = [&](const char* problem) { report("vertex", v.index(), problem); };
        const Point2 place = complex_.position(v);
        if (complex_.domain().snapped(place) != place) fail("is not on the grid");
        if (!complex_.domain().is_in_reach(place)) fail("is out of reach of exact arithmetic");
        if (complex_.interface_degree(v) != interface_edges_[v.index()]) fail("has a wrong interface degree");
        int boundary_sides = 0;
        std::size_t valence = 0;
        for (const HalfedgeId h : complex_.outgoing(v)) {
            if (complex_.from(h) != v) return fail("has a half-edge of another vertex in its ring");
            if (complex_.is_boundary(h)) ++boundary_sides;
            if (++valence > complex_.edge_capacity()) return fail("has a ring that does not close");
            for (const HalfedgeId other : complex_.outgoing(v)) {
                if (other == h) break;
                if (complex_.to(other) == complex_.to(h) && complex_.offset(other) == complex_.offset(h))
                    fail("has two edges to the same vertex of the cover");
            }
        }
        valence_sum_ += valence;
        if (boundary_sides > 1) fail("is a pinch of the domain's boundary");
        if (boundary_sides == 1 && !complex_.is_boundary(complex_.halfedge(v)))
            fail("is on the boundary but does not start there");
        if (valence < (boundary_sides == 0 ? 3u : 2u)) fail("has too few edges");
    }

    // Every half-edge must be met in exactly one ring, and the Euler characteristic must be the domain's: together with
    // the orientation this makes the map from the complex to the domain one to one.
    void check_topology() {
        std::size_t vertices = 0, edges = 0, faces = 0;
        for (std::uint32_t i = 0; i < complex_.vertex_capacity(); ++i) vertices += !complex_.is_deleted(VertexId(i));
        for (std::uint32_t i = 0; i < complex_.edge_capacity(); ++i) edges += !complex_.is_deleted(EdgeId(i));
        for (std::uint32_t i = 0; i < complex_.face_capacity(); ++i) faces += !complex_.is_deleted(FaceId(i));
        if (valence_sum_ != 2 * edges) violations_.push_back("complex: an edge is missing from the ring of its vertex");
        const Domain& domain = complex_.domain();
        const std::size_t characteristic = domain.is_periodic(0) || domain.is_periodic(1) ? 0 : 1;
        if (vertices + faces != edges + characteristic)
            violations_.push_back("complex: the Euler characteristic is not the domain's");
        if (vertices != complex_.vertex_count() || faces != complex_.face_count())
            violations_.push_back("complex: the counts of deleted elements are wrong");
    }

    const Complex& complex_;
    std::vector<int> interface_edges_;
    std::vector<std::string> violations_;
    std::size_t valence_sum_ = 0;
};

template <class Chosen>
double sum_of_areas(const Complex& complex, Chosen is_chosen) {
    double sum = 0.0, lost = 0.0;  // Kahan: rounding stays far below the areas of slivers
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        const FaceId f(i);
        if (complex.is_deleted(f) || !is_chosen(f)) continue;
        const double term = complex.area(f) - lost;
        const double next = sum + term;
        lost = (next - sum) - term;
        sum = next;
    }
    return sum;
}

}  // namespace

std::vector<std::string> validate(const Complex& complex) { return Validator(complex).run(); }

double total_area(const Complex& complex) {
    return sum_of_areas(complex, [](FaceId) { return true; });
}

double labelled_area(const Complex& complex, int label) {
    return sum_of_areas(complex, [&](FaceId f) { return complex.label(f) == label; });
}

}  // namespace dsc::dsc2d
