// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/closed_surface.h"

#include <span>

#include "core/errors.h"
#include "geometry/surface_check.h"
#include "geometry/surface_intersections.h"
#include "io/number.h"

namespace dsc::io {

namespace {

// Enough to find the place by.
constexpr int place_digits = 6;

class Judge {
public:
    Judge(const std::string& source, const geometry::SurfaceData& surface) : source_(source), surface_(surface) {}

    void require_no_edges(std::span<const geometry::SurfaceEdge> edges, const std::string& what,
                          const char* cure) const {
        if (!edges.empty()) fail(edges.size(), place(edges.front()), what, cure);
    }
    void require_no_vertices(std::span<const std::uint32_t> vertices, const std::string& what, const char* cure) const {
        if (!vertices.empty()) fail(vertices.size(), place(vertices.first(1)), what, cure);
    }
    void require_no_triangles(std::span<const std::uint32_t> triangles, const std::string& what,
                              const char* cure) const {
        if (!triangles.empty()) {
            fail(triangles.size(), place(surface_.triangles[triangles.front()]), what, cure);
        }
    }
    [[noreturn]] void fail(std::size_t count, const std::string& where, const std::string& what,
                           const char* cure) const {
        throw core::InputError(source_, where, what + ", one of " + std::to_string(count), cure);
    }

    /// "at (0, 0, 1)", or between several vertices.
    std::string place(std::span<const std::uint32_t> vertices) const {
        std::string text = vertices.size() == 1 ? "at " : "between ";
        for (const std::uint32_t vertex : vertices) {
            if (text.back() == ')') text += ", ";
            text += "(";
            for (const double x : surface_.vertices[vertex]) text += number_text(x, place_digits) + ", ";
            text.replace(text.size() - 2, 2, ")");
        }
        return text;
    }

private:
    const std::string& source_;
    const geometry::SurfaceData& surface_;
};

}  // namespace

void require_closed_surface(const std::string& source, const geometry::SurfaceData& surface) {
    const Judge judge(source, surface);
    const geometry::SurfaceCheck check = geometry::check_surface(surface);
    judge.require_no_triangles(check.degenerate_triangles, "a triangle of no area",
                               "remove it, joining its neighbours");
    judge.require_no_triangles(check.duplicated_triangles, "a triangle that is there twice", "remove one of the two");
    judge.require_no_edges(check.open_edges, "an open edge", "close the holes");
    judge.require_no_edges(check.non_manifold_edges, "an edge of more than two triangles",
                           "separate the sheets that meet there");
    judge.require_no_edges(check.misoriented_edges, "an edge whose two triangles face different sides",
                           "turn one of them over");
    judge.require_no_vertices(check.non_manifold_vertices, "a vertex where the surface is pinched",
                              "double the vertex");
    if (const auto pairs = geometry::self_intersections(surface); !pairs.empty()) {
        judge.fail(pairs.size(), judge.place(surface.triangles[pairs.front()[0]]), "a self-intersection",
                   "separate the triangles that meet");
    }
}

}  // namespace dsc::io
