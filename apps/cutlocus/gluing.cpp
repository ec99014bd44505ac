// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/gluing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/assert.h"

namespace dsc::cutlocus {

double wrapped_angle(double theta) {
    constexpr double turn = 2 * std::numbers::pi;
    const double wrapped = theta - turn * std::floor(theta / turn);
    return wrapped < turn ? wrapped : 0;
}

Gluing::Gluing(std::span<const DirectionPair> pairs, std::span<const double> free_directions) {
    for (int pair = 0; pair < static_cast<int>(pairs.size()); ++pair) {
        entries_.push_back({wrapped_angle(pairs[static_cast<std::size_t>(pair)].theta1), pair, 0});
        entries_.push_back({wrapped_angle(pairs[static_cast<std::size_t>(pair)].theta2), pair, 1});
    }
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.theta, a.pair, a.side) < std::tie(b.theta, b.pair, b.side);
    });
    positions_.resize(entries_.size());
    for (std::size_t k = 0; k < entries_.size(); ++k)
        positions_[static_cast<std::size_t>(2 * entries_[k].pair + entries_[k].side)] = static_cast<int>(k);
    for (const Entry& entry : entries_) partners_.push_back(index_of(entry.pair, 1 - entry.side));

    is_open_.assign(entries_.size(), 0);
    if (entries_.empty()) return;
    for (double direction : free_directions) {
        const auto after = std::upper_bound(entries_.begin(), entries_.end(), wrapped_angle(direction),
                                            [](double theta, const Entry& entry) { return theta < entry.theta; });
        is_open_[static_cast<std::size_t>(wrapped(static_cast<int>(after - entries_.begin()) - 1))] = 1;
    }
}

bool Gluing::is_inside_arc(int gap) const {
    if (is_open(gap)) return false;
    const int second = next_gap(gap);
    return second != wrapped(gap) && !is_open(second) && next_gap(second) == wrapped(gap);
}

std::vector<Gluing::Walk> Gluing::walks() const {
    std::vector<Walk> walks;
    std::vector<char> is_visited(entries_.size(), 0);
    for (int start = 0; start < size(); ++start) {  // open walks first: they begin in the open gaps
        if (!is_open(start)) continue;
        Walk walk{{start}, false};
        do {
            walk.gaps.push_back(next_gap(walk.gaps.back()));
            is_visited[static_cast<std::size_t>(walk.gaps.back())] = 1;
        } while (!is_open(walk.gaps.back()));
        walks.push_back(std::move(walk));
    }
    for (int start = 0; start < size(); ++start) {
        if (is_visited[static_cast<std::size_t>(start)]) continue;
        Walk walk;
        for (int gap = start; !is_visited[static_cast<std::size_t>(gap)]; gap = next_gap(gap)) {
            is_visited[static_cast<std::size_t>(gap)] = 1;
            walk.gaps.push_back(gap);
        }
        walks.push_back(std::move(walk));
    }
    return walks;
}

int Gluing::euler_characteristic() const {
    DSC_ASSERT(std::none_of(is_open_.begin(), is_open_.end(), [](char open) { return open != 0; }));
    return static_cast<int>(walks().size()) - size() / 2 + 1;
}

}  // namespace dsc::cutlocus
