// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/improve/html_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>

#include "apps/improve/histogram_picture.h"
#include "apps/improve/names.h"
#include "core/assert.h"
#include "io/number.h"

namespace dsc::improve {

using geometry::TetData;

namespace {

constexpr double panel_width = 268;  // px, of the page's side panel

// The tetrahedra to be shown, ascending: all, or the worst ones.
std::vector<std::uint32_t> shown_tets(const std::vector<double>& quality, std::size_t most) {
    std::vector<std::uint32_t> tets(quality.size());
    std::iota(tets.begin(), tets.end(), 0u);
    if (tets.size() <= most) return tets;
    // Equal ones by their number, so that the choice is the same everywhere.
    const auto is_worse = [&](std::uint32_t s, std::uint32_t t) {
        return quality[s] != quality[t] ? quality[s] < quality[t] : s < t;
    };
    std::nth_element(tets.begin(), tets.begin() + static_cast<std::ptrdiff_t>(most), tets.end(), is_worse);
    tets.resize(most);
    std::ranges::sort(tets);
    return tets;
}

io::HtmlView view(const std::string& name, const TetData& data, geometry::QualityMeasure measure,
                  const HtmlPageParameters& parameters) {
    constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
    const std::vector<double> quality = qualities(data, measure, parameters.threads);
    io::ViewTets cells{.name = "tetrahedra", .value_name = "quality"};
    std::vector<std::uint32_t> number(data.vertices.size(), unused);
    for (const std::uint32_t tet : shown_tets(quality, parameters.most_tets)) {
        std::array<std::uint32_t, 4> corners = data.tets[tet];
        for (std::uint32_t& v : corners) {
            if (number[v] == unused) {
                number[v] = static_cast<std::uint32_t>(cells.vertices.size());
                cells.vertices.push_back(data.vertices[v]);
            }
            v = number[v];
        }
        cells.tets.push_back(corners);
        cells.values.push_back(quality[tet]);
    }
    if (cells.tets.size() < data.tets.size()) {
        cells.name = "the worst " + std::to_string(cells.tets.size()) + " of " + std::to_string(data.tets.size()) +
                     " tetrahedra";
    }
    return {.name = name, .tets = std::move(cells)};
}

using Facts = std::vector<std::pair<std::string, std::string>>;

Facts facts(const Improvement& improvement) {
    Facts table;
    const auto add = [&](const std::string& name, auto figure) {
        std::string text = figure(improvement.before);
        if (improvement.after) text += " → " + figure(*improvement.after);
        table.emplace_back(name, text);
    };
    const auto angle = [](double degrees) { return fmt::format("{:.2f}°", degrees); };
    add("tetrahedra", [](const auto& mesh) { return std::to_string(mesh.tets); });
    add("vertices", [](const auto& mesh) { return std::to_string(mesh.vertices); });
    add("smallest angle", [&](const auto& mesh) { return angle(mesh.smallest_angle); });
    add("largest angle", [&](const auto& mesh) { return angle(mesh.largest_angle); });
    table.emplace_back("quality", name_of(measure_names, improvement.parameters.measure));
    add("worst quality", [](const auto& mesh) { return io::number_text(mesh.worst_quality, 3); });
    add("mean quality", [](const auto& mesh) { return io::number_text(mesh.mean_quality, 3); });
    if (improvement.run) table.emplace_back("end", name_of(end_names, improvement.run->end));
    return table;
}

}  // namespace

io::HtmlPage html_page(const Improvement& improvement, const TetData& before, const TetData* after,
                       const HtmlPageParameters& parameters) {
    DSC_ASSERT(improvement.after.has_value() == (after != nullptr));
    const geometry::QualityMeasure measure = improvement.parameters.measure;
    const std::string name = std::filesystem::path(improvement.input).filename().string();
    io::HtmlPage page{.title = name, .facts = facts(improvement), .shares_camera = true};
    std::vector<AngleHistogram> histograms{{after != nullptr ? "before" : "angles", improvement.before}};
    if (after != nullptr) {
        page.views.push_back(view("after", *after, measure, parameters));
        histograms.push_back({"after", *improvement.after});
    }
    page.views.insert(page.views.begin(), view("before", before, measure, parameters));
    page.figure = histogram_picture(histograms, panel_width);
    return page;
}

}  // namespace dsc::improve
