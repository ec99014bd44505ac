// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/tetrahedralize.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include "core/errors.h"
#include "core/require.h"
#include "dsc3d/generate/graded_points.h"
#include "dsc3d/generate/tetgen.h"
#include "dsc3d/improve/angle_range.h"
#include "dsc3d/improve/improve.h"
#include "dsc3d/improve/schedule.h"
#include "dsc3d/mesh.h"
#include "geometry/surface_check.h"
#include "geometry/surface_intersections.h"

namespace dsc::dsc3d {

using geometry::InterfaceData;
using geometry::SurfaceData;
using geometry::TetData;

namespace {

using Triangle = std::array<std::uint32_t, 3>;

// ---------------------------------------------------------------------------------------------------------- the input

/// Its cube can still be squared.
constexpr double max_coordinate = 1e100;

void require_usable(const SurfaceData& surface, const Eigen::AlignedBox3d& box) {
    core::require(box.sizes().allFinite() && box.sizes().minCoeff() > 0, "the box has to have a positive size");
    core::require(
        box.min().cwiseAbs().maxCoeff() <= max_coordinate && box.max().cwiseAbs().maxCoeff() <= max_coordinate,
        "a coordinate of the box is beyond 1e100, where volumes overflow; scale the surface");
    core::require(!surface.triangles.empty(), "the surface has no triangles");
    for (const Triangle& triangle : surface.triangles) {
        for (const std::uint32_t v : triangle) {
            core::require(v < surface.vertices.size(), "a triangle of the surface has a vertex that doesn't exist");
            const Point3& p = surface.vertices[v];
            core::require(p.allFinite(), "a coordinate of the surface is not finite");
            if (!((p.array() > box.min().array()).all() && (p.array() < box.max().array()).all())) {
                char text[200];
                std::snprintf(text, sizeof text,
                              "the surface leaves the box at (%.6g, %.6g, %.6g); make the box larger", p.x(), p.y(),
                              p.z());
                throw core::UsageError(text);
            }
        }
    }
    core::require(geometry::self_intersections(surface).empty(), "the surface intersects itself");
}

// Turned when it is inside out.
SurfaceData oriented(const SurfaceData& surface) {
    const geometry::SurfaceCheck check = geometry::check_surface(surface);
    core::require(check.degenerate_triangles.empty() && check.duplicated_triangles.empty(),
                  "the surface has triangles of no area, or twice the same");
    core::require(check.is_closed() && check.is_manifold(), "the surface is not a closed manifold");
    core::require(check.is_oriented() && check.volume, "the triangles of the surface don't agree about its outside");
    SurfaceData result = surface;
    if (*check.volume < 0)
        for (Triangle& triangle : result.triangles) std::swap(triangle[1], triangle[2]);
    return result;
}

// ---------------------------------------------------------------------------------------------------------- the points

// A side of the box: its outline through the points on its edges, and the other ones on it.
PlaneFacet side(const std::vector<Point3>& points, std::uint32_t first, const Eigen::AlignedBox3d& box,
                Eigen::Index axis, double place) {
    const Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
    // The four edges in turn, the points of each in the direction of the walk.
    std::array<std::vector<std::uint32_t>, 4> edges;
    PlaneFacet facet;
    for (std::uint32_t i = first; i < points.size(); ++i) {
        const Point3& p = points[i];
        if (p[axis] != place) continue;
        const bool low_u = p[u] == box.min()[u], high_u = p[u] == box.max()[u];
        const bool low_v = p[v] == box.min()[v], high_v = p[v] == box.max()[v];
        if (low_v && !high_u) {
            edges[0].push_back(i);
        } else if (high_u && !high_v) {
            edges[1].push_back(i);
        } else if (high_v && !low_u) {
            edges[2].push_back(i);
        } else if (low_u) {
            edges[3].push_back(i);
        } else {
            facet.points.push_back(i);
        }
    }
    const std::array<std::pair<Eigen::Index, double>, 4> directions = {{{u, 1}, {v, 1}, {u, -1}, {v, -1}}};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [along, sign] = directions[k];
        std::ranges::sort(edges[k], {},
                          [&, along = along, sign = sign](std::uint32_t i) { return sign * points[i][along]; });
        facet.outline.insert(facet.outline.end(), edges[k].begin(), edges[k].end());
    }
    return facet;
}

TetGenInput tetgen_input(const SurfaceData& surface, const Eigen::AlignedBox3d& box, double growth,
                         core::Observer& observer) {
    TetGenInput input;
    std::vector<std::uint32_t> number(surface.vertices.size(), std::numeric_limits<std::uint32_t>::max());
    for (const Triangle& triangle : surface.triangles) {
        Triangle& corners = input.triangles.emplace_back(triangle);
        for (std::uint32_t& v : corners) {
            if (number[v] >= input.points.size()) {
                number[v] = static_cast<std::uint32_t>(input.points.size());
                input.points.push_back(surface.vertices[v]);
            }
            v = number[v];
        }
    }
    const auto first = static_cast<std::uint32_t>(input.points.size());
    GradedPoints points = graded_points(box, Sizing(surface, growth), observer);
    input.points.insert(input.points.end(), points.on_box.begin(), points.on_box.end());
    input.free_points = std::move(points.inside);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        for (const double place : {box.min()[axis], box.max()[axis]})
            input.facets.push_back(side(input.points, first, box, axis, place));
    return input;
}

// ---------------------------------------------------------------------------------------------------------- the labels

/// Parts of the mesh between which all faces are triangles of the surface.
struct Regions {
    std::uint32_t count = 0;
    std::uint32_t outside = 0;  ///< the one at the box
    std::vector<std::uint32_t> of_tet;
    std::vector<std::array<std::uint32_t, 2>> sides;  ///< of each triangle: the region in front of it and that behind
};

class RegionFinder {
public:
    /// `outer`: a vertex of the box.
    RegionFinder(const TetData& data, const std::vector<Triangle>& triangles, std::uint32_t outer)
        : data_(data), triangles_(triangles), outer_(outer) {}

    Regions run() {
        number_triangles();
        join();
        number_regions();
        return std::move(regions_);
    }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    struct Face {
        std::uint32_t triangle = none;
        std::uint32_t tet = none;  ///< the first one that has it
    };
    static Triangle sorted(Triangle corners) {
        std::ranges::sort(corners);
        return corners;
    }
    std::uint32_t root(std::uint32_t t) {
        while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
        return t;
    }

    void number_triangles() {
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) faces_[sorted(triangles_[i])].triangle = i;
        regions_.sides.assign(triangles_.size(), {none, none});
    }

    void join() {
        parent_.resize(data_.tets.size());
        std::iota(parent_.begin(), parent_.end(), 0u);
        for (std::uint32_t t = 0; t < data_.tets.size(); ++t) {
            const auto& [a, b, c, d] = data_.tets[t];
            // Counterclockwise seen from outside.
            for (const Triangle& corners : {Triangle{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}}) {
                Face& face = faces_[sorted(corners)];
                if (face.triangle != none) {
                    regions_.sides[face.triangle][is_same_turn(corners, triangles_[face.triangle]) ? 1 : 0] = t;
                } else if (face.tet == none) {
                    face.tet = t;
                } else {
                    parent_[root(t)] = root(face.tet);
                }
            }
        }
    }

    static bool is_same_turn(const Triangle& a, const Triangle& b) {
        const auto place = std::ranges::find(b, a[0]) - b.begin();
        return b[static_cast<std::size_t>((place + 1) % 3)] == a[1];
    }

    void number_regions() {
        std::vector<std::uint32_t> number(data_.tets.size(), none);
        for (std::uint32_t t = 0; t < data_.tets.size(); ++t) {
            std::uint32_t& region = number[root(t)];
            if (region == none) region = regions_.count++;
            regions_.of_tet.push_back(region);
            if (std::ranges::count(data_.tets[t], outer_) > 0) regions_.outside = region;
        }
        for (auto& tets : regions_.sides) {
            for (std::uint32_t& side : tets) {
                if (side == none) throw core::RunError("TetGen has not kept a triangle of the surface");
                side = regions_.of_tet[side];
            }
        }
    }

    const TetData& data_;
    const std::vector<Triangle>& triangles_;
    std::uint32_t outer_;
    std::map<Triangle, Face> faces_;
    std::vector<std::uint32_t> parent_;
    Regions regions_;
};

// Winding numbers: one more behind a triangle than in front of it, from 0 outside.
std::vector<int> labels_by_winding(const Regions& regions) {
    std::vector<std::optional<int>> winding(regions.count);
    winding[regions.outside] = 0;
    // Closed surfaces that don't meet separate regions as the edges of a tree do.
    for (bool goes_on = true; goes_on;) {
        goes_on = false;
        for (const auto& [front, back] : regions.sides) {
            if (winding[front].has_value() == winding[back].has_value()) continue;
            goes_on = true;
            if (winding[front]) {
                winding[back] = *winding[front] + 1;
            } else {
                winding[front] = *winding[back] - 1;
            }
        }
    }
    std::vector<int> labels;
    for (const std::optional<int>& number : winding) {
        core::require(number.value_or(-1) >= 0, "a part of the surface is inside out");
        labels.push_back(*number);
    }
    return labels;
}

std::vector<int> labels_by_sides(const Regions& regions, const std::vector<std::array<int, 2>>& sides) {
    std::vector<std::optional<int>> labels(regions.count);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            std::optional<int>& label = labels[regions.sides[i][k]];
            core::require(!label || *label == sides[i][k],
                          "the triangles of the interface disagree about the label of a region, or don't close it");
            label = sides[i][k];
        }
    }
    std::vector<int> result;
    for (const std::optional<int>& label : labels) result.push_back(label.value_or(0));
    return result;
}

// ------------------------------------------------------------------------------------------------------------ all of
// it

// The volume-length ratio first: it likes all edges of a tetrahedron alike, as the deformation does. The smallest angle
// is raised only where that leaves it too small, by single operations, then by compound ones. These take several times
// as long, and would search for ever where the surface leaves no room.
void raise_quality(Mesh& mesh, double min_angle, core::Observer& observer) {
    using geometry::QualityMeasure;
    constexpr std::size_t compound_changes = 50'000;
    ImproveParameters parameters = {.measure = QualityMeasure::volume_length, .changes_boundary = false, .threads = 1};
    const StopCondition stop(observer, std::nullopt);
    const auto is_enough = [&](SchedulePolicy&& schedule) {
        ImproveRun run(mesh, parameters, observer, stop);
        if (run.goes_on("improving")) schedule.run(run);
        if (run.report.end == ImproveEnd::cancelled) throw core::Cancelled();
        return AngleRange(mesh).min >= min_angle * std::numbers::pi / 180;
    };
    if (is_enough(ThesisSchedule({}))) return;
    parameters.measure = QualityMeasure::minimum_biased_sine;
    parameters.target_angle = min_angle;
    if (is_enough(ThesisSchedule({}))) return;
    is_enough(BestSchedule({.budget = compound_changes}));
}

template <class LabelsOf>
TetData tetrahedralization(const SurfaceData& surface, const Eigen::AlignedBox3d& box,
                           const TetrahedralizeParameters& parameters, core::Observer& observer, LabelsOf&& labels_of) {
    parameters.validate();
    require_usable(surface, box);
    observer.progress("making tetrahedra", -1, "");
    const TetGenInput input = tetgen_input(surface, box, parameters.growth, observer);
    TetData data = tetgen(input, parameters.tetgen, observer);
    const Regions regions = RegionFinder(data, input.triangles, input.facets.front().outline.front()).run();
    const std::vector<int> labels = labels_of(regions);
    for (const std::uint32_t region : regions.of_tet) data.labels.push_back(labels[region]);
    observer.check_cancelled();

    Mesh mesh(data);
    raise_quality(mesh, parameters.min_angle, observer);
    return mesh.data();
}

}  // namespace

void TetrahedralizeParameters::validate() const {
    core::require(growth >= 0 && growth <= 2, "growth: has to be in [0, 2]");
    core::require(min_angle > 0 && min_angle <= 40, "min_angle: has to be in (0, 40]");
}

TetData tetrahedralize(const SurfaceData& surface, const Eigen::AlignedBox3d& box,
                       const TetrahedralizeParameters& parameters, core::Observer& observer) {
    return tetrahedralization(oriented(surface), box, parameters, observer, labels_by_winding);
}

TetData tetrahedralize(const InterfaceData& interface, const Eigen::AlignedBox3d& box,
                       const TetrahedralizeParameters& parameters, core::Observer& observer) {
    core::require(interface.sides.size() == interface.surface.triangles.size(),
                  "the interface has not as many pairs of labels as triangles");
    return tetrahedralization(interface.surface, box, parameters, observer,
                              [&](const Regions& regions) { return labels_by_sides(regions, interface.sides); });
}

}  // namespace dsc::dsc3d
