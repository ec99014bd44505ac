// SPDX-License-Identifier: GPL-3.0-or-later
// The program cutlocus: see `cutlocus --help` and docs/guide.md.
#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "apps/common/progress.h"
#include "apps/common/run_main.h"
#include "apps/cutlocus/batch.h"
#include "apps/cutlocus/distance.h"
#include "apps/cutlocus/options.h"
#include "apps/cutlocus/picture/front_series.h"
#include "apps/cutlocus/picture/html_page.h"
#include "apps/cutlocus/picture/svg_chart.h"
#include "apps/cutlocus/picture/svg_front.h"
#include "apps/cutlocus/report.h"
#include "core/errors.h"
#include "core/stopwatch.h"
#include "io/atomic_file.h"

namespace dsc::cutlocus {

namespace {

/// Writes the files asked for; returns what there is to say about them.
std::string write_results(const Options& options, const CutLocus& locus) {
    const geodesic::Metric& metric = *options.metric;
    const ChartStyle style{.surface = options.metric_name};
    if (options.common.output) write_locus_csv(*options.common.output, metric, locus.graph);
    if (options.svg) io::write_file(*options.svg, svg_chart(metric, options.point, locus, style));
    if (options.svg_geodesics)
        io::write_file(*options.svg_geodesics, svg_geodesics(metric, options.point, locus, style));
    if (options.svg_front) io::write_file(*options.svg_front, svg_front(metric, options.point, locus.front, style));
    if (options.html) write_html(*options.html, metric, options.point, locus, style);
    if (options.fronts) write_front_series(*options.fronts, metric, options.point, locus.front);
    if (!options.default_picture) return "";
    if (std::filesystem::exists(*options.default_picture))
        return "no picture: " + *options.default_picture + " is there already; --svg FILE writes to any file\n";
    try {
        io::write_file(*options.default_picture, svg_chart(metric, options.point, locus, style));
    } catch (const core::Error&) {
        return "no picture: this folder can't be written to\n";  // nobody asked for one by name
    }
    return "picture: " + *options.default_picture + "\n";
}

int run_exact(const Options& options, const Question& question, apps::ProgressObserver& observer) {
    const core::Stopwatch watch;
    const geodesic::Metric& metric = *options.metric;
    const CutLocus locus = cut_locus(metric, options.point, options.parameters, observer);
    io::Json report = locus_json(metric, question, locus, watch.seconds());
    std::string summary = locus_summary(metric, question, locus, watch.seconds());
    if (options.target) {
        const auto geodesics =
            minimising_geodesics(metric, options.point, locus.graph, *options.target, options.parameters.tolerance);
        report["distance_to"] = distance_json(*options.target, geodesics);
        summary += distance_summary(*options.target, geodesics);
    }
    // The report says what is wrong where the certificate fails; a doubtful result overwrites nothing else.
    if (options.common.json) io::write_file(*options.common.json, report.dump(1) + "\n");
    const bool holds = locus.graph.certificate.holds();
    if (holds) summary += write_results(options, locus);
    observer.clear();
    if (!options.common.output || options.target || !holds) fmt::print("{}", summary);
    if (holds) return apps::exit_done;
    throw core::RunError("the certificate does not hold: " + locus.graph.certificate.failures.front());
}

int run_front(const Options& options, const Question& question, apps::ProgressObserver& observer) {
    const core::Stopwatch watch;
    const double size = options.parameters.max_distance ? *options.parameters.max_distance
                                                        : std::sqrt(geodesic::total_area(*options.metric));
    if (options.time_step < 1e-4 * size || options.time_step > 0.1 * size)
        throw core::UsageError(
            fmt::format("--time-step must lie between {:.3g} and {:.3g} on this surface", 1e-4 * size, 0.1 * size));
    FrontParameters parameters = plain_front(options.time_step);
    parameters.max_distance = options.parameters.max_distance;
    parameters.snapshots = options.parameters.snapshots;
    const FrontResult front = grow_front(*options.metric, options.point, parameters, observer);
    if (options.common.output) write_stops_csv(*options.common.output, *options.metric, front);
    if (options.common.json)
        io::write_file(*options.common.json,
                       front_json(*options.metric, question, front, watch.seconds()).dump(1) + "\n");
    if (options.svg_front)
        io::write_file(*options.svg_front,
                       svg_front(*options.metric, options.point, front, {.surface = options.metric_name}));
    if (options.fronts) write_front_series(*options.fronts, *options.metric, options.point, front);
    observer.clear();
    if (!options.common.output) fmt::print("{}", front_summary(question, front, watch.seconds()));
    return apps::exit_done;
}

int run(int argc, const char* const* argv) {
    const std::optional<Options> options = parse_options(argc, argv);
    if (!options) return apps::exit_done;
    if (!options->note.empty() && !options->common.quiet) fmt::print(stderr, "cutlocus: note: {}\n", options->note);
    apps::ProgressObserver observer(options->common.progress);
    const Question question{options->metric_name, options->metric_parameters, options->point};
    if (options->points_file) return run_batch(*options, observer) == 0 ? apps::exit_done : apps::exit_failed;
    if (options->is_front_only) return run_front(*options, question, observer);
    return run_exact(*options, question, observer);
}

}  // namespace

}  // namespace dsc::cutlocus

int main(int argc, char** argv) {
    return dsc::apps::run_main("cutlocus", [&] { return dsc::cutlocus::run(argc, argv); });
}
