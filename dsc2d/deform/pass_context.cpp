// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/deform/pass_context.h"

#include "dsc2d/operations/collapse.h"

namespace dsc::dsc2d {

void PassContext::collapse_and_tell(HalfedgeId h) {
    const VertexId kept = complex.to(h);
    if (complex.is_interface(complex.from(h))) listener.on_interface_collapse(complex.from(h), kept);
    collapse(complex, h);
    ++report.counts.collapses;
    active.add(kept);
    for (const HalfedgeId out : complex.outgoing(kept)) active.add(complex.to(out));
}

}  // namespace dsc::dsc2d
