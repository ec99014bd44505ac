// SPDX-License-Identifier: GPL-3.0-or-later
// What every pass of a step gets: the complex, the thresholds, and the active set, which is the vertices that moved or
// whose star changed. Passes visit the active set only, and add to it what they change.
#pragma once

#include <span>
#include <vector>

#include "dsc2d/complex.h"
#include "dsc2d/deform/listener.h"
#include "dsc2d/deform/parameters.h"

namespace dsc::dsc2d {

/// Vertices in the order in which they became active, each at most once.
class ActiveSet {
public:
    explicit ActiveSet(const Complex& complex) : is_member_(complex.vertex_attributes(), 0) {}

    void add(VertexId v) {
        if (is_member_[v]) return;
        is_member_[v] = 1;
        members_.push_back(v);
    }
    void clear() {
        for (const VertexId v : members_) is_member_[v] = 0;
        members_.clear();
    }
    /// To be walked by index: a pass may add while it walks.
    std::size_t size() const { return members_.size(); }
    VertexId operator[](std::size_t i) const { return members_[i]; }
    std::span<const VertexId> members() const { return members_; }

private:
    std::vector<VertexId> members_;
    core::Attribute<VertexId, std::uint8_t> is_member_;
};

struct PassContext {
    Complex& complex;
    const Parameters& parameters;
    ActiveSet& active;
    Listener& listener;
    StepReport& report;

    double absolute(double in_edge_lengths) const { return in_edge_lengths * parameters.edge_length; }

    /// A vertex that only serves the mesh: passes may move and remove it.
    bool is_steiner(VertexId v) const {
        return !complex.is_interface(v) && !complex.is_locked(v) && !complex.is_boundary(v);
    }
    /// Removes from(h), tells the listener when that was a vertex of the interface, and activates the ring.
    void collapse_and_tell(HalfedgeId h);
};

}  // namespace dsc::dsc2d
