// SPDX-License-Identifier: GPL-3.0-or-later
// What a caller may want to know while a deformation step runs: where the interface got a vertex, lost one, was stopped
// or changed its topology. Shared by 2D and 3D. Handles are valid during the call and, unless the element is removed
// later, until the complex is compacted.
#pragma once

#include "core/handles.h"
#include "motion/step_report.h"
#include "motion/topology.h"

namespace dsc::motion {

template <int Dimension>
class Listener {
public:
    virtual ~Listener() = default;

    /// The interface edge from a to b got the vertex m at parameter s (0 at a, 1 at b), or beside it where the
    /// interface is curved.
    virtual void on_interface_split(core::VertexId m, core::VertexId a, core::VertexId b, double s) {
        static_cast<void>(m), static_cast<void>(a), static_cast<void>(b), static_cast<void>(s);
    }
    /// The interface vertex `removed` goes into `kept`. In the plane it is still there, in space it is gone already.
    virtual void on_interface_collapse(core::VertexId removed, core::VertexId kept) {
        static_cast<void>(removed), static_cast<void>(kept);
    }
    /// A contact that the topology policy holds.
    virtual void on_contact(const Contact<Dimension>& contact) { static_cast<void>(contact); }
    virtual void on_event(const Event<Dimension>& event) { static_cast<void>(event); }
};

}  // namespace dsc::motion
