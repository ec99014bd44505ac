// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/fit.h"

#include <cmath>
#include <limits>

#include "core/errors.h"
#include "dsc3d/complex/traversal.h"
#include "dsc3d/operations/split.h"

namespace dsc::dsc3d {

namespace {

using Function = std::function<double(const Point3&)>;

constexpr int max_bisections = 60;

class Fit {
public:
    /// Without a function the one given by `values` is linear along the edges.
    Fit(Mesh& mesh, const Function& function, const FitParameters& parameters)
        : mesh_(mesh),
          complex_(mesh.complex()),
          function_(function),
          parameters_(parameters),
          value_(mesh.complex().vertex_attributes(), 0.0) {}

    void run() {
        evaluate();
        finish();
    }

    void run(std::span<const double> values) {
        if (values.size() != complex_.vertex_capacity())
            throw core::UsageError("fit: there have to be as many values as vertices");
        for_each<VertexId>(complex_.vertex_capacity(), complex_, [&](VertexId v) { take(v, values[v.index()]); });
        finish();
    }

private:
    void finish() {
        warp();
        cut();
        label();
    }

    template <class Handle, class Use>
    static void for_each(std::uint32_t count, const Complex& complex, Use&& use) {
        for (std::uint32_t i = 0; i < count; ++i)
            if (!complex.is_deleted(Handle(i))) use(Handle(i));
    }

    void evaluate() {
        for_each<VertexId>(complex_.vertex_capacity(), complex_,
                           [&](VertexId v) { take(v, function_(mesh_.position(v))); });
    }

    void take(VertexId v, double value) {
        value_[v] = value;
        if (!std::isfinite(value)) throw core::UsageError("fit: the function is not finite at a vertex of the mesh");
        if (complex_.is_boundary(v) && value <= 0)
            throw core::UsageError("fit: the surface reaches the boundary of the domain; make the domain larger");
    }

    // Share of the way from a to b at which the function vanishes. Precondition: it has different signs there.
    double crossing(VertexId a, VertexId b) const {
        if (!function_) return value_[a] / (value_[a] - value_[b]);
        const Point3 &p = mesh_.position(a), &q = mesh_.position(b);
        double low = 0, high = 1;
        for (int i = 0; i < max_bisections && high - low > 1e-15; ++i) {
            const double middle = 0.5 * (low + high);
            const double value = function_(p + middle * (q - p));
            if (value == 0) return middle;
            ((value < 0) == (value_[a] < 0) ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    bool is_crossed(VertexId a, VertexId b) const { return value_[a] * value_[b] < 0; }

    // A vertex goes to the nearest crossing of its edges, if that is near and leaves its star positive.
    void warp() {
        StarWalker walker(complex_);
        std::vector<VertexId> others;
        for_each<VertexId>(complex_.vertex_capacity(), complex_, [&](VertexId v) {
            if (complex_.is_boundary(v) || value_[v] == 0) return;
            const std::span<const TetId> star = walker.star(v, others);
            const Point3 before = mesh_.position(v);
            Point3 nearest = before;
            double distance = std::numeric_limits<double>::infinity();
            for (const VertexId u : others) {
                if (!is_crossed(u, v)) continue;
                const double share = crossing(v, u);
                const Eigen::Vector3d way = share * (mesh_.position(u) - before);
                if (share > parameters_.warp || way.norm() >= distance) continue;
                distance = way.norm();
                nearest = before + way;
            }
            if (!std::isfinite(distance)) return;
            mesh_.set_position(v, nearest);
            for (const TetId t : star) {
                if (mesh_.is_positive(complex_.vertices(t))) continue;
                mesh_.set_position(v, before);
                return;
            }
            value_[v] = 0;
        });
    }

    void cut() {
        // Edges that a split adds end at the surface: they are never crossed.
        for_each<EdgeId>(complex_.edge_capacity(), complex_, [&](EdgeId e) {
            const auto [a, b] = complex_.vertices(e);
            if (!is_crossed(a, b)) return;
            const Point3 place = mesh_.position(a) + crossing(a, b) * (mesh_.position(b) - mesh_.position(a));
            if (!can_split(mesh_, e, place))
                throw core::RunError("fit: an edge can't be split where the surface crosses it");
            const VertexId m = split(mesh_, e, place);
            value_[m] = 0;
        });
    }

    // A tetrahedron with all its vertices on the surface goes to the side of its centroid; when only values are known,
    // it stays outside.
    void label() {
        for_each<TetId>(complex_.tet_capacity(), complex_, [&](TetId t) {
            double sum = 0;
            Point3 centroid = Point3::Zero();
            for (const VertexId v : complex_.vertices(t)) sum += value_[v], centroid += 0.25 * mesh_.position(v);
            if (sum == 0 && function_) sum = function_(centroid);
            if (sum < 0) complex_.set_label(t, parameters_.inside);
        });
    }

    Mesh& mesh_;
    Complex& complex_;
    Function function_;
    FitParameters parameters_;
    core::Attribute<VertexId, double> value_;
};

void require_valid(const FitParameters& parameters) {
    if (!(parameters.warp >= 0 && parameters.warp < 0.5)) throw core::UsageError("fit: warp has to be in [0, 0.5)");
}

}  // namespace

void fit(Mesh& mesh, const Function& function, const FitParameters& parameters) {
    require_valid(parameters);
    Fit(mesh, function, parameters).run();
}

void fit(Mesh& mesh, std::span<const double> values, const FitParameters& parameters) {
    require_valid(parameters);
    Fit(mesh, nullptr, parameters).run(values);
}

}  // namespace dsc::dsc3d
