// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.h"

namespace dsc::dsc3d {

using geometry::SurfaceData;

namespace {

using std::numbers::pi;
using Triangle = std::array<std::uint32_t, 3>;

constexpr double max_shape_triangles = 1e8;
/// Distance of the rows of vertices in a plane of regular triangles, in edge lengths.
const double row_distance = std::sqrt(0.75);

void require_shape(bool condition, const char* shape, const char* what) {
    if (!condition) throw core::UsageError(std::string(shape) + ": " + what);
}

void require_length(double length, const char* shape, const char* name) {
    if (!(length > 0) || !std::isfinite(length))
        throw core::UsageError(std::string(shape) + ": the " + name + " has to be positive");
}

std::uint32_t count(double length, double part, double least) {
    return static_cast<std::uint32_t>(std::max(least, std::round(length / part)));
}

SurfaceData icosahedron() {
    constexpr double t = std::numbers::phi;
    SurfaceData surface;
    surface.vertices = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                        {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    for (Point3& p : surface.vertices) p.normalize();
    surface.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                         {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                         {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    return surface;
}

// Every triangle in parts^2, on the unit sphere.
class Subdivision {
public:
    Subdivision(const SurfaceData& coarse, std::uint32_t parts) : coarse_(coarse), parts_(parts) {}

    SurfaceData run() {
        fine_.vertices = coarse_.vertices;
        for (const Triangle& triangle : coarse_.triangles) divide(triangle);
        return std::move(fine_);
    }

private:
    void divide(const Triangle& triangle) {
        inner_.clear();
        const auto at = [&](std::uint32_t i, std::uint32_t j) { return vertex(triangle, i, j); };
        for (std::uint32_t i = 0; i < parts_; ++i) {
            for (std::uint32_t j = 0; i + j < parts_; ++j) {
                fine_.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
                if (i + j + 1 < parts_) fine_.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        }
    }

    // i steps towards the second corner, j towards the third.
    std::uint32_t vertex(const Triangle& triangle, std::uint32_t i, std::uint32_t j) {
        const std::uint32_t k = parts_ - i - j;
        if (i == 0 && j == 0) return triangle[0];
        if (j == 0 && k == 0) return triangle[1];
        if (k == 0 && i == 0) return triangle[2];
        if (j == 0) return on_edge(triangle[0], triangle[1], i);
        if (k == 0) return on_edge(triangle[1], triangle[2], j);
        if (i == 0) return on_edge(triangle[2], triangle[0], k);
        const auto [place, is_new] = inner_.try_emplace({i, j}, next());
        if (is_new)
            add(k * coarse_.vertices[triangle[0]] + i * coarse_.vertices[triangle[1]] +
                j * coarse_.vertices[triangle[2]]);
        return place->second;
    }

    std::uint32_t on_edge(std::uint32_t a, std::uint32_t b, std::uint32_t step) {
        if (a > b) std::swap(a, b), step = parts_ - step;
        const auto [place, is_new] = on_edges_.try_emplace({a, b, step}, next());
        if (is_new) add((parts_ - step) * coarse_.vertices[a] + step * coarse_.vertices[b]);
        return place->second;
    }

    std::uint32_t next() const { return static_cast<std::uint32_t>(fine_.vertices.size()); }
    void add(const Point3& direction) { fine_.vertices.push_back(direction.normalized()); }

    const SurfaceData& coarse_;
    std::uint32_t parts_;
    SurfaceData fine_;
    std::map<Triangle, std::uint32_t> on_edges_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> inner_;  ///< of one triangle
};

// Rings of vertices around an axis, one after the other, joined to a closed surface with a pole at either end.
class Rings {
public:
    explicit Rings(const Point3& pole) { surface_.vertices.push_back(pole); }

    void add(const std::vector<Point3>& ring) {
        const std::uint32_t first = size();
        surface_.vertices.insert(surface_.vertices.end(), ring.begin(), ring.end());
        if (last_count_ == 0) {
            for (std::uint32_t i = first; i < size(); ++i)
                surface_.triangles.push_back({0, i + 1 < size() ? i + 1 : first, i});
        } else {
            join(last_first_, last_count_, first, static_cast<std::uint32_t>(ring.size()));
        }
        last_first_ = first;
        last_count_ = static_cast<std::uint32_t>(ring.size());
    }

    SurfaceData close(const Point3& pole) {
        const std::uint32_t top = size();
        surface_.vertices.push_back(pole);
        for (std::uint32_t i = 0; i < last_count_; ++i)
            surface_.triangles.push_back({top, last_first_ + i, last_first_ + (i + 1) % last_count_});
        return std::move(surface_);
    }

private:
    std::uint32_t size() const { return static_cast<std::uint32_t>(surface_.vertices.size()); }

    // Around once, by the shorter one of the two edges that can come next each time.
    void join(std::uint32_t lower, std::uint32_t lower_count, std::uint32_t upper, std::uint32_t upper_count) {
        const auto low = [&](std::uint32_t i) { return lower + i % lower_count; };
        const std::uint32_t start = nearest(lower, upper, upper_count);
        const auto high = [&](std::uint32_t j) { return upper + (start + j) % upper_count; };
        const auto length = [&](std::uint32_t a, std::uint32_t b) {
            return (surface_.vertices[a] - surface_.vertices[b]).squaredNorm();
        };
        for (std::uint32_t i = 0, j = 0; i < lower_count || j < upper_count;) {
            const bool goes_below =
                j == upper_count || (i < lower_count && length(low(i + 1), high(j)) < length(low(i), high(j + 1)));
            if (goes_below) {
                surface_.triangles.push_back({low(i), low(i + 1), high(j)});
                ++i;
            } else {
                surface_.triangles.push_back({low(i), high(j + 1), high(j)});
                ++j;
            }
        }
    }

    // Place in the ring of the vertex that is nearest to v.
    std::uint32_t nearest(std::uint32_t v, std::uint32_t first, std::uint32_t ring) const {
        std::uint32_t best = 0;
        const auto distance = [&](std::uint32_t j) {
            return (surface_.vertices[first + j] - surface_.vertices[v]).squaredNorm();
        };
        for (std::uint32_t j = 1; j < ring; ++j)
            if (distance(j) < distance(best)) best = j;
        return best;
    }

    SurfaceData surface_;
    std::uint32_t last_first_ = 0, last_count_ = 0;
};

// Half of the profile of a dumbbell, by its length from the pole: an arc of a ball, then one of the neck.
class DumbbellProfile {
public:
    explicit DumbbellProfile(const DumbbellSize& size)
        : size_(size),
          arc_radius_((size.half_distance * size.half_distance + size.neck_radius * size.neck_radius -
                       size.ball_radius * size.ball_radius) /
                      (2 * (size.ball_radius - size.neck_radius))),
          slope_(std::atan2(size.neck_radius + arc_radius_, size.half_distance)) {}

    double ball_length() const { return size_.ball_radius * (pi - slope_); }
    double length() const { return ball_length() + arc_radius_ * (pi / 2 - slope_); }

    /// Distance from the plane of symmetry, and from the axis.
    std::pair<double, double> place(double s) const {
        if (s < ball_length()) {
            const double angle = s / size_.ball_radius;
            return {size_.half_distance + size_.ball_radius * std::cos(angle), size_.ball_radius * std::sin(angle)};
        }
        const double angle = (length() - s) / arc_radius_;
        return {arc_radius_ * std::sin(angle), size_.neck_radius + arc_radius_ * (1 - std::cos(angle))};
    }

private:
    DumbbellSize size_;
    double arc_radius_;  ///< of the neck
    double slope_;       ///< angle between the axis and the line that joins the centres of ball and arc
};

}  // namespace

SurfaceData icosphere(const Point3& centre, double radius, std::uint32_t frequency) {
    require_length(radius, "sphere", "radius");
    require_shape(frequency > 0 && 20.0 * frequency * frequency <= max_shape_triangles, "sphere",
                  "the frequency has to be at least 1, and there can be no more than 1e8 triangles");
    SurfaceData surface = icosahedron();
    std::uint32_t halvings = 0;
    while (frequency % 2 == 0) frequency /= 2, ++halvings;
    surface = Subdivision(surface, frequency).run();
    for (; halvings > 0; --halvings) surface = Subdivision(surface, 2).run();
    for (Point3& p : surface.vertices) p = centre + radius * p;
    return surface;
}

std::uint32_t icosphere_frequency(double radius, double edge_length) {
    require_length(radius, "sphere", "radius");
    require_length(edge_length, "sphere", "edge length");
    // The triangles share the area of the sphere.
    const double triangles = 4 * pi * radius * radius / (row_distance / 2 * edge_length * edge_length);
    require_shape(triangles <= max_shape_triangles, "sphere", "the edge length is too small: more than 1e8 triangles");
    return std::max(1u, static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 20))));
}

SurfaceData two_spheres(const Point3& centre, double radius, double gap, std::uint32_t frequency) {
    require_length(gap, "two-spheres", "gap");
    const Point3 shift(radius + gap / 2, 0, 0);
    SurfaceData surface = icosphere(centre - shift, radius, frequency);
    const SurfaceData other = icosphere(centre + shift, radius, frequency);
    const auto first = static_cast<std::uint32_t>(surface.vertices.size());
    surface.vertices.insert(surface.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.triangles) surface.triangles.push_back({a + first, b + first, c + first});
    return surface;
}

SurfaceData torus(const Point3& centre, double major, double minor, double edge_length) {
    require_length(major, "torus", "major radius");
    require_length(minor, "torus", "minor radius");
    require_length(edge_length, "torus", "edge length");
    require_shape(minor < major, "torus", "the minor radius has to be smaller than the major one");
    require_shape(4 * pi * pi * major * minor <= max_shape_triangles / 4 * edge_length * edge_length, "torus",
                  "the edge length is too small: more than 1e8 triangles");
    // Rows along the large circle, every other one moved by half an edge.
    const std::uint32_t columns = count(2 * pi * major, edge_length, 3);
    const std::uint32_t rows = 2 * count(pi * minor, row_distance * edge_length, 2);
    SurfaceData surface;
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            const double u = 2 * pi * (i + 0.5 * (j % 2)) / columns, v = 2 * pi * j / rows;
            const double rho = major + minor * std::cos(v);
            surface.vertices.push_back(centre + Point3(rho * std::cos(u), rho * std::sin(u), minor * std::sin(v)));
        }
    }
    const auto vertex = [&](std::uint32_t i, std::uint32_t j) { return j % rows * columns + i % columns; };
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t shift = j % 2;
            surface.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + shift, j + 1)});
            surface.triangles.push_back({vertex(i + 1, j), vertex(i + 1 + shift, j + 1), vertex(i + shift, j + 1)});
        }
    }
    return surface;
}

SurfaceData dumbbell(const Point3& centre, const DumbbellSize& size, double edge_length) {
    require_length(size.half_distance, "dumbbell", "distance of the balls");
    require_length(size.ball_radius, "dumbbell", "radius of the balls");
    require_length(size.neck_radius, "dumbbell", "radius of the neck");
    require_length(edge_length, "dumbbell", "edge length");
    require_shape(size.neck_radius < size.ball_radius, "dumbbell", "the neck has to be thinner than the balls");
    require_shape(size.ball_radius < size.half_distance, "dumbbell",
                  "the radius of the balls has to be less than half their distance");
    const DumbbellProfile profile(size);
    require_shape(4 * pi * profile.length() * size.ball_radius <= max_shape_triangles / 4 * edge_length * edge_length,
                  "dumbbell", "the edge length is too small: more than 1e8 triangles");
    const std::uint32_t half_rows = count(profile.length(), row_distance * edge_length, 2);
    Rings rings(centre - Point3(size.half_distance + size.ball_radius, 0, 0));
    double phase = 0;
    for (std::uint32_t j = 1; j < 2 * half_rows; ++j) {
        const auto [x, rho] = profile.place(profile.length() * std::min(j, 2 * half_rows - j) / half_rows);
        std::vector<Point3> ring(count(2 * pi * rho, edge_length, 5));
        const double step = 2 * pi / static_cast<double>(ring.size());
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const double angle = phase + step * static_cast<double>(i);
            ring[i] = centre + Point3(j < half_rows ? -x : x, rho * std::cos(angle), rho * std::sin(angle));
        }
        rings.add(ring);
        phase += step / 2;
    }
    return rings.close(centre + Point3(size.half_distance + size.ball_radius, 0, 0));
}

}  // namespace dsc::dsc3d
