// SPDX-License-Identifier: GPL-3.0-or-later
// What a topology policy has stopped, from step to step: a contact holds as long as the motion presses its two places
// against each other, and is let go by the first step that takes them apart.
// Source: thesis 5.2.1 (topology control). Guarantee: no vertex stays locked that is in no contact. Cost: linear in the
// contacts.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dsc2d/complex.h"
#include "dsc2d/deform/listener.h"

namespace dsc::flow::planar {

class HeldContacts {
public:
    bool is_empty() const { return contacts_.empty(); }

    /// Before a step: unlocks what its targets take apart.
    void release(dsc2d::Complex& complex, std::span<const std::optional<dsc2d::Point2>> targets);
    /// Lets go of everything: before vertices get other numbers or are taken to another period.
    void release_all(dsc2d::Complex& complex);
    /// After a step: takes over what it has stopped.
    void add(const dsc2d::Complex& complex, std::span<const dsc2d::Contact> contacts);

private:
    struct Held {
        dsc2d::Contact contact;
        bool locks_a, locks_b;
    };
    /// All of them, which are held no longer.
    std::vector<Held> unlocked(dsc2d::Complex& complex);

    std::vector<Held> contacts_;
};

}  // namespace dsc::flow::planar
