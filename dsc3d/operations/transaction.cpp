// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/operations/transaction.h"

#include <algorithm>

namespace dsc::dsc3d {

Transaction::Transaction(const Complex& complex)
    : complex_(&complex),
      state_(complex.tet_attributes(), State::untouched),
      is_moved_(complex.vertex_attributes(), std::uint8_t{0}) {}

void Transaction::open() {
    DSC_ASSERT(!is_open_);
    is_open_ = true;
    qualities_before_.clear();
    touched_.clear();
    originals_.clear();
    original_surface_.clear();
    moves_.clear();
    removed_vertices_.clear();
}

void Transaction::close() {
    is_open_ = false;
    for (const TetId t : touched_) state_[t] = State::untouched;
    for (const auto& [v, position] : moves_) is_moved_[v] = 0;
}

std::span<const TetId> Transaction::touched() {
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    std::erase_if(touched_, [&](TetId t) { return complex_->is_deleted(t) || state_[t] == State::untouched; });
    return touched_;
}

void Transaction::note_removal(const Mesh& mesh, const FlatSurface& surface, TetId t, double quality) {
    const Complex& complex = mesh.complex();
    if (state_[t] != State::added) {
        if (state_[t] == State::untouched) qualities_before_.push_back(quality);
        originals_.push_back({complex.vertices(t), complex.label(t)});
        for (const FaceId f : complex.faces(t))
            if (complex.is_surface(f)) original_surface_.push_back({complex.vertices(f), surface.patch(f)});
    }
    state_[t] = State::untouched;
}

void Transaction::note_vertex_removal(const Mesh& mesh, const FlatSurface& surface, VertexId v, double longest_edge) {
    removed_vertices_.push_back({v, mesh.position(v), surface.freedom(v), longest_edge});
}

void Transaction::note_new(TetId t) {
    state_[t] = State::added;
    touched_.push_back(t);
}

void Transaction::note_change(TetId t, double quality) {
    if (state_[t] != State::untouched) return;
    state_[t] = State::changed;
    qualities_before_.push_back(quality);
    touched_.push_back(t);
}

void Transaction::note_move(VertexId v, const Point3& before) {
    if (is_moved_[v] != 0) return;
    is_moved_[v] = 1;
    moves_.emplace_back(v, before);
}

}  // namespace dsc::dsc3d
