// SPDX-License-Identifier: GPL-3.0-or-later
// What the deformation may do when parts of the interface meet, and how it says that something happened.
// Source: thesis 4.3.1 ("interface topology changes"), 5.2.1 (topology control). Shared by 2D and 3D.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace dsc::motion {

/// The region squeezed between two parts of the interface decides what a contact is: when it carries the background
/// label, objects merge; when it carries an object's label, that object splits.
enum class TopologyPolicy : std::uint8_t {
    adaptive,    ///< objects merge and split as they meet
    preserved,   ///< the interface is stopped where it meets itself: vertices are locked, the contact is reported
    merge_only,  ///< objects merge; where one would split, it is stopped
    split_only,  ///< objects split; where two would merge, they are stopped
};

/// True when the policy lets a region with this label be squeezed away.
constexpr bool allows_change(TopologyPolicy policy, int squeezed_label, int background_label) {
    switch (policy) {
        case TopologyPolicy::adaptive: return true;
        case TopologyPolicy::merge_only: return squeezed_label == background_label;
        case TopologyPolicy::split_only: return squeezed_label != background_label;
        case TopologyPolicy::preserved: break;
    }
    return false;
}

enum class EventKind : std::uint8_t {
    topology_change,  ///< two parts of the interface were joined
    contact,          ///< two parts of the interface were stopped
};

template <int Dimension>
struct Event {
    EventKind kind;
    Eigen::Matrix<double, Dimension, 1> place;  ///< cover coordinates
    int substep;                                ///< substep of the step in which it happened, from 0
    int label;                                  ///< label of the squeezed region
};

}  // namespace dsc::motion
