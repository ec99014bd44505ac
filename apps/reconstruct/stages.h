// SPDX-License-Identifier: GPL-3.0-or-later
// The surface at the end of each stage: a series for ParaView, and a page with a slider, the cloud and the figures.
// Guarantee: of a larger cloud the page shows evenly chosen `most_points`, and says so.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/reconstruct/reconstruct.h"
#include "geometry/point_data.h"
#include "io/html_view.h"
#include "io/vtp.h"

namespace dsc::reconstruct {

class Stages {
public:
    /// Writes to FOLDER/series.pvd when there is a folder.
    explicit Stages(const std::optional<std::string>& folder);

    void add(const std::string& stage, const geometry::SurfaceData& surface);

    struct Stage {
        std::string name;
        geometry::SurfaceData surface;
    };
    const std::vector<Stage>& all() const { return stages_; }

private:
    std::vector<Stage> stages_;
    std::optional<io::PvdSeries> files_;
};

struct StagesPageParameters {
    std::size_t most_points = 30'000;  ///< shown; > 0
};

/// The surface coloured by the distance from the nearest point: white where that is 0, red from two spacings on.
io::HtmlPage html_page(const Reconstruction& result, const geometry::PointData& cloud, const Stages& stages,
                       const std::string& title, const StagesPageParameters& parameters = {});

}  // namespace dsc::reconstruct
