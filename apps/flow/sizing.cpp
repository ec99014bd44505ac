// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/sizing.h"

#include <functional>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "dsc3d/interface.h"
#include "io/number.h"
#include "motion/expression_field.h"
#include "surface/sizing.h"

namespace dsc::flow {

namespace {

// Of the edge length.
constexpr double least_share_by_curvature = 0.25;
constexpr double least_share_by_thickness = 0.5;
constexpr double least_share_of_field = 0.01;
constexpr double max_turn = 20;  ///< of the surface along an edge, by curvature [degree]
/// What is enclosed, by thickness: what is as thin as this is told from what is about to touch, and no more.
constexpr double edges_across = 0.6;

using Parameters = std::function<surface::SizingParameters(double time)>;

Parameters parameters_of(const std::string& text, double edge_length) {
    surface::SizingParameters parameters{.length = edge_length};
    if (text == "curvature") {
        parameters.min_length = least_share_by_curvature * edge_length;
        parameters.max_turn = max_turn;
    } else if (text == "thickness") {
        parameters.min_length = least_share_by_thickness * edge_length;
        parameters.edges_across = edges_across;
    } else {
        // A velocity whose first coordinate is the length.
        const motion::VelocityField<3> field = motion::expression_field<3>("(" + text + ", 0, 0)", "--sizing");
        parameters.min_length = least_share_of_field * edge_length;
        return [parameters, field](double time) mutable {
            parameters.field = [field, time](const geometry::Point3& p) { return field(p, time).x(); };
            return parameters;
        };
    }
    return [parameters](double) { return parameters; };
}

// What the user's lengths are at the start is usage; later on it ends a run that has a good state.
std::vector<double> lengths_at(const geometry::SurfaceData& surface, const surface::SizingParameters& parameters,
                               double time) {
    try {
        return surface::wanted_lengths(surface, parameters);
    } catch (const core::UsageError& error) {
        if (time == 0) throw core::UsageError(std::string("--") + error.what());
        throw core::RunError("--" + std::string(error.what()) + " at time " + io::number_text(time, 6));
    }
}

}  // namespace

Targets with_sizing(Targets motion, const std::string& text, double edge_length) {
    if (text == "uniform") return motion;
    return [motion = std::move(motion), parameters = parameters_of(text, edge_length)](const dsc3d::Mesh& mesh,
                                                                                       double time, double dt) {
        StepMotion step = motion(mesh, time, dt);
        const dsc3d::Interface interface(mesh);
        const std::vector<double> lengths = lengths_at(interface.data.surface, parameters(time), time);
        step.edge_lengths.resize(mesh.complex().vertex_capacity());
        for (std::size_t i = 0; i < lengths.size(); ++i) step.edge_lengths[interface.vertices[i].index()] = lengths[i];
        return step;
    };
}

}  // namespace dsc::flow
