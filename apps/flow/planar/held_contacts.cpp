// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/held_contacts.h"

#include <utility>

namespace dsc::flow::planar {

using dsc2d::Complex;
using dsc2d::Point2;

void HeldContacts::release(Complex& complex, std::span<const std::optional<Point2>> targets) {
    const auto motion = [&](dsc2d::VertexId v) {
        const bool has_target = v.index() < targets.size() && targets[v.index()].has_value();
        return has_target ? Point2(*targets[v.index()] - complex.position(v)) : Point2(Point2::Zero());
    };
    const auto is_there = [&](dsc2d::VertexId v) { return !complex.is_deleted(v) && complex.is_interface(v); };
    std::vector<Held> kept;
    for (const Held& held : unlocked(complex)) {
        const dsc2d::Contact& contact = held.contact;
        if (!is_there(contact.a) || !is_there(contact.b)) continue;
        const Point2 gap =
            complex.position(contact.b) + complex.domain().translation(contact.lattice) - complex.position(contact.a);
        if ((motion(contact.b) - motion(contact.a)).dot(gap) < 0) kept.push_back(held);
    }
    for (const Held& held : kept) {
        if (held.locks_a) complex.lock(held.contact.a);
        if (held.locks_b) complex.lock(held.contact.b);
    }
    contacts_ = std::move(kept);
}

void HeldContacts::release_all(Complex& complex) { unlocked(complex); }

std::vector<HeldContacts::Held> HeldContacts::unlocked(Complex& complex) {
    for (const Held& held : contacts_)
        for (const dsc2d::VertexId v : {held.contact.a, held.contact.b})
            if (!complex.is_deleted(v)) complex.unlock(v);
    return std::exchange(contacts_, {});
}

void HeldContacts::add(const Complex& complex, std::span<const dsc2d::Contact> contacts) {
    for (const dsc2d::Contact& contact : contacts) {
        if (complex.is_deleted(contact.a) || complex.is_deleted(contact.b)) continue;
        contacts_.push_back({contact, complex.is_locked(contact.a), complex.is_locked(contact.b)});
    }
}

}  // namespace dsc::flow::planar
