// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/contacts.h"

#include "tests/dsc3d/deform/support.h"

using namespace dsc;
using namespace dsc::dsc3d;
using namespace dsc::tests;
using motion::TopologyPolicy;

namespace {

/// A slab whose sheets go towards each other, and what the contacts make of it.
struct Squeeze {
    Squeeze(const std::array<int, 3>& labels, double thickness, TopologyPolicy policy, double closing = 0.05)
        : mesh(slab(thickness, labels)), bench(mesh, {.edge_length = 1, .topology = policy}), contacts(mesh) {
        for (const VertexId v : vertices(mesh.complex())) {
            const double z = mesh.position(v).z();
            if (z > 0 && z < 2) bench.way[v] = Point3(0, 0, z == 1 ? closing : -closing);
        }
    }
    bool run() {
        const PassContext plain = bench.context();
        PassContext context{plain.mesh,   plain.parameters, plain.wanted_length, plain.way, plain.pull,
                            plain.region, events,           plain.report};
        return contacts.run(context, 3, context.parameters.contact_distance);
    }
    std::map<int, int> labels() const {
        std::map<int, int> count;
        for (const TetId t : tets(mesh.complex())) ++count[mesh.complex().label(t)];
        return count;
    }

    Mesh mesh;
    PassBench bench;
    EventList events;
    Contacts contacts;
};

}  // namespace

TEST_CASE("a thin gap that closes is given to the region around it, also where it ends on the walls") {
    Squeeze squeeze({1, 0, 1}, 0.1, TopologyPolicy::adaptive);
    const auto domain = volumes(squeeze.mesh);
    REQUIRE(squeeze.run());
    require_valid(squeeze.mesh);
    CHECK(pinches(squeeze.mesh.complex()) == 0);
    const auto after = volumes(squeeze.mesh);
    CHECK(after.count(0) == 0);
    CHECK(after.at(1) == Approx(domain.at(0) + domain.at(1)).epsilon(1e-13));
    CHECK(statistics_by_label(squeeze.mesh).at(1).components == 1);
    for (const Event& event : squeeze.events.events) {
        CHECK(event.kind == motion::EventKind::topology_change);
        CHECK(event.label == 0);
        CHECK(event.substep == 3);
        CHECK((event.place.z() > 1 && event.place.z() < 1.1));
    }
    CHECK(squeeze.events.events.size() == squeeze.bench.report.counts.topology_changes);
    CHECK_FALSE(squeeze.events.events.empty());
    const std::span<const VertexId> touched = squeeze.contacts.touched();
    CHECK(std::is_sorted(touched.begin(), touched.end()));
    CHECK(std::set<VertexId>(touched.begin(), touched.end()).size() == touched.size());
    CHECK(touched.size() == 2 * 7 * 7);
    CHECK_FALSE(squeeze.run());
}

TEST_CASE("what rests or parts is no contact, and neither is a wide gap") {
    CHECK_FALSE(Squeeze({1, 0, 1}, 0.1, TopologyPolicy::adaptive, 0).run());
    CHECK_FALSE(Squeeze({1, 0, 1}, 0.1, TopologyPolicy::adaptive, -0.05).run());
    CHECK_FALSE(Squeeze({1, 0, 1}, 0.3, TopologyPolicy::adaptive).run());
    CHECK(Squeeze({1, 0, 1}, 0.2, TopologyPolicy::adaptive).run());
}

TEST_CASE("the policy says which labels give way, and what it forbids is reported as held") {
    for (const TopologyPolicy policy : {TopologyPolicy::adaptive, TopologyPolicy::preserved, TopologyPolicy::merge_only,
                                        TopologyPolicy::split_only}) {
        for (const bool is_background : {true, false}) {
            Squeeze squeeze(is_background ? std::array{1, 0, 1} : std::array{0, 1, 0}, 0.1, policy);
            const auto before = labelled_tets(squeeze.mesh.complex());
            const bool may_change = policy == TopologyPolicy::adaptive ||
                                    policy == (is_background ? TopologyPolicy::merge_only : TopologyPolicy::split_only);
            CHECK(squeeze.run() == may_change);
            CHECK((labelled_tets(squeeze.mesh.complex()) == before) == !may_change);
            CHECK(squeeze.events.events.empty() == !may_change);
            PassContext context = squeeze.bench.context();
            Contacts::report_held(context);
            // Only of what the policy forbids; where a hole was made, its rim may touch itself across the new region.
            const int label = is_background ? 0 : 1;
            const auto& held = context.report.contacts;
            CHECK(std::any_of(held.begin(), held.end(), [&](const auto& c) { return c.label == label; }) ==
                  !may_change);
            for (const auto& contact : context.report.contacts) {
                const Point3 &a = squeeze.mesh.position(contact.a), &b = squeeze.mesh.position(contact.b);
                CHECK(contact.gap == (b - a).norm());
                CHECK((contact.place - (a + b) / 2).norm() < 1e-15);
                CHECK_FALSE(motion::allows_change(policy, contact.label, 0));
            }
        }
    }
}

TEST_CASE("a gap between two other regions goes to one of them, and they touch") {
    Squeeze squeeze({1, 0, 2}, 0.1, TopologyPolicy::adaptive);
    const auto before = squeeze.labels();
    REQUIRE(squeeze.run());
    require_valid(squeeze.mesh);
    const auto after = squeeze.labels();
    CHECK((after.at(1) == before.at(1) || after.at(2) == before.at(2)));
    CHECK(after.count(0) == 0);
    CHECK(pinches(squeeze.mesh.complex()) == 0);
    CHECK(surface_areas(squeeze.mesh).count({1, 2}) == 1);
}

TEST_CASE("what has won a place is not squeezed away there in the same step, but may be in the next one") {
    Squeeze squeeze({1, 0, 1}, 0.1, TopologyPolicy::adaptive);
    REQUIRE(squeeze.run());
    // Outside, all is turned round: what was won is a slab between the background now.
    for (const TetId t : tets(squeeze.mesh.complex())) {
        const TetVertices& v = squeeze.mesh.complex().vertices(t);
        const bool is_slab = std::all_of(v.begin(), v.end(), [&](VertexId u) {
            const double z = squeeze.mesh.position(u).z();
            return z >= 1 && z < 1.2;
        });
        squeeze.mesh.complex().set_label(t, is_slab ? 1 : 0);
    }
    squeeze.bench.take_all();
    CHECK_FALSE(squeeze.run());
    squeeze.contacts.begin_step();
    CHECK(squeeze.run());
}
