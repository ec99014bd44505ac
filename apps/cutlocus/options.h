// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of the program cutlocus: what is asked for, checked.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/common/command_line.h"
#include "apps/cutlocus/cutlocus.h"
#include "geodesic/metric.h"

namespace dsc::cutlocus {

struct Options {
    std::unique_ptr<geodesic::Metric> metric;
    std::string metric_name;       ///< as a reader knows it: "torus of revolution, R = 2, lambda = 2"
    io::Json metric_parameters;    ///< for the report
    std::string metric_source;     ///< the option it came from, for error messages
    std::string note;              ///< what to know about the surface, where it is not what it seems; empty: nothing
    Point2 point{0, 0};            ///< p, wrapped into the chart
    std::optional<Point2> target;  ///< --distance
    std::optional<std::string> points_file;
    bool is_resumed = false;
    bool is_front_only = false;  ///< --method front
    double time_step = 0.05;     ///< of --method front
    CutLocusParameters parameters;
    std::optional<std::string> svg, svg_geodesics, svg_front, html, fronts;
    std::optional<std::string> default_picture;  ///< written where nothing else is asked for
    apps::CommonOptions common;
    io::Json given;
};

/// Nothing when --help or --version was asked for. Throws core::UsageError and core::InputError.
std::optional<Options> parse_options(int argc, const char* const* argv);

/// "u,v": two numbers, each of which may be a multiple of pi ("0,0.15pi"). Throws core::UsageError naming `option`.
Point2 parse_chart_pair(const std::string& text, const std::string& option);

}  // namespace dsc::cutlocus
