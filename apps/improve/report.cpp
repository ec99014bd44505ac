// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/improve/report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "apps/improve/names.h"
#include "core/assert.h"
#include "core/version.h"
#include "io/number.h"

namespace dsc::improve {

using io::Json;

namespace {

constexpr std::size_t text_bins = 18;
constexpr double longest_bar = 22;  // characters

// The lines of the report: a name, and one figure for each mesh.
class Table {
public:
    explicit Table(const Improvement& improvement) : before_(improvement.before), after_(improvement.after) {}

    void row(const std::string& name, const std::string& before, const std::string& after) {
        text_ += fmt::format("{:<36}{:>14}", name, before);
        if (after_) text_ += fmt::format("{:>14}", after);
        text_ += '\n';
    }
    void row(const std::string& name, const std::function<std::string(const MeshStatistics&)>& figure) {
        row(name, figure(before_), after_ ? figure(*after_) : "");
    }
    const std::string& text() const { return text_; }

private:
    const MeshStatistics& before_;
    const std::optional<MeshStatistics>& after_;
    std::string text_;
};

std::string figures(const Improvement& improvement) {
    const auto angle_text = [](double angle) { return fmt::format("{:.4f}", angle); };
    Table table(improvement);
    if (improvement.after) table.row("", "before", "after");
    table.row("tetrahedra", [](const auto& mesh) { return std::to_string(mesh.tets); });
    table.row("vertices", [](const auto& mesh) { return std::to_string(mesh.vertices); });
    table.row("regions", [](const auto& mesh) { return std::to_string(mesh.regions); });
    table.row("volume", [](const auto& mesh) { return io::number_text(mesh.volume, 10); });
    table.row("smallest dihedral angle, degrees", [&](const auto& mesh) { return angle_text(mesh.smallest_angle); });
    table.row("largest dihedral angle, degrees", [&](const auto& mesh) { return angle_text(mesh.largest_angle); });
    for (std::size_t i = 0; i < percentile_ranks.size(); ++i) {
        table.row(fmt::format("{:>3} % of all dihedral angles up to", percentile_ranks[i]),
                  [&](const auto& mesh) { return angle_text(mesh.angle_percentiles[i]); });
    }
    const std::string measure = name_of(measure_names, improvement.parameters.measure);
    table.row("worst quality, " + measure, [](const auto& mesh) { return io::number_text(mesh.worst_quality, 6); });
    table.row("mean quality, " + measure, [](const auto& mesh) { return io::number_text(mesh.mean_quality, 6); });
    return table.text();
}

// The few worst angles are the ones that matter: where there are any, there is a dot at least.
std::string bar(double fraction) {
    const std::string hashes(static_cast<std::size_t>(std::lround(longest_bar * fraction)), '#');
    return hashes.empty() && fraction > 0 ? "." : hashes;
}

std::string histogram(const Improvement& improvement) {
    std::vector<const MeshStatistics*> meshes{&improvement.before};
    if (improvement.after) meshes.push_back(&*improvement.after);
    double largest = 0;
    for (const MeshStatistics* mesh : meshes)
        largest = std::max(largest, std::ranges::max(angle_shares(*mesh, text_bins)));
    std::string text = "all dihedral angles\n";
    for (std::size_t bin = 0; bin < text_bins; ++bin) {
        std::string line = fmt::format("{:>3} to {:>3}", 180 / text_bins * bin, 180 / text_bins * (bin + 1));
        for (const MeshStatistics* mesh : meshes) {
            line += fmt::format("{:>11} {:<22}", angle_histogram(*mesh, text_bins)[bin],
                                bar(angle_shares(*mesh, text_bins)[bin] / largest));
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    }
    return text;
}

std::string operations(const dsc3d::ImproveReport& run) {
    return fmt::format(
        "{} smoothings, {} edge removals, {} multi-face removals, {} multi-face retriangulations, {} collapses, {} "
        "escapes\n",
        run.smoothings, run.edge_removals, run.multi_face_removals, run.multi_face_retriangulations, run.collapses,
        run.escapes);
}

template <class Number>
Json or_null(const std::optional<Number>& value) {
    return value ? Json(*value) : Json();
}

Json statistics_json(const MeshStatistics& mesh) {
    Json percentiles = Json::object();
    for (std::size_t i = 0; i < percentile_ranks.size(); ++i) {
        percentiles[std::to_string(percentile_ranks[i])] = mesh.angle_percentiles[i];
    }
    Json counts = Json::array();
    for (const std::size_t count : mesh.angle_counts) counts.push_back(count);
    return Json::object({{"tets", mesh.tets},
                         {"vertices", mesh.vertices},
                         {"regions", mesh.regions},
                         {"volume", mesh.volume},
                         {"min_dihedral", mesh.smallest_angle},
                         {"max_dihedral", mesh.largest_angle},
                         {"dihedral_percentiles", percentiles},
                         {"dihedral_histogram", counts},
                         {"worst_quality", mesh.worst_quality},
                         {"mean_quality", mesh.mean_quality}});
}

Json parameters_json(const dsc3d::ImproveParameters& parameters) {
    return Json::object({{"schedule", name_of(schedule_names, parameters.schedule)},
                         {"mfrt", parameters.uses_multi_face_retriangulation},
                         {"thinning", parameters.uses_thinning},
                         {"keep_vertices", parameters.keeps_vertices},
                         {"boundary", parameters.changes_boundary},
                         {"max_boundary_change", parameters.max_boundary_change},
                         {"feature_angle", parameters.feature_angle},
                         {"time_limit", or_null(parameters.time_limit)},
                         {"target_angle", or_null(parameters.target_angle)},
                         {"seed", parameters.seed},
                         {"threads", parameters.threads}});
}

Json operations_json(const dsc3d::ImproveReport& run) {
    return Json::object({{"smoothings", run.smoothings},
                         {"edge_removals", run.edge_removals},
                         {"multi_face_removals", run.multi_face_removals},
                         {"multi_face_retriangulations", run.multi_face_retriangulations},
                         {"collapses", run.collapses},
                         {"escapes", run.escapes}});
}

}  // namespace

std::string end_reason(const Improvement& improvement) {
    DSC_ASSERT(improvement.run);
    switch (improvement.run->end) {
        case dsc3d::ImproveEnd::converged: return "converged: nothing that the schedule tries improves the mesh";
        case dsc3d::ImproveEnd::reached_target_angle: {
            const double angle = improvement.parameters.target_angle.value_or(0);
            return "target reached: all dihedral angles lie between " + io::number_text(angle) + " and " +
                   io::number_text(180 - angle) + " degrees";
        }
        case dsc3d::ImproveEnd::reached_time_limit:
            return "time limit of " + io::number_text(improvement.parameters.time_limit.value_or(0)) + " s reached";
        case dsc3d::ImproveEnd::cancelled: break;
    }
    return "stopped by the user";
}

std::string report_text(const Improvement& improvement) {
    std::string text = figures(improvement) + histogram(improvement);
    if (improvement.run) {
        text += fmt::format("{}; {} rounds, {:.2f} s\n", end_reason(improvement), improvement.run->rounds,
                            improvement.run->seconds);
        text += operations(*improvement.run);
    }
    return text;
}

Json report_json(const Improvement& improvement) {
    Json report = Json::object({{"program", "improve"},
                                {"version", core::version()},
                                {"input", improvement.input},
                                {"output", or_null(improvement.output)},
                                {"measure", name_of(measure_names, improvement.parameters.measure)},
                                {"parameters", parameters_json(improvement.parameters)},
                                {"before", statistics_json(improvement.before)},
                                {"after", nullptr},
                                {"end", nullptr},
                                {"end_reason", nullptr},
                                {"rounds", nullptr},
                                {"operations", nullptr},
                                {"seconds", Json::object({{"read", improvement.read_seconds},
                                                          {"improve", nullptr},
                                                          {"total", improvement.total_seconds}})}});
    if (improvement.after) report["after"] = statistics_json(*improvement.after);
    if (improvement.run) {
        report["end"] = name_of(end_names, improvement.run->end);
        report["end_reason"] = end_reason(improvement);
        report["rounds"] = improvement.run->rounds;
        report["operations"] = operations_json(*improvement.run);
        report["seconds"]["improve"] = improvement.run->seconds;
    }
    return report;
}

}  // namespace dsc::improve
