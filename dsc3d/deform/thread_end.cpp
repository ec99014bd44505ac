// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/thread_end.h"

#include <algorithm>

#include "core/sort_unique.h"

namespace dsc::dsc3d {

bool ThreadEnd::find(PassContext& context, VertexId v) {
    const Complex& complex = context.complex();
    if (context.parameters.topology != motion::TopologyPolicy::preserved) return false;
    if (complex.is_deleted(v) || !complex.is_interface(v) || complex.is_boundary(v) || !is_thin(context, v))
        return false;
    gather_spokes(context, v);
    return goes_one_way(context, v);
}

bool ThreadEnd::is_thin(PassContext& context, VertexId v) {
    volumes_.clear();
    for (const TetId t : context.mesh.walker().star(v)) {
        const int label = context.complex().label(t);
        auto entry = std::find_if(volumes_.begin(), volumes_.end(), [&](const auto& e) { return e.first == label; });
        if (entry == volumes_.end()) entry = volumes_.insert(entry, {label, 0.0});
        entry->second += context.volume(t);
    }
    if (volumes_.size() > 2) return false;
    const double length = context.wanted_length.at(v);
    const double thin = context.parameters.thread_volume * length * length * length;
    return std::any_of(volumes_.begin(), volumes_.end(), [&](const auto& entry) { return entry.second < thin; });
}

void ThreadEnd::gather_spokes(PassContext& context, VertexId v) {
    const Complex& complex = context.complex();
    spokes_.clear();
    for (const TetId t : context.mesh.walker().star(v))
        for (const EdgeId e : complex.edges(t)) {
            const auto [a, b] = complex.vertices(e);
            if ((a == v || b == v) && complex.is_interface(e)) spokes_.emplace_back(context.length(e), e);
        }
    core::sort_unique(spokes_);
}

bool ThreadEnd::goes_one_way(const PassContext& context, VertexId v) {
    constexpr double least_cosine = 0.5;  // of the angle between a spoke and their mean
    const double degenerate = context.parameters.degenerate_edge * context.wanted_length.at(v);
    const auto direction = [&](EdgeId e) {
        const auto [a, b] = context.complex().vertices(e);
        const Eigen::Vector3d along = context.mesh.position(b) - context.mesh.position(a);
        return Eigen::Vector3d((a == v ? along : -along).normalized());
    };
    const auto first =
        std::find_if(spokes_.begin(), spokes_.end(), [&](const auto& s) { return s.first > degenerate; });
    if (first == spokes_.end()) return false;
    shortest_along_ = first->second;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    std::for_each(first, spokes_.end(), [&](const auto& spoke) { mean += direction(spoke.second); });
    mean.normalize();
    return std::all_of(first, spokes_.end(),
                       [&](const auto& spoke) { return direction(spoke.second).dot(mean) > least_cosine; });
}

}  // namespace dsc::dsc3d
