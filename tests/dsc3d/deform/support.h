// SPDX-License-Identifier: GPL-3.0-or-later
// What several tests of the deformation need: meshes with known regions, a pass to call, and checks that rest on the
// tetrahedra alone.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include "dsc3d/deform/pass_context.h"
#include "dsc3d/generate/fit.h"
#include "dsc3d/generate/lattice.h"
#include "dsc3d/label_statistics.h"
#include "tests/dsc3d/samples.h"
#include "tests/dsc3d/simplices.h"
#include "tests/dsc3d/support.h"

namespace dsc::tests {

/// The unit box; label 1 where the function is negative.
inline dsc3d::Mesh box_with(const std::function<double(const Point3&)>& function, double spacing) {
    dsc3d::Mesh mesh(dsc3d::lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, spacing));
    dsc3d::fit(mesh, function);
    return mesh;
}

/// Cubes of tetrahedra, labelled by the middle of their cube.
inline dsc3d::Mesh cubes_with(const Cells& cells, const std::function<int(const Point3&)>& label) {
    TetData data = box(cells);
    for (const auto& [a, b, c, d] : data.tets) {
        const Point3 p = (data.vertices[a] + data.vertices[b] + data.vertices[c] + data.vertices[d]) / 4;
        data.labels.push_back(label(p.array().floor() + 0.5));
    }
    return dsc3d::Mesh(data);
}

/// The box of 6 x 6 x 3 cubes, of which the middle layer is pressed to this thickness; labels from below.
inline dsc3d::Mesh slab(double thickness, const std::array<int, 3>& labels) {
    TetData data = box({6, 6, 3});
    for (const auto& [a, b, c, d] : data.tets) {
        const double z =
            (data.vertices[a].z() + data.vertices[b].z() + data.vertices[c].z() + data.vertices[d].z()) / 4;
        data.labels.push_back(labels[static_cast<std::size_t>(z)]);
    }
    for (Point3& p : data.vertices)
        if (p.z() > 1) p.z() -= 1 - thickness;
    return dsc3d::Mesh(data);
}

/// A mesh with all that a pass of a step works on. The region is the whole mesh.
struct PassBench {
    PassBench(dsc3d::Mesh& mesh, const dsc3d::DeformParameters& deform)
        : parameters(deform),
          rated(mesh, geometry::QualityMeasure::minimum_sine, dsc3d::FlatSurface::flat_boundary(mesh)),
          wanted_length(mesh, deform.edge_length, deform.growth),
          way(mesh.complex().vertex_attributes(), Point3(Point3::Zero())),
          pull(mesh.complex().vertex_attributes(), Point3(Point3::Zero())) {
        take_all();
    }
    dsc3d::PassContext context() { return {rated, parameters, wanted_length, way, pull, region, listener, report}; }
    void take_all() { region.assign(tets(rated.complex())); }

    dsc3d::DeformParameters parameters;
    dsc3d::RatedMesh rated;
    dsc3d::LocalLength wanted_length;
    core::Attribute<core::VertexId, Point3> way;
    core::Attribute<core::VertexId, Point3> pull;
    dsc3d::Region region;
    dsc3d::Listener listener;
    dsc3d::StepReport report;
};

/// Keeps the events of a step.
class EventList final : public dsc3d::Listener {
public:
    void on_event(const dsc3d::Event& event) override { events.push_back(event); }
    std::vector<dsc3d::Event> events;
};

/// The signed distance from a sphere, negative inside.
inline std::function<double(const Point3&)> distance_from_sphere(const Point3& centre, double radius) {
    return [centre, radius](const Point3& p) { return (p - centre).norm() - radius; };
}

/// The least quality of all tetrahedra.
inline double worst_quality(const PassBench& bench) {
    double worst = 1;
    for (const core::TetId t : tets(bench.rated.complex())) worst = std::min(worst, bench.rated.quality(t));
    return worst;
}

inline std::map<core::VertexId, Point3> places(const dsc3d::Mesh& mesh) {
    std::map<core::VertexId, Point3> found;
    for (const core::VertexId v : vertices(mesh.complex())) found[v] = mesh.position(v);
    return found;
}

/// [degree]
inline double min_dihedral(const dsc3d::Mesh& mesh) {
    double least = 180;
    for (const core::TetId t : tets(mesh.complex())) {
        const dsc3d::TetVertices& v = mesh.complex().vertices(t);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j) {
                // At the edge of the two other vertices.
                const std::size_t k = i == 0 ? (j == 1 ? 2 : 1) : 0, l = 6 - i - j - k;
                const Point3 along = (mesh.position(v[l]) - mesh.position(v[k])).normalized();
                const auto across = [&](core::VertexId u) {
                    const Point3 side = mesh.position(u) - mesh.position(v[k]);
                    return Point3(side - along.dot(side) * along).normalized();
                };
                const double cosine = across(v[i]).dot(across(v[j]));
                least = std::min(least, std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi);
            }
    }
    return least;
}

/// How often, at vertices off the boundary of the domain, the region of a label is no manifold: its triangles of the
/// vertex's link are no disc (or, alone there, no sphere). Edges with several sectors of a label are among these: the
/// triangles meet in a vertex of the link then. Of all labels, or of one.
inline int pinches(const dsc3d::Complex& complex, std::optional<int> of_label = {}) {
    std::map<std::uint32_t, std::map<int, Simplices>> links;  // by vertex and label
    for (const core::TetId t : tets(complex)) {
        const Simplex corners = simplex(complex.vertices(t));
        for (const std::uint32_t v : corners) {
            Simplex opposite = corners;
            opposite.erase(v);
            links[v][complex.label(t)].insert(opposite);
        }
    }
    const auto parts = [](const Simplices& triangles) {  // joined across edges
        std::set<Simplex> open(triangles.begin(), triangles.end());
        int count = 0;
        while (!open.empty()) {
            ++count;
            std::vector<Simplex> front = {*open.begin()};
            open.erase(open.begin());
            while (!front.empty()) {
                const Simplex here = front.back();
                front.pop_back();
                for (const std::uint32_t v : here) {
                    for (auto it = open.begin(); it != open.end();) {
                        Simplex rest = here;
                        rest.erase(v);
                        if (is_face(rest, *it)) {
                            front.push_back(*it);
                            it = open.erase(it);
                        } else {
                            ++it;
                        }
                    }
                }
            }
        }
        return count;
    };
    int found = 0;
    for (const core::VertexId v : vertices(complex)) {
        if (complex.is_boundary(v)) continue;
        const auto& by_label = links[v.index()];
        for (const auto& [label, triangles] : by_label) {
            if (of_label && label != *of_label) continue;
            const int whole = by_label.size() == 1 ? 2 : 1;
            if (parts(triangles) != 1 || euler_characteristic(closure(triangles)) != whole) ++found;
        }
    }
    return found;
}

inline std::map<int, dsc3d::LabelStatistics> statistics_by_label(const dsc3d::Mesh& mesh) {
    std::map<int, dsc3d::LabelStatistics> result;
    for (const dsc3d::LabelStatistics& statistics : dsc3d::label_statistics(mesh))
        result[statistics.label] = statistics;
    return result;
}

}  // namespace dsc::tests
