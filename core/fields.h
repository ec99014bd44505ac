// SPDX-License-Identifier: GPL-3.0-or-later
// The members of a plain struct, listed once for all that goes through them, be it to read or to write. The list is in
// the namespace of the struct. Guarantee: it unpacks the whole struct, so that one to which a member is added does not
// compile until the list has it.
//
//     struct Event { int step; double time; };
//     template <class Visitor, core::ConstOrNot<Event> Value>
//     void fields(Visitor& visitor, Value& event) {
//         auto& [step, time] = event;
//         visitor(step, time);
//     }
#pragma once

#include <concepts>
#include <type_traits>

namespace dsc::core {

template <class Value, class Struct>
concept ConstOrNot = std::same_as<std::remove_const_t<Value>, Struct>;

}  // namespace dsc::core
