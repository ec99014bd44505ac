// SPDX-License-Identifier: GPL-3.0-or-later
// What the reports of a flow in space and in the plane have in common, as JSON, as text and on the page.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/flow/result.h"
#include "core/version.h"
#include "io/html_view.h"
#include "io/json.h"
#include "io/number.h"
#include "motion/step_report.h"

namespace dsc::flow {

template <class Vector>
io::Json point_json(const Vector& p) {
    return io::Json(std::vector<double>(p.begin(), p.end()));
}

io::Json counts_json(const motion::StepCounts& counts);
io::Json milliseconds_json(const std::vector<std::pair<std::string, double>>& milliseconds);

/// The whole report; `step_json` makes one of its steps.
template <int Dimension, class Record, class StepJson>
io::Json result_json(const ResultOf<Dimension, Record>& result, const io::Json& given, StepJson&& step_json) {
    using io::Json;
    Json steps = Json::array(), events = Json::array();
    for (const Record& step : result.steps) steps.push_back(step_json(step));
    for (const EventOf<Dimension>& event : result.events)
        events.push_back(Json::object({{"kind", event.kind},
                                       {"step", event.step},
                                       {"time", event.time},
                                       {"place", point_json(event.place)},
                                       {"label", event.label}}));
    return Json::object({{"program", "flow"},
                         {"version", core::version()},
                         {"options", given},
                         {"dimension", Dimension},
                         {"domain", Json::array({point_json(result.domain.min()), point_json(result.domain.max())})},
                         {"edge_length", result.edge_length},
                         {"dt", result.time.dt},
                         {"until", result.time.until},
                         {"end", apps::name_of(end_names, result.end)},
                         {"end_reason", result.reason},
                         {"seconds", result.seconds},
                         {"events", events},
                         {"steps", steps}});
}

/// Figures at the start and at the end, side by side.
class FigureTable {
public:
    FigureTable();
    void add(const std::string& name, const std::string& start, const std::string& end);
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// A figure of one label in a record; `missing` when the label is gone.
template <class Record, class Figure>
std::string label_figure(const Record& record, int label, Figure&& figure, const std::string& missing) {
    const auto found = std::find_if(record.labels.begin(), record.labels.end(),
                                    [&](const auto& statistics) { return statistics.label == label; });
    return found == record.labels.end() ? missing : figure(*found);
}

/// How a run ended, in one line; `incomplete` of its steps have motion left over.
std::string end_line(const std::string& reason, std::size_t steps, std::size_t incomplete, std::size_t events,
                     double seconds);
template <class Result>
std::string end_line(const Result& result) {
    const auto incomplete =
        std::count_if(result.steps.begin(), result.steps.end(), [](const auto& step) { return !step.is_complete; });
    return end_line(result.reason, result.steps.size() - 1, static_cast<std::size_t>(incomplete), result.events.size(),
                    result.seconds);
}

/// Of the side with the higher label; the colours of many labels come again.
std::string label_colour(int label);
/// "between 0 and 1".
std::string sides_name(int low, int high);

/// The events on the page; none when nothing has happened.
template <int Dimension>
std::optional<io::ViewPoints> event_points(const std::vector<EventOf<Dimension>>& events) {
    if (events.empty()) return std::nullopt;
    io::ViewPoints points{.name = "events"};
    for (const EventOf<Dimension>& event : events) {
        Eigen::Vector3d& place = points.positions.emplace_back(Eigen::Vector3d::Zero());
        place.template head<Dimension>() = event.place;
        points.labels.push_back(event.kind + " at time " + io::number_text(event.time, 6));
    }
    return points;
}

}  // namespace dsc::flow
