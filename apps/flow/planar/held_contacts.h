// SPDX-License-Identifier: GPL-3.0-or-later
// What a topology policy has stopped, from step to step: a contact holds as long as the motion presses its two places
// against each other, and is let go by the first step that takes them apart.
// Source: thesis 5.2.1 (topology control). Guarantee: no vertex stays locked that is in no contact. Cost: linear in the
// contacts.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/fields.h"
#include "dsc2d/complex.h"
#include "dsc2d/deform/listener.h"

namespace dsc::flow::planar {

/// Two vertices that are kept from each other, by their numbers.
struct HeldContact {
    std::uint32_t a = 0, b = 0;
    dsc2d::LatticeVector lattice = dsc2d::LatticeVector::Zero();  ///< as in motion::Contact
    bool locks_a = false, locks_b = false;
};

template <class Visitor, core::ConstOrNot<HeldContact> Value>
void fields(Visitor& visitor, Value& contact) {
    auto& [a, b, lattice, locks_a, locks_b] = contact;
    visitor(a, b, lattice, locks_a, locks_b);
}

class HeldContacts {
public:
    HeldContacts() = default;
    /// Those of a complex with the same handles, whose vertices are locked already.
    explicit HeldContacts(std::vector<HeldContact> contacts) : contacts_(std::move(contacts)) {}

    const std::vector<HeldContact>& contacts() const { return contacts_; }
    bool is_empty() const { return contacts_.empty(); }

    /// Before a step: unlocks what its targets take apart.
    void release(dsc2d::Complex& complex, std::span<const std::optional<dsc2d::Point2>> targets);
    /// Lets go of everything: before vertices get other numbers or are taken to another period.
    void release_all(dsc2d::Complex& complex);
    /// After a step: takes over what it has stopped.
    void add(const dsc2d::Complex& complex, std::span<const dsc2d::Contact> contacts);

private:
    /// All of them, which are held no longer.
    std::vector<HeldContact> unlocked(dsc2d::Complex& complex);

    std::vector<HeldContact> contacts_;
};

}  // namespace dsc::flow::planar
