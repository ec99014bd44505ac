// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/label_statistics.h"

#include <map>

#include "dsc2d/components.h"

namespace dsc::dsc2d {

std::vector<LabelStatistics> label_statistics(const Complex& complex) {
    std::map<int, LabelStatistics> labels;
    std::map<int, std::int64_t> euler;
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        const FaceId f(i);
        if (complex.is_deleted(f)) continue;
        LabelStatistics& statistics = labels[complex.label(f)];
        ++statistics.triangles;
        statistics.area += complex.area(f);
        ++euler[complex.label(f)];
    }
    for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i) {
        const EdgeId e(i);
        if (complex.is_deleted(e)) continue;
        const HalfedgeId h = Complex::halfedge(e);
        const FaceId left = complex.face(h), right = complex.face(Complex::opposite(h));
        if (!complex.is_boundary(e) && !complex.is_interface(e)) {
            --euler[complex.label(left)];
            continue;
        }
        for (const FaceId f : {left, right}) {
            if (!f.is_valid()) continue;
            LabelStatistics& statistics = labels[complex.label(f)];
            (complex.is_boundary(e) ? statistics.boundary_length : statistics.interface_length) += complex.length(h);
        }
    }
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
        const VertexId v(i);
        if (!complex.is_deleted(v) && !complex.is_interface(v) && !complex.is_boundary(v))
            ++euler[complex.label(complex.face(complex.halfedge(v)))];
    }
    core::DisjointSets parts = components(complex);
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i)
        if (!complex.is_deleted(FaceId(i)) && parts.find(i) == i) ++labels[complex.label(FaceId(i))].components;

    std::vector<LabelStatistics> result;
    for (auto& [label, statistics] : labels) {
        statistics.label = label;
        statistics.holes = statistics.components - euler[label];
        result.push_back(statistics);
    }
    return result;
}

}  // namespace dsc::dsc2d
