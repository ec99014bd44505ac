// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/generate/insert_polygon.h"

#include <deque>
#include <string>

#include "core/errors.h"
#include "dsc2d/generate/locate.h"
#include "dsc2d/improve/delaunay.h"
#include "dsc2d/operations/collapse.h"
#include "dsc2d/operations/flip.h"
#include "geometry/triangle.h"

namespace dsc::dsc2d {

namespace {

using geometry::Sign;

class PolygonInserter {
public:
    /// `touches_others`: sides and corners may be there already.
    PolygonInserter(Complex& complex, bool touches_others, const core::Observer& observer)
        : complex_(complex),
          is_side_(complex.edge_attributes(), 0),
          touches_others_(touches_others),
          observer_(observer) {}

    std::vector<VertexId> insert(std::span<const Point2> corners, int label) {
        if (corners.size() < 3) fail("has fewer than three corners");
        std::vector<CoverVertex> vertices;
        vertices.reserve(corners.size());
        for (const Point2& corner : corners) {
            observer_.check_cancelled();
            vertices.push_back(insert_point(complex_, complex_.domain().snapped(corner)));
        }

        std::vector<HalfedgeId> sides;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            observer_.check_cancelled();
            recover_side(vertices[i], vertices[(i + 1) % vertices.size()], sides);
        }

        double twice_area = 0.0;
        Point2 place = Point2::Zero();
        for (const HalfedgeId side : sides) {
            const Point2 vector = complex_.vector(side);
            twice_area += geometry::cross(place, vector);
            place += vector;
        }
        fill(sides, twice_area > 0.0, label);

        std::vector<VertexId> along;
        along.reserve(sides.size());
        for (const HalfedgeId side : sides) along.push_back(complex_.from(side));
        if (touches_others_) {
            remove_between_corners(vertices, along);
        } else {
            for (const VertexId v : along)
                if (complex_.interface_degree(v) != 2) fail("touches itself or an interface that is there already");
        }
        return along;
    }

private:
    [[noreturn]] static void fail(const char* problem) {
        throw core::InputError("polygon", "", problem, "give a simple closed polygon inside the domain");
    }

    // Appends the half-edges of the side from a to b: one, or several when vertices lie exactly on it.
    void recover_side(const CoverVertex& a, const CoverVertex& b, std::vector<HalfedgeId>& sides) {
        const auto place = [&](const CoverVertex& v) {
            return Point2(complex_.position(v.vertex) + complex_.domain().translation(v.cell));
        };
        Point2 rest = place(b) - place(a);
        if (rest.isZero(0.0)) fail("has two equal corners in a row");
        VertexId at = a.vertex;
        while (!rest.isZero(0.0)) {
            const HalfedgeId side = recover_edge(at, rest);
            if (is_side_[Complex::edge(side)]) fail("goes along the same edge twice");
            is_side_[Complex::edge(side)] = 1;
            sides.push_back(side);
            rest -= complex_.vector(side);
            at = complex_.to(side);
        }
    }

    // Vertices of the complex that happened to lie exactly on a side: the interface is to have no others than it was
    // given.
    void remove_between_corners(const std::vector<CoverVertex>& corners, std::vector<VertexId>& along) {
        std::vector<std::uint8_t> is_corner(complex_.vertex_capacity(), 0);
        for (const CoverVertex& corner : corners) is_corner[corner.vertex.index()] = 1;
        for (const VertexId v : along) {
            if (is_corner[v.index()] != 0 || complex_.is_deleted(v)) continue;
            for (const HalfedgeId h : complex_.outgoing(v)) {
                if (!complex_.is_interface(h) || !can_collapse(complex_, h, CollapseRule::coarsen_interface)) continue;
                collapse(complex_, h);
                break;
            }
        }
        std::erase_if(along, [&](VertexId v) { return complex_.is_deleted(v); });
    }

    struct Crossing {
        EdgeId edge;
        Point2 from;  // position of from(halfedge(edge)), relative to the start of the side
    };

    // Makes the straight way from `a` along `way` an edge, up to its end or the first vertex exactly on it.
    HalfedgeId recover_edge(VertexId a, Point2 way) {
        std::deque<Crossing> crossings;
        collect_crossings(a, way, crossings);
        std::size_t refused_in_a_row = 0;
        while (!crossings.empty()) {
            const auto [e, from] = crossings.front();
            crossings.pop_front();
            if (is_side_[e] || complex_.is_interface(e)) fail("crosses itself or an interface that is there already");
            if (!can_flip(complex_, e)) {
                crossings.push_back({e, from});
                if (++refused_in_a_row > crossings.size()) fail("needs a finer mesh around the seam");
                continue;
            }
            refused_in_a_row = 0;
            const HalfedgeId h = Complex::halfedge(e);
            const Point2 tail = from + complex_.vector(complex_.next(Complex::opposite(h)));
            flip(complex_, e);
            const Sign tail_side = geometry::orientation(Point2::Zero(), way, tail);
            const Sign head_side = geometry::orientation(Point2::Zero(), way, tail + complex_.vector(h));
            if (tail_side != Sign::zero && head_side != Sign::zero && tail_side != head_side)
                crossings.push_back({e, tail});
        }
        for (const HalfedgeId h : complex_.outgoing(a)) {
            const Point2 u = complex_.vector(h);
            if (u.dot(way) > 0.0 && geometry::orientation(Point2::Zero(), u, way) == Sign::zero) return h;
        }
        fail("can't be recovered");
    }

    // Shortens `way` to the first vertex on it.
    void collect_crossings(VertexId a, Point2& way, std::deque<Crossing>& crossings) const {
        const Point2 zero = Point2::Zero();
        HalfedgeId h;
        Point2 right, left;
        for (const HalfedgeId out : complex_.outgoing(a)) {
            const Point2 u = complex_.vector(out);
            const Sign turn = geometry::orientation(zero, u, way);
            if (turn == Sign::zero && u.dot(way) > 0.0) {
                way = u;
                return;
            }
            if (complex_.is_boundary(out) || turn != Sign::positive) continue;
            const Point2 w = complex_.vector(complex_.rotated(out));
            if (geometry::orientation(zero, way, w) != Sign::positive) continue;
            h = complex_.next(out);
            right = u;
            left = w;
        }
        if (!h.is_valid()) fail("leaves the domain");
        while (true) {
            const EdgeId e = Complex::edge(h);
            crossings.push_back({e, h == Complex::halfedge(e) ? right : left});
            const HalfedgeId o = Complex::opposite(h);
            if (complex_.is_boundary(o)) fail("leaves the domain");
            // o runs from left to right; its face lies ahead.
            const Point2 apex = right + complex_.vector(complex_.next(o));
            switch (geometry::orientation(zero, way, apex)) {
                case Sign::zero: way = apex; return;
                case Sign::positive:
                    left = apex;
                    h = complex_.next(o);
                    break;
                case Sign::negative:
                    right = apex;
                    h = complex_.prev(o);
                    break;
            }
        }
    }

    void fill(std::span<const HalfedgeId> sides, bool is_counterclockwise, int label) {
        std::vector<std::uint8_t> is_inside(complex_.face_capacity(), 0);
        std::vector<FaceId> stack;
        const auto add = [&](HalfedgeId h) {
            const FaceId f = complex_.face(h);
            if (!f.is_valid()) fail("does not enclose an area of the domain");
            if (is_inside[f.index()]) return;
            is_inside[f.index()] = 1;
            stack.push_back(f);
        };
        for (const HalfedgeId side : sides) add(is_counterclockwise ? side : Complex::opposite(side));
        std::vector<FaceId> inside;
        while (!stack.empty()) {
            const FaceId f = stack.back();
            stack.pop_back();
            inside.push_back(f);
            HalfedgeId h = complex_.halfedge(f);
            for (int i = 0; i < 3; ++i, h = complex_.next(h))
                if (!is_side_[Complex::edge(h)]) add(Complex::opposite(h));
        }
        for (const HalfedgeId side : sides) {
            const FaceId outside = complex_.face(is_counterclockwise ? Complex::opposite(side) : side);
            if (outside.is_valid() && is_inside[outside.index()]) fail("does not separate an inside from an outside");
        }
        for (const FaceId f : inside) complex_.set_label(f, label);
    }

    Complex& complex_;
    core::Attribute<EdgeId, std::uint8_t> is_side_;
    bool touches_others_;
    const core::Observer& observer_;
};

}  // namespace

std::vector<VertexId> insert_polygon(Complex& complex, std::span<const Point2> corners, int label) {
    std::vector<VertexId> along = PolygonInserter(complex, false, {}).insert(corners, label);
    DelaunayPass(complex).run_everywhere(complex);
    return along;
}

void insert_regions(Complex& complex, std::span<const Region> regions, const core::Observer& observer) {
    for (const Region& region : regions) {
        PolygonInserter(complex, true, observer).insert(region.outline, region.label);
        DelaunayPass(complex).run_everywhere(complex);
    }
}

std::vector<std::vector<VertexId>> insert_polygons(Complex& complex, std::span<const std::vector<Point2>> polygons,
                                                   std::span<const int> labels) {
    if (polygons.size() != labels.size()) throw core::UsageError("insert_polygons: one label per polygon is needed");
    std::vector<std::vector<VertexId>> along;
    for (std::size_t i = 0; i < polygons.size(); ++i) along.push_back(insert_polygon(complex, polygons[i], labels[i]));
    return along;
}

}  // namespace dsc::dsc2d
