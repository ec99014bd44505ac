// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/held_contacts.h"

#include <utility>

namespace dsc::flow::planar {

using dsc2d::Complex;
using dsc2d::Point2;
using dsc2d::VertexId;

void HeldContacts::release(Complex& complex, std::span<const std::optional<Point2>> targets) {
    const auto motion = [&](VertexId v) {
        const bool has_target = v.index() < targets.size() && targets[v.index()].has_value();
        return has_target ? Point2(*targets[v.index()] - complex.position(v)) : Point2(Point2::Zero());
    };
    const auto is_there = [&](VertexId v) { return !complex.is_deleted(v) && complex.is_interface(v); };
    std::vector<HeldContact> kept;
    for (const HeldContact& held : unlocked(complex)) {
        const VertexId a(held.a), b(held.b);
        if (!is_there(a) || !is_there(b)) continue;
        const Point2 gap = complex.position(b) + complex.domain().translation(held.lattice) - complex.position(a);
        if ((motion(b) - motion(a)).dot(gap) < 0) kept.push_back(held);
    }
    for (const HeldContact& held : kept) {
        if (held.locks_a) complex.lock(VertexId(held.a));
        if (held.locks_b) complex.lock(VertexId(held.b));
    }
    contacts_ = std::move(kept);
}

void HeldContacts::release_all(Complex& complex) { unlocked(complex); }

std::vector<HeldContact> HeldContacts::unlocked(Complex& complex) {
    for (const HeldContact& held : contacts_)
        for (const VertexId v : {VertexId(held.a), VertexId(held.b)})
            if (!complex.is_deleted(v)) complex.unlock(v);
    return std::exchange(contacts_, {});
}

void HeldContacts::add(const Complex& complex, std::span<const dsc2d::Contact> contacts) {
    for (const dsc2d::Contact& contact : contacts) {
        if (complex.is_deleted(contact.a) || complex.is_deleted(contact.b)) continue;
        contacts_.push_back({.a = contact.a.index(),
                             .b = contact.b.index(),
                             .lattice = contact.lattice,
                             .locks_a = complex.is_locked(contact.a),
                             .locks_b = complex.is_locked(contact.b)});
    }
}

}  // namespace dsc::flow::planar
