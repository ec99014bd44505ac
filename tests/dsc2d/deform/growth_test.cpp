// SPDX-License-Identifier: GPL-3.0-or-later
// A distance circle that grows until it has met itself everywhere (thesis 5.2), on flat tori, where the result is
// known, and on a torus of revolution, where the front has cusps.
#include <chrono>
#include <functional>

#include "dsc2d/deform/deformer.h"
#include "dsc2d/generate/insert_polygon.h"
#include "dsc2d/generate/structured.h"
#include "tests/dsc2d/support.h"

using namespace dsc::dsc2d;
using dsc::tests::require_valid;
using std::numbers::pi;

namespace {

using Flow = std::function<Point2(double theta, double distance)>;

class Growth final : private Listener {
public:
    Growth(const Eigen::Matrix2d& periods, const Point2& centre, double spacing, int cells, Flow flow)
        : centre_(centre),
          spacing_(spacing),
          flow_(std::move(flow)),
          complex(structured_complex(Domain::torus(periods), cells, cells)),
          theta(complex.vertex_attributes(), 0.0),
          deformer_(complex, parameters(spacing), *this) {
        constexpr int count = 40;
        radius_ = spacing * count / (2 * pi);
        std::vector<Point2> polygon;
        for (int i = 0; i < count; ++i) polygon.push_back(flow_(2 * pi * i / count, radius_));
        const auto front = insert_polygon(complex, polygon, 1);
        for (int i = 0; i < count; ++i) theta[front[static_cast<std::size_t>(i)]] = 2 * pi * i / count;
    }

    static Parameters parameters(double spacing) {
        Parameters values;
        values.edge_length = spacing;
        values.topology = dsc::motion::TopologyPolicy::preserved;
        return values;
    }

    // One step of half a spacing; false when every vertex of the front is locked.
    bool advance(bool is_checked) {
        refine();
        targets_.assign(complex.vertex_capacity(), std::nullopt);
        bool is_moving = false;
        radius_ += 0.5 * spacing_;
        for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
            const VertexId v(i);
            if (complex.is_deleted(v) || !complex.is_interface(v) || complex.is_locked(v)) continue;
            targets_[i] = flow_(theta[v], radius_);
            is_moving = true;
        }
        if (!is_moving) return false;
        const StepReport report = deformer_.step(targets_);
        for (const auto& motion : report.unfinished) stuck += motion.is_locked ? 0 : 1;
        ++steps;
        if (is_checked) require_valid(complex);
        return true;
    }

    std::size_t front_size() const {
        std::size_t size = 0;
        for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i)
            size += !complex.is_deleted(VertexId(i)) && complex.is_interface(VertexId(i)) ? 1 : 0;
        return size;
    }

private:
    void refine() {
        for (std::uint32_t i = 0, count = complex.edge_capacity(); i < count; ++i) {
            const HalfedgeId h = Complex::halfedge(EdgeId(i));
            if (complex.is_deleted(EdgeId(i)) || !complex.is_interface(h) || complex.length(h) <= spacing_) continue;
            const VertexId a = complex.from(h), b = complex.to(h);
            if (complex.is_locked(a) && complex.is_locked(b)) continue;
            if (const auto m = deformer_.split_interface_edge(h)) on_interface_split(*m, a, b, 0.5);
        }
    }
    void on_interface_split(VertexId m, VertexId a, VertexId b, double s) override {
        theta[m] = theta[a] + s * std::remainder(theta[b] - theta[a], 2 * pi);
    }
    void on_contact(const Contact& contact) override { contacts.push_back(contact); }

    Point2 centre_;
    double spacing_;
    double radius_;
    Flow flow_;
    std::vector<std::optional<Point2>> targets_;

public:
    Complex complex;
    dsc::core::Attribute<VertexId, double> theta;
    std::vector<Contact> contacts;
    int steps = 0;
    int stuck = 0;

private:
    Deformer deformer_;
};

Flow straight(const Point2& centre) {
    return [centre](double theta, double distance) {
        return Point2(centre + distance * Point2(std::cos(theta), std::sin(theta)));
    };
}

void check_flat(const Eigen::Matrix2d& periods, double spacing, int cells) {
    const Point2 centre(3.0, 2.9);
    Growth growth(periods, centre, spacing, cells, straight(centre));
    while (growth.steps < 400 && growth.advance(/*is_checked=*/true)) {
    }
    const Complex& complex = growth.complex;
    REQUIRE_FALSE(growth.advance(true));
    CHECK(growth.stuck == 0);
    CHECK(dsc::tests::component_count(complex, 1) == 1);
    CHECK(dsc::tests::euler_characteristic(complex, 1) == 1);
    CHECK(labelled_area(complex, 0) < 4 * spacing * std::sqrt(complex.domain().area()));
    REQUIRE(growth.contacts.size() > 100);
    for (const Contact& contact : growth.contacts) {
        REQUIRE(contact.label == 0);
        REQUIRE(contact.lattice != LatticeVector::Zero());
        const Point2 period = complex.domain().translation(contact.lattice);
        const Point2 gap = complex.position(contact.b) + period - complex.position(contact.a);
        REQUIRE(gap.norm() <= 0.26 * spacing);
        // The two are equally far from the centre, up to a step of each side and the gap, and so lie near the bisector.
        const double a = (complex.position(contact.a) - centre).norm(),
                     b = (complex.position(contact.b) - centre).norm();
        REQUIRE(std::abs(a - b) < 1.26 * spacing);
        REQUIRE(std::abs((contact.place - centre).dot(period) / period.norm() - 0.5 * period.norm()) < spacing);
        // Bisectors of the Dirichlet cell only belong to the shortest vectors.
        for (int i = -2; i <= 2; ++i)
            for (int j = -2; j <= 2; ++j) {
                if (i == 0 && j == 0) continue;
                const Point2 other = complex.domain().translation({i, j});
                REQUIRE((contact.place - centre).norm() <= (contact.place - centre - other).norm() + 1.5 * spacing);
            }
    }
}

}  // namespace

TEST_CASE("a front on the square torus meets itself on the sides of the Dirichlet cell") {
    for (const double spacing : {0.1, 0.085}) {
        check_flat(2 * pi * Eigen::Matrix2d::Identity(), spacing, 3);
        check_flat(2 * pi * Eigen::Matrix2d::Identity(), spacing, 12);
    }
}

TEST_CASE("a front on the hexagonal torus meets itself on the sides of the Dirichlet cell") {
    Eigen::Matrix2d periods;
    periods << 2 * pi, pi, 0, pi * std::sqrt(3.0);
    for (const double spacing : {0.1, 0.08}) check_flat(periods, spacing, 3);
}

TEST_CASE("fronts on oblique tori come to an end", "[slow]") {
    for (const double shear : {0.3, 1.1, 2.0, 3.0})
        for (const double height : {2.0, 3.3, 5.0, 8.0}) {
            Eigen::Matrix2d periods;
            periods << 2 * pi, shear, 0, height;
            CAPTURE(shear, height);
            Growth growth(periods, {3.0, 2.9}, 0.07, 3, straight({3.0, 2.9}));
            while (growth.steps < 400 && growth.advance(true)) {
            }
            CHECK_FALSE(growth.advance(true));
            CHECK(growth.stuck <= 3);
        }
}

TEST_CASE("a front on a torus of revolution, past its conjugate points") {
    // Metric (R + r cos v)^2 du^2 + r^2 dv^2, r = 1; geodesics from (0, pi) by RK4, each from its start.
    constexpr double outer = 3.0;
    const Point2 centre(0.0, pi);
    const Flow flow = [&](double theta, double distance) {
        using State = Eigen::Vector4d;
        const auto w = [](double v) { return outer + std::cos(v); };
        const auto rate = [&](const State& s) {
            return State(s[2], s[3], 2 * std::sin(s[1]) / w(s[1]) * s[2] * s[3],
                         -w(s[1]) * std::sin(s[1]) * s[2] * s[2]);
        };
        State s(centre.x(), centre.y(), std::cos(theta) / w(centre.y()), std::sin(theta));
        const int pieces = 1 + static_cast<int>(distance / 0.1);
        const double dt = distance / pieces;
        for (int i = 0; i < pieces; ++i) {
            const State k1 = rate(s), k2 = rate(s + 0.5 * dt * k1), k3 = rate(s + 0.5 * dt * k2),
                        k4 = rate(s + dt * k3);
            s += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        return Point2(s[0], s[1]);
    };
    Growth growth(2 * pi * Eigen::Matrix2d::Identity(), centre, 0.08, 4, flow);
    while (growth.steps < 400 && growth.advance(true)) {
    }
    CHECK_FALSE(growth.advance(true));
    CHECK(dsc::tests::euler_characteristic(growth.complex, 1) == 1);
    WARN("torus of revolution: " << growth.steps << " steps, front " << growth.front_size() << ", left unfinished "
                                 << growth.stuck << ", contacts " << growth.contacts.size());
}

TEST_CASE("the same front has the same bits, and takes a fraction of a second") {
    std::vector<Point2> places[2];
    double seconds = 0.0;
    for (auto& run : places) {
        const auto start = std::chrono::steady_clock::now();
        Growth growth(2 * pi * Eigen::Matrix2d::Identity(), {3.0, 2.9}, 0.06, 3, straight({3.0, 2.9}));
        while (growth.steps < 400 && growth.advance(/*is_checked=*/false)) {
        }
        seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        for (std::uint32_t v = 0; v < growth.complex.vertex_capacity(); ++v)
            run.push_back(growth.complex.position(VertexId(v)));
    }
    CHECK(places[0].size() == places[1].size());
    CHECK(places[0] == places[1]);
    WARN("growth on the square torus, spacing 0.06: " << seconds << " s");
}
