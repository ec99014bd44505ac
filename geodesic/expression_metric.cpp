// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic/expression_metric.h"

#include <array>
#include <cmath>

#include "core/errors.h"
#include "geodesic/expression/derivatives.h"
#include "geodesic/expression/program.h"
#include "geodesic/metric_jet.h"

namespace dsc::geodesic {

namespace {

using expression::JetGraph;
using expression::Program;

constexpr std::array parts{&ScalarJet::value, &ScalarJet::u,   &ScalarJet::v,   &ScalarJet::uu,  &ScalarJet::uv,
                           &ScalarJet::vv,    &ScalarJet::uuu, &ScalarJet::uuv, &ScalarJet::uvv, &ScalarJet::vvv};

JetGraph read(std::string_view source, std::string_view text, const std::vector<std::string>& components) {
    const expression::SourceText option{source, text};
    return expression::differentiated(option, expression::parse_components(option, components));
}

const ChartPeriods& checked(const ChartPeriods& periods) {
    for (const auto& period : {periods.u, periods.v})
        if (period && !(*period > 0 && std::isfinite(*period)))
            throw core::UsageError("--period must be positive, e.g. 6.283185307179586; it is " +
                                   std::to_string(*period));
    return periods;
}

/// The derivatives of order Lowest to Highest of three functions, by one program.
template <int Lowest, int Highest>
class TripleJet {
public:
    explicit TripleJet(const JetGraph& jets) : program_(jets.graph, outputs(jets)) {}

    std::array<ScalarJet, 3> at(const Point2& x) const {
        std::array<double, 3 * count> values;
        program_.evaluate(x.x(), x.y(), values);
        std::array<ScalarJet, 3> result;
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < count; ++i) result[c].*parts[first + i] = values[c * count + i];
        return result;
    }

private:
    static constexpr std::size_t first = expression::derivative_count(Lowest - 1);
    static constexpr std::size_t count = expression::derivative_count(Highest) - first;

    static std::vector<expression::Multiple> outputs(const JetGraph& jets) {
        std::vector<expression::Multiple> result;
        for (const auto& component : jets.components)
            for (std::size_t i = 0; i < count; ++i) result.push_back(component[first + i]);
        return result;
    }

    Program program_;
};

}  // namespace

class ExpressionEmbedding::Programs {
public:
    explicit Programs(const JetGraph& jets) : position(jets), tangents(jets), jet(jets) {}

    MetricJet metric_jet(const Point2& x) const {
        const auto [rx, ry, rz] = jet.at(x);
        return embedding_jet(rx, ry, rz);
    }

    TripleJet<0, 0> position;
    TripleJet<1, 1> tangents;
    TripleJet<1, 3> jet;
};

ExpressionEmbedding::ExpressionEmbedding(std::string_view text, ChartPeriods periods, std::string_view source)
    : Metric(checked(periods)), programs_(std::make_unique<Programs>(read(source, text, {"x", "y", "z"}))) {}
ExpressionEmbedding::~ExpressionEmbedding() = default;

MetricTensor ExpressionEmbedding::tensor(const Point2& x) const {
    MetricTensor result{0, 0, 0};
    for (const ScalarJet& coordinate : programs_->tangents.at(x)) {
        result.E += coordinate.u * coordinate.u;
        result.F += coordinate.u * coordinate.v;
        result.G += coordinate.v * coordinate.v;
    }
    return result;
}

LocalGeometry ExpressionEmbedding::local_geometry(const Point2& x) const {
    return geodesic::local_geometry(programs_->metric_jet(x));
}

ConnectionJet ExpressionEmbedding::connection_jet(const Point2& x) const {
    return geodesic::connection_jet(programs_->metric_jet(x));
}

std::optional<Point3> ExpressionEmbedding::position(const Point2& x) const {
    const auto [rx, ry, rz] = programs_->position.at(x);
    return Point3{rx.value, ry.value, rz.value};
}

class ExpressionMetric::Programs {
public:
    explicit Programs(const JetGraph& jets) : value(jets), second_order(jets), third_order(jets) {}

    TripleJet<0, 0> value;
    TripleJet<0, 2> second_order;
    TripleJet<0, 3> third_order;
};

ExpressionMetric::ExpressionMetric(std::string_view text, ChartPeriods periods, std::string_view source)
    : Metric(checked(periods)), programs_(std::make_unique<Programs>(read(source, text, {"E", "F", "G"}))) {}
ExpressionMetric::~ExpressionMetric() = default;

MetricTensor ExpressionMetric::tensor(const Point2& x) const {
    const auto [E, F, G] = programs_->value.at(x);
    return {E.value, F.value, G.value};
}

LocalGeometry ExpressionMetric::local_geometry(const Point2& x) const {
    const auto [E, F, G] = programs_->third_order.at(x);
    return geodesic::local_geometry(tensor_jet(E, F, G));
}

ConnectionJet ExpressionMetric::connection_jet(const Point2& x) const {
    const auto [E, F, G] = programs_->second_order.at(x);
    return geodesic::connection_jet(tensor_jet(E, F, G));
}

}  // namespace dsc::geodesic
