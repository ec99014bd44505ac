// SPDX-License-Identifier: GPL-3.0-or-later
// A result of the program improve for the tests of what is said and drawn of it: a shaken box, and the box itself as if
// it were the improved mesh.
#pragma once

#include "apps/improve/report.h"
#include "tests/apps/improve/box_mesh.h"

namespace dsc::tests {

struct ImprovedBox {
    geometry::TetData before = shaken_box(4);
    geometry::TetData after = box_mesh(4);
    improve::Improvement improvement;

    ImprovedBox() {
        const auto measure = improvement.parameters.measure;
        improvement.input = "folder/box.mesh";
        improvement.before = improve::mesh_statistics(before, measure);
        improvement.after = improve::mesh_statistics(after, measure);
        improvement.run = dsc3d::ImproveReport{.seconds = 1.5,
                                               .rounds = 4,
                                               .smoothings = 11,
                                               .edge_removals = 12,
                                               .multi_face_removals = 13,
                                               .multi_face_retriangulations = 14,
                                               .collapses = 15,
                                               .escapes = 16};
    }
    /// As after --report.
    improve::Improvement judged() const {
        improve::Improvement only = improvement;
        only.after.reset();
        only.run.reset();
        return only;
    }
};

}  // namespace dsc::tests
