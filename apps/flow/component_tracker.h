// SPDX-License-Identifier: GPL-3.0-or-later
// Knows the connected components of all labels, and which of them are no longer there. The same in space and in the
// plane: `Cells` says what the cells of a mesh are. Cost: linear in the mesh.
//
//     struct Cells {
//         using Mesh, Handle, Place;
//         static auto attributes(const Mesh&);              // the registry of the cells
//         static std::uint32_t capacity(const Mesh&);
//         static bool is_deleted(const Mesh&, Handle);
//         static int label(const Mesh&, Handle);
//         static Place centroid(const Mesh&, Handle);
//         static core::DisjointSets components(const Mesh&);
//     };
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "core/attribute.h"
#include "core/disjoint_sets.h"

namespace dsc::flow {

template <class Cells>
class ComponentTracker {
public:
    using Mesh = typename Cells::Mesh;
    using Handle = typename Cells::Handle;

    struct Component {
        int label = 0;
        typename Cells::Place centroid;  ///< of one of its cells, on a torus in whatever period
    };

    explicit ComponentTracker(const Mesh& mesh) : component_(Cells::attributes(mesh), 0u) { number_components(mesh); }

    /// Those that have vanished since the last call.
    std::vector<Component> update(const Mesh& mesh) {
        std::vector<std::uint8_t> is_there(components_.size(), 0);
        for_each_cell(mesh, [&](Handle cell) {
            if (component_[cell] == 0) return;
            if (components_[component_[cell] - 1].label == Cells::label(mesh, cell)) is_there[component_[cell] - 1] = 1;
        });
        std::vector<Component> vanished;
        std::map<int, std::int64_t> lost;
        for (std::size_t i = 0; i < components_.size(); ++i) {
            ++lost[components_[i].label];
            if (is_there[i] == 0) vanished.push_back(components_[i]);
        }
        number_components(mesh);
        for (const Component& component : components_) --lost[component.label];
        // A component may have got new cells throughout: one is gone only when there are fewer.
        std::erase_if(vanished, [&](const Component& component) { return lost[component.label]-- <= 0; });
        return vanished;
    }

private:
    template <class Use>
    static void for_each_cell(const Mesh& mesh, Use&& use) {
        for (std::uint32_t i = 0; i < Cells::capacity(mesh); ++i)
            if (!Cells::is_deleted(mesh, Handle(i))) use(Handle(i));
    }

    void number_components(const Mesh& mesh) {
        core::DisjointSets parts = Cells::components(mesh);
        components_.clear();
        for_each_cell(mesh, [&](Handle cell) {
            const Handle first(parts.find(cell.index()));
            if (first == cell) {
                components_.push_back({Cells::label(mesh, cell), Cells::centroid(mesh, cell)});
                component_[cell] = static_cast<std::uint32_t>(components_.size());
            } else {
                component_[cell] = component_[first];
            }
        });
    }

    core::Attribute<Handle, std::uint32_t> component_;  ///< from 1; 0: a new cell
    std::vector<Component> components_;
};

}  // namespace dsc::flow
