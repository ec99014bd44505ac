// SPDX-License-Identifier: GPL-3.0-or-later
// The simplices of one cavity by their vertices: a hash table that is emptied in constant time, so that one table
// serves all operations without allocating. Guarantee: entries keep the order in which they were added.
// Cost: some 5 ns per access.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/handles.h"

namespace dsc::dsc3d {

/// Key: N vertices in ascending order.
template <std::size_t N, class Entry>
class LocalTable {
public:
    using Key = std::array<core::VertexId, N>;

    void clear() {
        entries_.clear();
        ++epoch_;
        if (epoch_ == 0) {  // the counter came round: old stamps could be taken for new ones
            slots_.assign(slots_.size(), {});
            epoch_ = 1;
        }
    }

    /// The entry of `key`, and whether it was added by this call.
    std::pair<Entry*, bool> insert(const Key& key) {
        if (2 * (entries_.size() + 1) > slots_.size()) grow();
        Slot& slot = find(key);
        if (slot.epoch == epoch_) return {&entries_[slot.entry].second, false};
        slot = {epoch_, static_cast<std::uint32_t>(entries_.size())};
        entries_.emplace_back(key, Entry{});
        return {&entries_.back().second, true};
    }

    std::vector<std::pair<Key, Entry>>& entries() { return entries_; }

private:
    struct Slot {
        std::uint32_t epoch = 0;
        std::uint32_t entry = 0;
    };

    Slot& find(const Key& key) {
        std::uint64_t hash = 0;
        for (const core::VertexId v : key) hash = (hash ^ v.index()) * 0x9E3779B97F4A7C15u;
        std::size_t i = (hash >> 32) & (slots_.size() - 1);
        while (slots_[i].epoch == epoch_ && entries_[slots_[i].entry].first != key) i = (i + 1) & (slots_.size() - 1);
        return slots_[i];
    }

    void grow() {
        slots_.assign(slots_.empty() ? 256 : 2 * slots_.size(), {});
        epoch_ = 1;
        for (std::uint32_t i = 0; i < entries_.size(); ++i) find(entries_[i].first) = {epoch_, i};
    }

    std::vector<Slot> slots_;
    std::vector<std::pair<Key, Entry>> entries_;
    std::uint32_t epoch_ = 1;
};

}  // namespace dsc::dsc3d
