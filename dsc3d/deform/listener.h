// SPDX-License-Identifier: GPL-3.0-or-later
// What a caller may want to know while a step runs: where the interface got a vertex, lost one, was stopped or changed
// its topology. Handles are valid during the call and, unless the element is removed later, until Complex::compact().
#pragma once

#include "dsc3d/complex/complex.h"
#include "motion/step_report.h"
#include "motion/topology.h"

namespace dsc::dsc3d {

using Event = motion::Event<3>;
using StepReport = motion::StepReport<3>;

class Listener {
public:
    virtual ~Listener() = default;

    /// The interface edge from a to b got the vertex m at parameter s (0 at a, 1 at b).
    virtual void on_interface_split(VertexId m, VertexId a, VertexId b, double s) {
        static_cast<void>(m), static_cast<void>(a), static_cast<void>(b), static_cast<void>(s);
    }
    /// The interface vertex `removed`, which is gone, was merged into `kept`.
    virtual void on_interface_collapse(VertexId removed, VertexId kept) {
        static_cast<void>(removed), static_cast<void>(kept);
    }
    virtual void on_event(const Event& event) { static_cast<void>(event); }
};

}  // namespace dsc::dsc3d
