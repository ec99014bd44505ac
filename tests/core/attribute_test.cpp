// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/attribute.h"

#include <catch2/catch.hpp>
#include <memory>
#include <numeric>
#include <vector>

#include "core/handles.h"
#include "core/random.h"
#include "tests/support/seed.h"

using namespace dsc::core;
using Registry = AttributeRegistry<VertexId>;

TEST_CASE("an attribute grows with its mesh and fills in its default") {
    const auto registry = std::make_shared<Registry>();
    Attribute<VertexId, double> attribute(registry, 1.5);
    CHECK(attribute.size() == 0);
    registry->resize(3);
    CHECK(attribute.size() == 3);
    attribute[VertexId(1)] = 4;
    registry->resize(5);
    CHECK(attribute[VertexId(1)] == 4);
    CHECK(attribute[VertexId(4)] == 1.5);
}

TEST_CASE("attributes keep the value of each element under random growth and compaction") {
    Random random(dsc::tests::seed(11));
    const auto registry = std::make_shared<Registry>();
    Attribute<VertexId, std::uint64_t> identity(registry);
    std::vector<std::uint64_t> expected;
    std::uint64_t next = 1;
    for (int step = 0; step < 200; ++step) {
        if (random.uniform() < 0.6) {
            for (std::uint64_t n = random.below(20); n > 0; --n) {
                registry->resize(expected.size() + 1);
                identity[VertexId(static_cast<std::uint32_t>(expected.size()))] = next;
                expected.push_back(next++);
            }
        } else {
            std::vector<std::uint32_t> kept;
            std::vector<std::uint64_t> remaining;
            for (std::uint32_t i = 0; i < expected.size(); ++i) {
                if (random.uniform() < 0.3) continue;
                kept.push_back(i);
                remaining.push_back(expected[i]);
            }
            registry->compact(kept);
            expected = remaining;
        }
        REQUIRE(std::vector<std::uint64_t>(identity.values().begin(), identity.values().end()) == expected);
    }
}

TEST_CASE("copies of an attribute follow the mesh on their own, and may outlive it") {
    auto registry = std::make_shared<Registry>();
    registry->resize(2);
    Attribute<VertexId, int> a(registry, 7);
    Attribute<VertexId, int> b = a;
    b[VertexId(0)] = 1;
    CHECK(a[VertexId(0)] == 7);
    registry->resize(4);
    CHECK(b.size() == 4);
    const auto other = std::make_shared<Registry>();
    Attribute<VertexId, int> c(other, 0);
    c = b;
    registry->resize(6);
    CHECK(c.size() == 6);
    CHECK(c[VertexId(0)] == 1);
    registry.reset();
    CHECK(a[VertexId(5)] == 7);
}
