// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh before and after as one HTML page: cut open by a plane that the reader moves, coloured by quality, with the
// histograms of all dihedral angles. Both views are turned and cut together.
// Guarantee: as io/html_view; of a larger mesh the worst `most_tets` are shown, and the page says so. Cost: about 35
// bytes of page per tetrahedron shown, and 0.8 MB for the viewer.
#pragma once

#include <cstddef>

#include "apps/improve/report.h"
#include "geometry/tet_data.h"
#include "io/html_view.h"

namespace dsc::improve {

struct HtmlPageParameters {
    std::size_t most_tets = 100'000;  ///< shown per view; > 0
    int threads = 0;                  ///< 0: all
};

/// `after` is the mesh of `improvement.after`, or null when there is none.
io::HtmlPage html_page(const Improvement& improvement, const geometry::TetData& before, const geometry::TetData* after,
                       const HtmlPageParameters& parameters = {});

}  // namespace dsc::improve
