// SPDX-License-Identifier: GPL-3.0-or-later
// What a flow leaves: its steps, its events and how it ended. The same in space and in the plane, but for what a step
// is recorded by.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

#include "apps/common/names.h"
#include "apps/flow/time_steps.h"
#include "core/fields.h"

namespace dsc::flow {

enum class FlowEnd { done, vanished, cancelled, stopped };

inline constexpr std::array end_names{
    apps::Name{"done", FlowEnd::done},
    apps::Name{"vanished", FlowEnd::vanished},
    apps::Name{"cancelled", FlowEnd::cancelled},
    apps::Name{"stopped", FlowEnd::stopped},
};

/// Something that happened once, in report.json and for the reader of the page.
template <int Dimension>
struct EventOf {
    using Place = Eigen::Matrix<double, Dimension, 1>;

    std::string kind;  ///< "merge", "split", "vanish", "contact"
    int step = 0;
    double time = 0;
    Place place = Place::Zero();
    int label = 0;  ///< of what was squeezed away, has vanished, or lies between what is in contact
};

template <class Visitor, class Event>
requires core::ConstOrNot<Event, EventOf<2>> || core::ConstOrNot<Event, EventOf<3>>
void fields(Visitor& visitor, Event& event) {
    auto& [kind, step, time, place, label] = event;
    visitor(kind, step, time, place, label);
}

template <int Dimension, class Record>
struct ResultOf {
    Eigen::AlignedBox<double, Dimension> domain;
    double edge_length = 0;
    TimeSteps time;
    std::vector<Record> steps;  ///< the first one is the state at the start
    std::vector<EventOf<Dimension>> events;
    FlowEnd end = FlowEnd::done;
    std::string reason;  ///< one sentence: why it ended
    double seconds = 0;
};

}  // namespace dsc::flow
