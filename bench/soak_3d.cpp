// SPDX-License-Identifier: GPL-3.0-or-later
// A long life of a small complex: curl noise that is drawn anew every 50 steps stirs two or three labels, the largest
// displacement of a step half an edge length; a label that gets scarce is inflated. After every step the whole complex
// is validated: relations, orientation by exact predicate, manifoldness. Exit code 1 at the first failure.
//
//     soak_3d                                        # 10,000 steps, two labels, adaptive
//     soak_3d --labels 3
//     soak_3d --topology preserved --steps 2000      # components and genus of every label stay
#include <fmt/core.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <functional>

#include "apps/common/command_line.h"
#include "apps/common/run_main.h"
#include "core/errors.h"
#include "core/stopwatch.h"
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
constexpr double scarce = 0.17;         // share of the domain below which a label is inflated,
constexpr double urgent = 0.13;         // ... and below which nothing else moves it
constexpr double least_allowed = 0.10;  // share of the domain that every label has to keep
constexpr double stride = 0.5;          // largest displacement of a step [edge length]
constexpr double max_frequency = 2;     // of the noise: its shortest waves are 4.5 edges long

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
    explicit EventCounter(int background) : background_(background) {}
    void on_event(const Event& event) override { ++(event.label == background_ ? merges : splits); }

    int merges = 0, splits = 0;

private:
    int background_;
};

// A ball of a quarter of the domain; with three labels, of two halves.
Mesh start_mesh(int labels) {
    Mesh mesh(lattice({Point3(0, 0, 0), Point3(1, 1, 1)}, spacing));
    const auto ball = [](const Point3& p) { return (p - Point3(0.5, 0.5, 0.5)).norm() - 0.4; };
    fit(mesh, ball, {.inside = 1});
    if (labels == 3) fit(mesh, [&](const Point3& p) { return std::max(p.x() - 0.5, ball(p)); }, {.inside = 2});
    return mesh;
}

std::size_t resident_bytes() {
    std::ifstream file("/proc/self/statm");
    std::size_t whole = 0, resident = 0;
    file >> whole >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

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

using Targets = std::vector<std::optional<Point3>>;

Targets targets_of(const Mesh& mesh, const motion::VelocityField<3>& noise,
                   const std::vector<LabelStatistics>& labels) {
    const Complex& complex = mesh.complex();
    std::vector<Eigen::Vector3d> way(complex.vertex_capacity(), Eigen::Vector3d::Zero());
    double largest = 0;
    for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
        const VertexId v(i);
        if (complex.is_deleted(v) || !complex.is_interface(v) || complex.is_boundary(v)) continue;
        way[i] = noise(mesh.position(v), 0);
        largest = std::max(largest, way[i].norm());
    }
    for (Eigen::Vector3d& w : way) w *= stride * edge_length / largest;
    for (const LabelStatistics& label : labels) {
        if (label.volume > scarce) continue;
        const double share = std::min(1.0, (scarce - label.volume) / (scarce - urgent));
        const std::vector<Eigen::Vector3d> normals = normals_of(mesh, label.label);
        for (std::size_t i = 0; i < way.size(); ++i)
            if (!normals[i].isZero(0))
                way[i] = (1 - share) * way[i] + share * stride * edge_length * normals[i].normalized();
    }
    Targets targets(complex.vertex_capacity());
    for (std::uint32_t i = 0; i < targets.size(); ++i) {
        const VertexId v(i);
        if (complex.is_deleted(v) || !complex.is_interface(v) || complex.is_boundary(v)) continue;
        const Point3& p = mesh.position(v);
        // What comes to a wall rests there, half an edge length in front: walls are not what is soaked.
        const double to_wall = std::min(p.minCoeff(), (Point3::Ones() - p).minCoeff()) / edge_length;
        targets[i] = p + std::clamp(to_wall - 0.5, 0.0, 1.0) * way[i];
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
    EventCounter events(0);
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
                                               .max_frequency = max_frequency,
                                               .seed = static_cast<std::uint64_t>(options.seed) * 1000003 +
                                                       static_cast<std::uint64_t>(step / steps_per_draw)});
        const Targets targets = targets_of(mesh, noise, labels);
        const core::Stopwatch watch;
        const StepReport report = deformer.step(targets);
        seconds += watch.seconds();
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
