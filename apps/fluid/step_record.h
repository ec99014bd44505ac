// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a run after each step. Cost: linear in the mesh.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "apps/fluid/tracked_fluid.h"
#include "core/fields.h"

namespace dsc::fluid_app {

struct StepRecord {
    int step = 0;
    double time = 0;
    double dt = 0;
    std::size_t vertices = 0, cells = 0, tets = 0, surface_faces = 0;
    std::vector<double> volumes;       ///< of the connected parts, descending
    std::vector<double> kept_volumes;  ///< what compensation brings them back to, in the same order
    Point3 centre = Point3::Zero();    ///< of mass
    Point3 momentum = Point3::Zero(), angular_momentum = Point3::Zero();
    double kinetic_energy = 0, surface_energy = 0, potential_energy = 0;
    double max_speed = 0;
    double max_divergence = 0;  ///< see fluid::FlowReport
    int solver_iterations = 0;
    std::size_t transferred = 0;  ///< vertices that got their velocity by interpolation
    std::size_t unfinished = 0;   ///< vertices that did not come where the flow carried them
    double min_dihedral = 0;      ///< of all tetrahedra [degree]
    std::vector<std::pair<std::string, double>> milliseconds;
};

template <class Visitor, core::ConstOrNot<StepRecord> Value>
void fields(Visitor& visitor, Value& record) {
    auto& [step, time, dt, vertices, cells, tets, surface_faces, volumes, kept_volumes, centre, momentum,
           angular_momentum, kinetic_energy, surface_energy, potential_energy, max_speed, max_divergence,
           solver_iterations, transferred, unfinished, min_dihedral, milliseconds] = record;
    visitor(step, time, dt, vertices, cells, tets, surface_faces, volumes, kept_volumes, centre, momentum,
            angular_momentum, kinetic_energy, surface_energy, potential_energy, max_speed, max_divergence,
            solver_iterations, transferred, unfinished, min_dihedral, milliseconds);
}

struct Event {
    std::string kind;  ///< "merge", "split", or the number of parts when it has changed: "2 parts"
    int step = 0;
    double time = 0;
    Point3 place = Point3::Zero();
};

template <class Visitor, core::ConstOrNot<Event> Value>
void fields(Visitor& visitor, Value& event) {
    auto& [kind, step, time, place] = event;
    visitor(kind, step, time, place);
}

StepRecord step_record(const TrackedFluid& fluid, int step, double time);

}  // namespace dsc::fluid_app
