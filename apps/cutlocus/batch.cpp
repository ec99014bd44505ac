// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/batch.h"

#include <fmt/core.h>

#include <filesystem>
#include <sstream>

#include "apps/cutlocus/report.h"
#include "core/errors.h"
#include "io/atomic_file.h"

namespace dsc::cutlocus {

std::vector<Point2> read_points(const std::string& path) {
    std::vector<Point2> points;
    std::istringstream lines(io::read_file(path));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::erase_if(line, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
        if (line.empty() || line.starts_with('#')) continue;
        try {
            points.push_back(parse_chart_pair(line, "point"));
        } catch (const core::UsageError&) {
            throw core::InputError(path, "line " + std::to_string(number), "'" + line + "' is not a point",
                                   "write u,v, e.g. 0,0.15pi");
        }
    }
    if (points.empty()) throw core::InputError(path, "", "there are no points in it", "write one u,v per line");
    return points;
}

int run_batch(const Options& options, core::Observer& observer) {
    const std::vector<Point2> points = read_points(*options.points_file);
    const std::filesystem::path folder = *options.common.output;
    io::require_writable_folder(folder);
    int failed = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::string stem = (folder / fmt::format("{:04}", i + 1)).string();
        if (options.is_resumed && std::filesystem::exists(stem + ".json")) continue;
        const Question question{options.metric_name, options.metric_parameters,
                                options.metric->periods().wrapped(points[i])};
        const CutLocus locus = cut_locus(*options.metric, question.point, options.parameters, observer);
        const double seconds = locus.front_seconds + locus.exact_seconds;
        // The JSON file comes last: it says that the point is done.
        write_locus_csv(stem + ".csv", *options.metric, locus.graph);
        io::write_file(stem + ".json", locus_json(*options.metric, question, locus, seconds).dump(1) + "\n");
        const Certificate& certificate = locus.graph.certificate;
        fmt::print("{} ({:.9f}, {:.9f}) {} vertices, {} arcs, length {:.9f}, {}\n", i + 1, question.point.x(),
                   question.point.y(), locus.graph.vertices.size(), locus.graph.arcs.size(), locus.graph.length,
                   certificate.holds() ? "certificate holds" : "certificate FAILS: " + certificate.failures.front());
        failed += certificate.holds() ? 0 : 1;
    }
    return failed;
}

}  // namespace dsc::cutlocus
