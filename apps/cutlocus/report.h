// SPDX-License-Identifier: GPL-3.0-or-later
// The results of the program cutlocus as text: CSV of the cut locus, JSON report, a summary to read.
#pragma once

#include <string>
#include <vector>

#include "apps/cutlocus/cutlocus.h"
#include "geodesic/geodesic_flow.h"
#include "io/json.h"

namespace dsc::cutlocus {

/// What the reports say about the question.
struct Question {
    std::string metric_name;
    io::Json metric_parameters;
    Point2 point{0, 0};
};

/// Columns u,v,distance,theta,theta2,arc; the rows of an arc follow it from end to end.
void write_locus_csv(const std::string& path, const geodesic::Metric& metric, const CutGraph& graph);
/// Where a front stopped that was not made exact, arc -1: the middle of two vertices in contact, or a vertex alone.
void write_stops_csv(const std::string& path, const geodesic::Metric& metric, const FrontResult& front);

io::Json locus_json(const geodesic::Metric& metric, const Question& question, const CutLocus& locus, double seconds);
io::Json front_json(const geodesic::Metric& metric, const Question& question, const FrontResult& front, double seconds);
io::Json distance_json(const Point2& target, const std::vector<geodesic::GeodesicState>& geodesics);

std::string locus_summary(const geodesic::Metric& metric, const Question& question, const CutLocus& locus,
                          double seconds);
std::string front_summary(const Question& question, const FrontResult& front, double seconds);
std::string distance_summary(const Point2& target, const std::vector<geodesic::GeodesicState>& geodesics);

}  // namespace dsc::cutlocus
