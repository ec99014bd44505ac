// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/options.h"

#include <cmath>
#include <numbers>

#include "core/errors.h"
#include "geodesic/expression_metric.h"
#include "geodesic/metric_check.h"
#include "geodesic/torus.h"
#include "io/number.h"

namespace dsc::cutlocus {

using geodesic::ChartPeriods;

namespace {

constexpr double pi = std::numbers::pi;

/// A number, or a multiple of pi: "1.5", "pi", "-pi", "0.15pi", "2*pi".
std::optional<double> parse_length(std::string text) {
    if (!text.ends_with("pi")) return io::parse_finite(text);
    text.resize(text.size() - 2);
    if (text.ends_with("*")) text.pop_back();
    if (text.empty() || text == "+") return pi;
    if (text == "-") return -pi;
    const std::optional<double> factor = io::parse_finite(text);
    return factor ? std::optional(*factor * pi) : std::nullopt;
}

ChartPeriods parse_periods(const std::string& text) {
    const Point2 periods = parse_chart_pair(text, "--period");
    if (periods.x() < 0 || periods.y() < 0)
        throw core::UsageError("--period: a period must be positive, or 0 where the chart is not periodic");
    ChartPeriods result;
    if (periods.x() > 0) result.u = periods.x();
    if (periods.y() > 0) result.v = periods.y();
    return result;
}

struct MetricTexts {
    std::optional<std::string> torus, embedding, tensor, period;
    double major_radius = 2;
    std::optional<double> lambda;
};

void make_torus(const MetricTexts& texts, Options& options) {
    const bool is_circular = *texts.torus == "circular";
    if (is_circular && texts.lambda && *texts.lambda != 1)
        throw core::UsageError("--lambda: a circular torus has lambda 1; use --torus elliptic");
    if (texts.period) throw core::UsageError("--period: a torus of revolution has the periods 2pi,2pi");
    const double lambda = is_circular ? 1 : texts.lambda.value_or(2);
    options.metric = std::make_unique<geodesic::TorusOfRevolution>(texts.major_radius, lambda);
    options.metric_source = "--torus";
    if (texts.major_radius < 0)
        options.note = "--major-radius " + io::number_text(texts.major_radius) + " is the torus of radius " +
                       io::number_text(-texts.major_radius) +
                       " in another chart, shifted by half a period in u and in v";
    options.metric_name = "revolution R=" + io::number_text(texts.major_radius) + " lambda=" + io::number_text(lambda);
    options.metric_parameters = io::Json::object({{"kind", "rev"}, {"R", texts.major_radius}, {"lam", lambda}});
}

void make_expression(const MetricTexts& texts, Options& options) {
    if (texts.lambda) throw core::UsageError("--lambda: goes with --torus elliptic only");
    const ChartPeriods periods = texts.period ? parse_periods(*texts.period) : ChartPeriods{2 * pi, 2 * pi};
    const auto period_json = [](const std::optional<double>& period) {
        return period ? io::Json(*period) : io::Json();
    };
    const bool is_embedding = texts.embedding.has_value();
    const std::string& text = is_embedding ? *texts.embedding : *texts.tensor;
    if (is_embedding)
        options.metric = std::make_unique<geodesic::ExpressionEmbedding>(text, periods);
    else
        options.metric = std::make_unique<geodesic::ExpressionMetric>(text, periods);
    options.metric_source = is_embedding ? "--embedding" : "--metric";
    options.metric_name = (is_embedding ? "embedding " : "metric ") + text;
    options.metric_parameters =
        io::Json::object({{"kind", is_embedding ? "embedding" : "metric"},
                          {"expressions", text},
                          {"period", io::Json::array({period_json(periods.u), period_json(periods.v)})}});
}

void check_combinations(const apps::CommandLine& line, const Options& options) {
    const auto exclude = [&](const char* a, const char* b, const char* why) {
        if (line.is_given(a) && line.is_given(b))
            throw core::UsageError(std::string(a) + " and " + b + " don't go together: " + why);
    };
    for (const char* output : {"--json", "--svg", "--svg-geodesics", "--svg-front", "--html", "--fronts", "--distance"})
        exclude("--points", output, "a batch writes one CSV and one JSON file per point into the folder -o");
    exclude("--points", "--point", "the file has the points");
    if (options.points_file && !options.common.output)
        throw core::UsageError("--points needs -o FOLDER for its results");
    if (options.is_resumed && !options.points_file) throw core::UsageError("--resume goes with --points");
    if (line.is_given("--time-step") && !options.is_front_only)
        throw core::UsageError("--time-step goes with --method front");
    if (options.is_front_only)
        for (const char* option : {"--distance", "--points", "--html", "--svg", "--svg-geodesics"})
            if (line.is_given(option))
                throw core::UsageError(std::string(option) + " needs the exact cut locus: leave --method front out");
    if (options.metric->periods().is_torus() && options.parameters.max_distance)
        throw core::UsageError("--max-distance goes with a surface that is not closed: see --period");
    if (!options.metric->periods().is_torus() && !options.parameters.max_distance)
        throw core::UsageError("--max-distance is needed: the surface is not closed");
}

}  // namespace

Point2 parse_chart_pair(const std::string& text, const std::string& option) {
    const std::size_t comma = text.find(',');
    if (comma != std::string::npos) {
        const auto first = parse_length(text.substr(0, comma)), second = parse_length(text.substr(comma + 1));
        constexpr double farthest = 1e6;  // beyond it a coordinate has too few digits left after the point
        if (first && second && std::abs(*first) <= farthest && std::abs(*second) <= farthest) return {*first, *second};
    }
    throw core::UsageError(option + ": '" + text + "' is not a pair of numbers like 0,0.15pi (up to a million)");
}

std::optional<Options> parse_options(int argc, const char* const* argv) {
    Options options;
    MetricTexts texts;
    std::optional<std::string> point, target;
    std::string method = "exact";
    apps::CommandLine line("cutlocus", "The cut locus of a point on a surface, exact and certified.",
                           "cutlocus --torus elliptic --lambda 2 --point 0,0.15pi -o locus.csv --html locus.html",
                           {.output = "CSV of the cut locus: u,v,distance,theta,theta2,arc (with --points: a folder)",
                            .folder_option = "--points"});
    line.heading("Surface");
    line.choice("--torus", texts.torus, {"circular", "elliptic"}, "torus of revolution with this section");
    line.number("--major-radius", texts.major_radius, "distance R of the section's centre from the axis");
    line.number("--lambda", texts.lambda, "height of the elliptic section (default 2)");
    line.text("--embedding", texts.embedding, "\"x=...;y=...;z=...\" in u and v");
    line.text("--metric", texts.tensor, "\"E=...;F=...;G=...\" in u and v");
    line.text("--period", texts.period, "periods of u and v, 0: not periodic (default 2pi,2pi)");
    line.alternatives({"--torus", "--embedding", "--metric"}, true);
    line.heading("Question");
    line.text("--point", point, "u,v of the point p (default 0,0)");
    line.input_file("--points", options.points_file, "file of points, one u,v per line: a batch, one result each");
    line.flag("--resume", options.is_resumed, "with --points: keep the results that are there already");
    line.text("--distance", target, "u,v: also the distance from p to this point, and all minimising geodesics");
    line.number("--max-distance", options.parameters.max_distance,
                "as far as asked for, where the surface is not closed", {.above = 0});
    line.heading("Method");
    line.choice("--method", method, {"exact", "front"}, "front: the thesis's time stepping, nothing made exact");
    line.number("--tolerance", options.parameters.tolerance, "of every position, on the surface",
                {.at_least = 1e-11, .at_most = 1e-3});
    line.number("--spacing", options.parameters.spacing, "of the points along an arc, on the surface", {.above = 0});
    line.number("--front-spacing", options.parameters.front_spacing,
                "of the front, relative to the size of the surface", {.at_least = 1e-4, .at_most = 0.1});
    line.number("--time-step", options.time_step, "growth of the front per step, with --method front", {.above = 0});
    line.heading("Output");
    line.output_file("--svg", options.svg, "chart with cut locus, geodesics and distance circles");
    line.output_file("--svg-geodesics", options.svg_geodesics, "chart with geodesics beyond the cut locus");
    line.output_file("--svg-front", options.svg_front, "chart with the growing front");
    line.output_file("--html", options.html, "page to turn, zoom and click");
    line.output_folder("--fronts", options.fronts, "folder for the growing front as a series for ParaView");
    if (!line.parse(argc, argv)) return std::nullopt;

    options.common = line.common();
    options.given = line.given();
    options.is_front_only = method == "front";
    texts.torus ? make_torus(texts, options) : make_expression(texts, options);
    if (line.is_given("--major-radius") && !texts.torus)
        throw core::UsageError("--major-radius: goes with --torus only");
    if (point) options.point = options.metric->periods().wrapped(parse_chart_pair(*point, "--point"));
    if (target) options.target = parse_chart_pair(*target, "--distance");
    check_combinations(line, options);
    options.parameters.threads = options.common.threads;
    const bool has_output = options.common.output || options.common.json || options.svg || options.svg_geodesics ||
                            options.svg_front || options.html || options.fronts;
    if (!has_output && !options.is_front_only) options.default_picture = "cutlocus.svg";
    if (options.html || options.fronts || options.svg_front) options.parameters.snapshots = 60;
    options.parameters.validate();
    if (!texts.torus)
        geodesic::check_metric(*options.metric, options.metric_source,
                               {.center = options.point, .reach = options.parameters.max_distance.value_or(1)});
    return options;
}

}  // namespace dsc::cutlocus
