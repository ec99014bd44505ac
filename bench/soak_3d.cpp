// SPDX-License-Identifier: GPL-3.0-or-later
// A long life of a small complex: curl noise that is drawn anew every 50 steps stirs two or three labels. Three motions
// are added to it, none of which the noise itself asks for: every object is blown up or let shrink towards the volume
// it had at first, since contacts and resampling lose some; the interface contracts a little as a soap film does; and
// it is driven off the walls, where it would gather. The sum is cut to half an edge length in a step. Where nothing may
// merge or split, the noise turns round every 17 steps, and the interface contracts faster: noise that goes on folds a
// surface without end, until it consists of sheets in contact. After every step the whole complex is
// validated: relations, orientation by exact predicate, manifoldness. Exit code 1 at the first failure.
//
//     soak_3d                                        # 10,000 steps, two labels, adaptive
//     soak_3d --labels 3
//     soak_3d --topology preserved --steps 2000      # components and genus of every label stay
#include <fmt/core.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "apps/common/command_line.h"
#include "apps/common/run_main.h"
#include "core/errors.h"
#include "dsc3d/deform/deformer.h"
#include "dsc3d/generate/fit.h"
#include "dsc3d/generate/lattice.h"
#include "dsc3d/improve/angle_range.h"
#include "dsc3d/label_statistics.h"
#include "io/tet_mesh.h"
#include "motion/curl_noise.h"

namespace {

using namespace dsc;
using namespace dsc::dsc3d;

constexpr double spacing = 0.17;
constexpr double edge_length = 0.11;
constexpr int steps_per_draw = 50;
constexpr int background = 0;
constexpr double restoring_rate = 0.3;  // share of what an object lacks that comes back in a step
constexpr double wall_layer = 1;        // in which everything is driven off the wall [edge length]
constexpr double least_allowed = 0.10;  // share of the domain that every label has to keep
constexpr double stride = 0.5;          // largest displacement of a step [edge length]

/// What a topology policy is stirred with.
struct Regime {
    double max_frequency;  ///< of the noise: its shortest waves are 6.4 edges long, or 9
    int steps_per_turn;    ///< after which the noise turns round
    double tension;        ///< way per curvature in a step [edge length^2]
};
constexpr Regime adaptive_regime = {.max_frequency = 1.5, .steps_per_turn = steps_per_draw, .tension = 0.02};
constexpr Regime preserved_regime = {.max_frequency = 1, .steps_per_turn = 17, .tension = 0.1};

// What a run of the full length has to reach.
constexpr int least_events = 100;       // merges, and splits, when these are allowed
constexpr double least_arrived = 0.99;  // of the vertices that no contact stops, when nothing may merge or split
constexpr double most_growth = 1.5;     // of the resident memory, since a tenth of the steps

struct SoakOptions {
    int steps = 10000;
    int labels = 2;
    int seed = 1;
    motion::TopologyPolicy topology = motion::TopologyPolicy::adaptive;
    std::optional<std::string> last;  ///< where the mesh goes at the end
};

class EventCounter final : public Listener {
public:
    void on_event(const Event& event) override { ++(event.label == background ? merges : splits); }

    int merges = 0, splits = 0;
};

// A ball of a quarter of the domain; with three labels, the halves of a rounded cube of two fifths.
Mesh start_mesh(int labels) {
    Mesh mesh(lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, spacing));
    const auto body = [&](const Point3& p) {
        const Eigen::Array3d x = (p - Point3(0.5, 0.5, 0.5)).array();
        return (labels == 2 ? x.matrix().norm() : std::pow(x.pow(4).sum(), 0.25)) - 0.4;
    };
    fit(mesh, body, {.inside = 1});
    if (labels == 3) fit(mesh, [&](const Point3& p) { return std::max(p.x() - 0.5, body(p)); }, {.inside = 2});
    return mesh;
}

std::size_t resident_bytes() {
    std::ifstream file("/proc/self/statm");
    std::size_t whole = 0, resident = 0;
    file >> whole >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

bool is_moved(const Mesh& mesh, VertexId v) { return !mesh.complex().is_deleted(v) && mesh.complex().is_interface(v); }

// Out of the label's region, not normalized: zero where it does not reach.
std::vector<Eigen::Vector3d> normals_of(const Mesh& mesh, int label) {
    const Complex& complex = mesh.complex();
    std::vector<Eigen::Vector3d> normals(complex.vertex_capacity(), Eigen::Vector3d::Zero());
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        const FaceId f(i);
        if (complex.is_deleted(f) || !complex.is_interface(f)) continue;
        for (const TetId t : complex.tets(f)) {
            if (complex.label(t) != label) continue;
            const FaceVertices v = complex.oriented_face(t, complex.index_of(t, f));
            const Point3& a = mesh.position(v[0]);
            const Eigen::Vector3d normal = (mesh.position(v[1]) - a).cross(mesh.position(v[2]) - a);
            for (const VertexId corner : v) normals[corner.index()] += normal;
        }
    }
    return normals;
}

using Ways = std::vector<Eigen::Vector3d>;
using Targets = std::vector<std::optional<Point3>>;

// Every object is blown up, or let shrink, towards the volume it had, evenly over its interface.
void restore_volumes(const Mesh& mesh, std::span<const LabelStatistics> labels, std::span<const LabelStatistics> wanted,
                     Ways& ways) {
    for (std::size_t k = 0; k < labels.size(); ++k) {
        if (labels[k].label == background) continue;
        const double offset = restoring_rate * (wanted[k].volume - labels[k].volume) / labels[k].interface_area;
        const std::vector<Eigen::Vector3d> normals = normals_of(mesh, labels[k].label);
        for (std::size_t i = 0; i < ways.size(); ++i)
            if (!normals[i].isZero(0)) ways[i] += offset * normals[i].normalized();
    }
}

// The interface contracts as a soap film does, at a speed in proportion to its curvature, as far as edges of the wanted
// length resolve it: a vertex counts with an edge length squared at least.
void relax_interface(const Mesh& mesh, double tension, Ways& ways) {
    const Complex& complex = mesh.complex();
    std::vector<Eigen::Vector3d> gradients(ways.size(), Eigen::Vector3d::Zero());  // of the area
    std::vector<double> areas(ways.size(), 0.0);
    for (std::uint32_t i = 0; i < complex.face_capacity(); ++i) {
        const FaceId f(i);
        if (complex.is_deleted(f) || !complex.is_interface(f)) continue;
        const FaceVertices v = complex.vertices(f);
        const Eigen::Vector3d scaled =
            (mesh.position(v[1]) - mesh.position(v[0])).cross(mesh.position(v[2]) - mesh.position(v[0]));
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3d side = mesh.position(v[(k + 2) % 3]) - mesh.position(v[(k + 1) % 3]);
            gradients[v[k].index()] += 0.5 * scaled.normalized().cross(side);
            areas[v[k].index()] += scaled.norm() / 6;
        }
    }
    for (std::size_t i = 0; i < ways.size(); ++i)
        if (areas[i] > 0)
            ways[i] -=
                tension * edge_length * edge_length / std::max(areas[i], edge_length * edge_length) * gradients[i];
}

// Walls are not what is soaked: in front of them everything is driven inwards, the more the nearer they are,
Eigen::Vector3d off_walls(const Point3& p) {
    Eigen::Vector3d way;
    for (int k = 0; k < 3; ++k) {
        const double low = std::max(0.0, 1 - p[k] / (wall_layer * edge_length));
        const double high = std::max(0.0, 1 - (1 - p[k]) / (wall_layer * edge_length));
        way[k] = stride * edge_length * (low - high);
    }
    return way;
}

// ... and what has come to them recedes along them.
void recede_along_walls(const Mesh& mesh, std::span<const LabelStatistics> labels, Ways& ways) {
    for (std::uint32_t i = 0; i < ways.size(); ++i)
        if (is_moved(mesh, VertexId(i)) && mesh.complex().is_boundary(VertexId(i))) ways[i].setZero();
    for (const LabelStatistics& label : labels) {
        if (label.label == background) continue;
        const std::vector<Eigen::Vector3d> normals = normals_of(mesh, label.label);
        for (std::uint32_t i = 0; i < ways.size(); ++i) {
            const VertexId v(i);
            if (!is_moved(mesh, v) || !mesh.complex().is_boundary(v)) continue;
            Eigen::Vector3d along = normals[i];
            for (int k = 0; k < 3; ++k)
                if (mesh.position(v)[k] == 0 || mesh.position(v)[k] == 1) along[k] = 0;
            if (!along.isZero(0)) ways[i] -= stride * edge_length * along.normalized();
        }
    }
}

// Scaled so that the largest way is a stride.
Ways noise_ways(const Mesh& mesh, const motion::VelocityField<3>& noise, const Regime& regime, int step) {
    Ways ways(mesh.complex().vertex_capacity(), Eigen::Vector3d::Zero());
    double largest = 0;
    for (std::uint32_t i = 0; i < ways.size(); ++i) {
        if (!is_moved(mesh, VertexId(i))) continue;
        ways[i] = noise(mesh.position(VertexId(i)), 0);
        largest = std::max(largest, ways[i].norm());
    }
    const bool is_back = step % steps_per_draw / regime.steps_per_turn % 2 == 1;
    for (Eigen::Vector3d& way : ways) way *= (is_back ? -1 : 1) * stride * edge_length / largest;
    return ways;
}

Targets targets_of(const Mesh& mesh, Ways ways, std::span<const LabelStatistics> labels,
                   std::span<const LabelStatistics> wanted, double tension) {
    relax_interface(mesh, tension, ways);
    restore_volumes(mesh, labels, wanted, ways);
    for (std::uint32_t i = 0; i < ways.size(); ++i)
        if (is_moved(mesh, VertexId(i))) ways[i] += off_walls(mesh.position(VertexId(i)));
    recede_along_walls(mesh, labels, ways);
    Targets targets(ways.size());
    for (std::uint32_t i = 0; i < ways.size(); ++i) {
        if (!is_moved(mesh, VertexId(i))) continue;
        const double longest = stride * edge_length;
        targets[i] = mesh.position(VertexId(i)) + ways[i] * (longest / std::max(longest, ways[i].norm()));
    }
    return targets;
}

[[noreturn]] void fail(int step, const std::string& why) {
    throw core::RunError(fmt::format("step {}: {}", step, why));
}

// Share of the vertices with a target that no contact has stopped.
double arrived(std::size_t targeted, std::size_t in_contact, std::size_t unfinished) {
    return 1 - static_cast<double>(unfinished) / static_cast<double>(targeted - in_contact);
}

int soak(const SoakOptions& options) {
    Mesh mesh = start_mesh(options.labels);
    const Regime& regime = options.topology == motion::TopologyPolicy::preserved ? preserved_regime : adaptive_regime;
    fmt::print(
        "stride {} L; noise of {} waves across the domain at most, turned round every {} steps; tension {} L^2; "
        "{} of lost volumes restored\n",
        stride, regime.max_frequency, regime.steps_per_turn, regime.tension, restoring_rate);
    EventCounter events;
    Deformer deformer(
        mesh,
        {.edge_length = edge_length, .seed = static_cast<std::uint64_t>(options.seed), .topology = options.topology},
        events);
    deformer.improve_everywhere();
    std::vector<LabelStatistics> labels = label_statistics(mesh);
    const std::vector<LabelStatistics> first = labels;
    motion::VelocityField<3> noise;
    std::size_t targeted = 0, in_contact = 0, unfinished = 0, early_bytes = 0;
    double worst_angle = 180, seconds = 0;
    for (int step = 0; step < options.steps; ++step) {
        if (step % steps_per_draw == 0)
            noise = motion::curl_noise(
                motion::CurlNoiseParameters<3>{.has_walls = true,
                                               .max_frequency = regime.max_frequency,
                                               .seed = static_cast<std::uint64_t>(options.seed) * 1000003 +
                                                       static_cast<std::uint64_t>(step / steps_per_draw)});
        const Targets targets = targets_of(mesh, noise_ways(mesh, noise, regime, step), labels, first, regime.tension);
        const std::clock_t start = std::clock();
        const StepReport report = deformer.step(targets);
        seconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        targeted +=
            static_cast<std::size_t>(std::ranges::count_if(targets, [](const auto& t) { return t.has_value(); }));
        for (const auto& motion : report.unfinished) ++(motion.is_locked ? in_contact : unfinished);

        if (const std::vector<std::string> errors = validate(mesh); !errors.empty()) fail(step, errors.front());
        labels = label_statistics(mesh);
        if (labels.size() != first.size()) fail(step, "a label is gone");
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (labels[i].volume < least_allowed)
                fail(step, fmt::format("label {} has {:.3g} of the volume left", labels[i].label, labels[i].volume));
            if (options.topology == motion::TopologyPolicy::preserved &&
                (labels[i].components != first[i].components || labels[i].genus != first[i].genus))
                fail(step, fmt::format("label {} has {} components of genus {}", labels[i].label, labels[i].components,
                                       labels[i].genus));
        }
        if (step == options.steps / 10) early_bytes = resident_bytes();
        const double angle = AngleRange(mesh).min * 180 / EIGEN_PI;
        worst_angle = std::min(worst_angle, angle);
        if ((step + 1) % std::max(1, options.steps / 20) != 0) continue;
        fmt::print("step {}: {} tets, smallest angle {:.2f} (of all steps {:.2f}), {} merges, {} splits, ", step + 1,
                   mesh.complex().tet_count(), angle, worst_angle, events.merges, events.splits);
        for (const LabelStatistics& label : labels)
            fmt::print("label {}: {:.3f} in {} of genus {}, ", label.label, label.volume, label.components,
                       label.genus);
        fmt::print("arrived {:.3f} %, in contact {:.3f} %, {:.1f} ms per step, {:.1f} MB\n",
                   100.0 * arrived(targeted, in_contact, unfinished),
                   100.0 * static_cast<double>(in_contact) / static_cast<double>(targeted), 1e3 * seconds / (step + 1),
                   static_cast<double>(resident_bytes()) / 1e6);
        std::fflush(stdout);
    }
    if (options.last) io::write_tet_mesh(*options.last, mesh.data());
    if (static_cast<double>(resident_bytes()) > most_growth * static_cast<double>(early_bytes))
        fail(options.steps, "memory grows");
    if (options.topology == motion::TopologyPolicy::preserved) {
        if (arrived(targeted, in_contact, unfinished) < least_arrived) fail(options.steps, "too many vertices lag");
    } else if (options.steps >= SoakOptions().steps && std::min(events.merges, events.splits) < least_events) {
        fail(options.steps, "too few merges or splits");
    }
    return apps::exit_done;
}

int run(int argc, const char* const* argv) {
    SoakOptions options;
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        const auto value = [&] {
            if (i + 1 == argc) throw core::UsageError(name + ": a value is missing");
            return std::string(argv[++i]);
        };
        if (name == "--steps") {
            options.steps = std::stoi(value());
        } else if (name == "--labels") {
            options.labels = std::stoi(value());
        } else if (name == "--seed") {
            options.seed = std::stoi(value());
        } else if (name == "--last") {
            options.last = value();
        } else if (name == "--topology") {
            const std::string policy = value();
            if (policy != "adaptive" && policy != "preserved")
                throw core::UsageError("--topology: adaptive or preserved");
            if (policy == "preserved") options.topology = motion::TopologyPolicy::preserved;
        } else {
            throw core::UsageError(name + ": unknown");
        }
    }
    if (options.labels != 2 && options.labels != 3) throw core::UsageError("--labels: 2 or 3");
    return soak(options);
}

}  // namespace

int main(int argc, char** argv) {
    return dsc::apps::run_main("soak_3d", [&] { return run(argc, argv); });
}
