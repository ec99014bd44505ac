// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/sizing.h"

#include <utility>

#include "dsc3d/interface.h"
#include "motion/expression_field.h"
#include "surface/sizing.h"

namespace dsc::flow {

namespace {

constexpr double least_share = 0.25;  ///< of the edge length, by curvature and thickness
constexpr double max_turn = 20;       ///< of the surface along an edge, by curvature [degree]
constexpr double edges_across = 1;    ///< what is enclosed, by thickness

surface::SizingParameters parameters_of(const std::string& text, double edge_length) {
    surface::SizingParameters parameters{.length = edge_length, .min_length = least_share * edge_length};
    if (text == "curvature") {
        parameters.max_turn = max_turn;
    } else if (text == "thickness") {
        parameters.edges_across = edges_across;
    } else {
        // A velocity whose first coordinate is the length.
        const motion::VelocityField<3> field = motion::expression_field<3>("(" + text + ", 0, 0)", "--sizing");
        parameters.field = [field](const geometry::Point3& p) { return field(p, 0).x(); };
        parameters.min_length = 0.01 * edge_length;
    }
    return parameters;
}

}  // namespace

Targets with_sizing(Targets motion, const std::string& text, double edge_length) {
    if (text == "uniform") return motion;
    return [motion = std::move(motion), parameters = parameters_of(text, edge_length)](const dsc3d::Mesh& mesh,
                                                                                       double time, double dt) {
        StepMotion step = motion(mesh, time, dt);
        const dsc3d::Interface interface(mesh);
        const std::vector<double> lengths = surface::wanted_lengths(interface.data.surface, parameters);
        step.edge_lengths.resize(mesh.complex().vertex_capacity());
        for (std::size_t i = 0; i < lengths.size(); ++i) step.edge_lengths[interface.vertices[i].index()] = lengths[i];
        return step;
    };
}

}  // namespace dsc::flow
