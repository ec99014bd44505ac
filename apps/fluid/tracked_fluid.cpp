// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/tracked_fluid.h"

#include <fmt/core.h>

#include <limits>
#include <span>

#include "core/errors.h"
#include "core/stopwatch.h"
#include "fluid/interpolation.h"

namespace dsc::fluid_app {

using core::VertexId;

namespace {

constexpr int fluid_label = 1;
constexpr int most_rounds = 8;  // of solving anew against walls

const Point3 nowhere = Point3::Constant(std::numeric_limits<double>::quiet_NaN());

// Of each body: mass times velocity and its moment, at the places where the vertices are carried to.
std::vector<fluid::Motion<3>> motions(const fluid::SimplexMesh<3>& mesh, std::span<const double> masses,
                                      std::span<const Point3> velocities, std::span<const std::int32_t> bodies,
                                      std::size_t count) {
    std::vector<fluid::Motion<3>> result(count);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        fluid::Motion<3>& motion = result[static_cast<std::size_t>(bodies[i])];
        const Point3 momentum = masses[i] * velocities[i];
        motion.mass += masses[i];
        motion.momentum += momentum;
        motion.angular_momentum += mesh.positions[i].cross(momentum);
    }
    return result;
}

}  // namespace

TrackedFluid::TrackedFluid(const TrackedState& state, const TrackedParameters& parameters, dsc3d::Listener& listener)
    : parameters_(parameters),
      mesh_(state.tets),
      deformer_(mesh_, parameters.deform, listener, parameters.container.walls()),
      flow_(parameters.flow),
      velocity_(mesh_.complex().vertex_attributes(), Point3(Point3::Zero())),
      carried_to_(mesh_.complex().vertex_attributes(), nowhere),
      pressure_(mesh_.complex().vertex_attributes(), 0.0),
      part_(mesh_.complex().vertex_attributes(), fluid::no_part),
      body_(mesh_.complex().vertex_attributes(), fluid::no_part) {
    if (!state.edge_lengths.empty()) deformer_.restore_edge_lengths(state.edge_lengths);
    for (std::uint32_t i = 0; i < state.velocities.size(); ++i) velocity_[VertexId(i)] = state.velocities[i];
    for (std::uint32_t i = 0; i < state.pressures.size(); ++i) pressure_[VertexId(i)] = state.pressures[i];
    for (std::uint32_t i = 0; i < state.parts.size(); ++i) part_[VertexId(i)] = state.parts[i];
    fluid_.kept_volumes = state.kept_volumes;
    extract();
}

TrackedState TrackedFluid::state() const {
    TrackedState state{
        .tets = mesh_.data(), .kept_volumes = fluid_.kept_volumes, .edge_lengths = deformer_.edge_lengths()};
    for (std::uint32_t i = 0; i < mesh_.complex().vertex_capacity(); ++i) {
        const VertexId v(i);
        if (mesh_.complex().is_deleted(v)) continue;
        state.velocities.push_back(velocity_[v]);
        state.pressures.push_back(pressure_[v]);
        state.parts.push_back(part_[v]);
    }
    return state;
}

// The fluid's cells, and all that is known at their vertices.
void TrackedFluid::extract() {
    const dsc3d::Complex& complex = mesh_.complex();
    fluid::SimplexMesh<3>& mesh = fluid_.mesh;
    mesh = {};
    vertices_.clear();
    std::vector<std::uint32_t> number(complex.vertex_capacity(), 0);
    for (std::uint32_t i = 0; i < complex.tet_capacity(); ++i) {
        const core::TetId t(i);
        if (complex.is_deleted(t) || complex.label(t) != fluid_label) continue;
        auto& cell = mesh.cells.emplace_back();
        for (std::size_t k = 0; k < 4; ++k) {
            const VertexId v = complex.vertices(t)[k];
            if (number[v.index()] == 0) {
                vertices_.push_back(v);
                mesh.positions.push_back(mesh_.position(v));
                number[v.index()] = static_cast<std::uint32_t>(vertices_.size());
            }
            cell[k] = number[v.index()] - 1;
        }
    }
    mesh.phases.assign(mesh.cells.size(), 0);
    fluid_.velocities.clear();
    std::vector<std::int32_t> old_part;
    for (const VertexId v : vertices_) {
        fluid_.velocities.push_back(velocity_[v]);
        old_part.push_back(part_[v]);
    }
    const fluid::Elements<3> elements(mesh);
    const auto facets = fluid::facets(mesh);
    fluid_.masses = fluid::lumped_masses<3>(mesh, elements, flow_.densities());
    fluid_.pressures.clear();
    for (const auto& cell : mesh.cells) {
        double sum = 0;
        for (const std::uint32_t v : cell) sum += pressure_[vertices_[v]];
        fluid_.pressures.push_back(sum / 4);
    }
    const fluid::Parts parts = fluid::parts<3>(mesh, elements, facets);
    const std::size_t old_count = fluid_.kept_volumes.size();
    fluid_.kept_volumes =
        old_count == 0 ? parts.volumes
                       : fluid::regrouped_volumes(fluid_.kept_volumes,
                                                  fluid::group_parts<3>(old_count, old_part, mesh, parts), parts);
    const auto part_of = fluid::parts_of_vertices(mesh, parts);
    part_.fill(fluid::no_part);
    for (std::size_t i = 0; i < vertices_.size(); ++i) part_[vertices_[i]] = part_of[i];
}

std::vector<fluid::WallContact<3>> TrackedFluid::contacts() const {
    std::vector<fluid::WallContact<3>> result;
    for (std::uint32_t i = 0; i < vertices_.size(); ++i)
        if (mesh_.complex().is_boundary(vertices_[i]))
            parameters_.container.add_contacts(i, fluid_.mesh.positions[i], result);
    return result;
}

// Contacts of the surface that at these velocities would go through a wall, which it has not touched before.
void TrackedFluid::add_arrivals(std::span<const Point3> velocities, double dt,
                                std::vector<fluid::WallContact<3>>& contacts) const {
    std::vector<char> is_held(vertices_.size(), 0);
    for (const auto& contact : contacts) is_held[contact.vertex] = 1;
    const std::size_t first = contacts.size();
    for (std::uint32_t i = 0; i < vertices_.size(); ++i)
        if (is_held[i] == 0 && mesh_.complex().is_interface(vertices_[i]))
            parameters_.container.add_arrivals(i, fluid_.mesh.positions[i], velocities[i], dt, contacts);
    for (std::size_t k = first; k < contacts.size(); ++k) {
        if (contacts[k].speed * dt <= parameters_.deform.edge_length) continue;
        const Point3& p = fluid_.mesh.positions[contacts[k].vertex];
        throw core::RunError(
            fmt::format("the fluid leaves the domain at ({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z()));
    }
}

// Velocities at the end of the step. What would go through a wall is stopped by it and everything solved anew, as long
// as that sends something else against a wall.
fluid::FlowReport TrackedFluid::update_velocities(double dt) {
    const fluid::FlowState<3> before = fluid_;
    std::vector<fluid::WallContact<3>> walls = contacts();
    std::vector<Point3> falling = fluid_.velocities;
    for (Point3& velocity : falling) velocity += dt * parameters_.flow.fluid.gravity;
    try {
        add_arrivals(falling, dt, walls);
        for (int round = 0; round < most_rounds; ++round) {
            const fluid::FlowReport report = flow_.update_velocities(fluid_, walls, dt);
            const std::size_t held = walls.size();
            add_arrivals(fluid_.velocities, dt, walls);
            if (walls.size() == held) return report;
            fluid_ = before;
        }
        throw core::RunError("the fluid runs into walls in more ways than a step can follow");
    } catch (...) {
        fluid_ = before;
        throw;
    }
}

TrackedReport TrackedFluid::step(double dt) {
    TrackedReport report;
    core::Stopwatch watch;
    const auto lap = [&](const char* phase) {
        report.milliseconds.emplace_back(phase, 1e3 * watch.seconds());
        watch = {};
    };
    const fluid::FlowState<3> before = fluid_;
    report.flow = update_velocities(dt);
    lap("solve");

    fluid::SimplexMesh<3> advected = fluid_.mesh;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        Point3& place = advected.positions[i];
        place = parameters_.container.kept_inside(place + dt * fluid_.velocities[i]);
    }
    const std::vector<Point3> velocities = fluid_.velocities;
    const auto facets = fluid::facets(advected);
    const fluid::Parts bodies = fluid::bodies<3>(advected, fluid::Elements<3>(fluid_.mesh), facets);
    const std::vector<std::int32_t> body_of = fluid::parts_of_vertices(advected, bodies);
    const auto motion_before = motions(advected, fluid_.masses, velocities, body_of, bodies.volumes.size());
    std::vector<double> weights(vertices_.size(), 0.0), sums(vertices_.size(), 0.0);
    for (std::size_t j = 0; j < advected.cells.size(); ++j)
        for (const std::uint32_t v : advected.cells[j]) weights[v] += 1, sums[v] += fluid_.pressures[j];
    std::vector<std::optional<Point3>> targets(mesh_.complex().vertex_capacity());
    carried_to_.fill(nowhere);
    body_.fill(fluid::no_part);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const VertexId v = vertices_[i];
        velocity_[v] = velocities[i];
        pressure_[v] = sums[i] / weights[i];
        carried_to_[v] = advected.positions[i];
        body_[v] = body_of[i];
        if (mesh_.complex().is_interface(v)) targets[v.index()] = advected.positions[i];
    }
    try {
        report.deform = deformer_.step(targets);
    } catch (...) {
        fluid_ = before;
        for (std::size_t i = 0; i < vertices_.size(); ++i) velocity_[vertices_[i]] = before.velocities[i];
        throw;
    }
    lap("deform");

    extract();
    report.transferred = transfer(advected, velocities);
    if (parameters_.conserves_momentum) {
        std::vector<std::int32_t> old_body;
        for (const VertexId v : vertices_) old_body.push_back(body_[v]);
        give_back_momentum(motion_before, old_body);
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) velocity_[vertices_[i]] = fluid_.velocities[i];
    lap("transfer");
    return report;
}

// Velocities of vertices that are not where the flow has carried them.
std::size_t TrackedFluid::transfer(const fluid::SimplexMesh<3>& advected, const std::vector<Point3>& velocities) {
    const fluid::Interpolation<3> interpolation(advected);
    std::size_t count = 0;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        if (carried_to_[vertices_[i]] == fluid_.mesh.positions[i]) continue;
        fluid_.velocities[i] = interpolation.value_at(fluid_.mesh.positions[i], velocities);
        ++count;
    }
    return count;
}

void TrackedFluid::give_back_momentum(const std::vector<fluid::Motion<3>>& before,
                                      const std::vector<std::int32_t>& old_body) {
    const fluid::SimplexMesh<3>& mesh = fluid_.mesh;
    const fluid::Elements<3> elements(mesh);
    const auto facets = fluid::facets(mesh);
    const fluid::Parts bodies = fluid::bodies<3>(mesh, elements, facets);
    const fluid::PartGroups groups = fluid::group_parts<3>(before.size(), old_body, mesh, bodies);
    std::vector<fluid::Motion<3>> wanted(groups.count);
    for (std::size_t i = 0; i < before.size(); ++i) {
        wanted[groups.of_old[i]].momentum += before[i].momentum;
        wanted[groups.of_old[i]].angular_momentum += before[i].angular_momentum;
    }
    const std::vector<std::int32_t> body_of = fluid::parts_of_vertices(mesh, bodies);
    std::vector<std::vector<std::size_t>> members(groups.count);
    std::vector<char> is_held(groups.count, 0);
    for (std::size_t i = 0; i < vertices_.size(); ++i)
        members[groups.of_new[static_cast<std::size_t>(body_of[i])]].push_back(i);
    for (const auto& contact : contacts())
        is_held[groups.of_new[static_cast<std::size_t>(body_of[contact.vertex])]] = 1;
    for (std::size_t g = 0; g < groups.count; ++g) {
        if (is_held[g] != 0 || members[g].empty()) continue;  // walls take up what is missing
        std::vector<Point3> places, velocities;
        std::vector<double> masses;
        for (const std::size_t i : members[g]) {
            places.push_back(mesh.positions[i]);
            velocities.push_back(fluid_.velocities[i]);
            masses.push_back(fluid_.masses[i]);
        }
        fluid::correct_motion<3>(places, masses, wanted[g], velocities);
        for (std::size_t k = 0; k < members[g].size(); ++k) fluid_.velocities[members[g][k]] = velocities[k];
    }
}

}  // namespace dsc::fluid_app
