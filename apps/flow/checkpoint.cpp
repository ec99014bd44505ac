// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/checkpoint.h"

#include <algorithm>
#include <concepts>
#include <span>
#include <sstream>
#include <string>
#include <utility>

#include "core/assert.h"
#include "core/errors.h"
#include "core/version.h"
#include "io/atomic_file.h"
#include "motion/checkpoint.h"

namespace dsc::flow {

namespace {

constexpr const char* kind = "flow";
constexpr std::uint32_t version = 1;
constexpr double least_pause = 20;  // between two savings, in times that one takes

// Records and events as plain numbers, by the same list of fields for writing and reading.
struct HistoryWriter {
    std::vector<std::int64_t> integers;
    std::vector<double> reals;
    std::string text;

    template <class... Values>
    void operator()(Values&... values) {
        (add(values), ...);
    }
    template <class Value>
    void resize(std::vector<Value>& values) {
        integers.push_back(static_cast<std::int64_t>(values.size()));
    }

private:
    void add(const double& value) { reals.push_back(value); }
    void add(const std::integral auto& value) { integers.push_back(static_cast<std::int64_t>(value)); }
    void add(const std::string& value) {
        integers.push_back(static_cast<std::int64_t>(value.size()));
        text += value;
    }
};

// The other way; precondition: what a HistoryWriter with the same fields has written.
struct HistoryReader {
    std::span<const std::int64_t> integers;
    std::span<const double> reals;
    std::string_view text;

    template <class... Values>
    void operator()(Values&... values) {
        (take(values), ...);
    }
    template <class Value>
    void resize(std::vector<Value>& values) {
        std::size_t size = 0;
        take(size);
        values.resize(size);
    }

private:
    void take(double& value) {
        DSC_ASSERT(!reals.empty());
        value = reals.front();
        reals = reals.subspan(1);
    }
    template <std::integral Integer>
    void take(Integer& value) {
        DSC_ASSERT(!integers.empty());
        value = static_cast<Integer>(integers.front());
        integers = integers.subspan(1);
    }
    void take(std::string& value) {
        std::size_t size = 0;
        take(size);
        value = text.substr(0, size);
        text.remove_prefix(size);
    }
};

template <class Archive, class Value>
void list_fields(Archive& archive, std::vector<Value>& values) {
    archive.resize(values);
    for (Value& value : values) fields(archive, value);
}

// By structured bindings, so that a field that is added to a record can't be forgotten here.
template <class Archive>
void fields(Archive& archive, dsc3d::LabelStatistics& value) {
    auto& [label, tets, volume, interface_area, boundary_area, components, surfaces, genus] = value;
    archive(label, tets, volume, interface_area, boundary_area, components, surfaces, genus);
}

template <class Archive>
void fields(Archive& archive, std::pair<std::string, double>& value) {
    auto& [phase, milliseconds] = value;
    archive(phase, milliseconds);
}

template <class Archive>
void fields(Archive& archive, motion::StepCounts& value) {
    auto& [moves, blocked, flips, collapses, edge_splits, face_splits, smoothings, topology_changes] = value;
    archive(moves, blocked, flips, collapses, edge_splits, face_splits, smoothings, topology_changes);
}

template <class Archive>
void fields(Archive& archive, StepRecord& value) {
    auto& [step, time, vertices, tets, faces, unchanged, labels, min_dihedral, max_dihedral, min_quality, inverted,
           is_complete, substeps, unfinished, in_contact, remainder, counts, milliseconds] = value;
    archive(step, time, vertices, tets, faces, unchanged);
    list_fields(archive, labels);
    archive(min_dihedral, max_dihedral, min_quality, inverted, is_complete, substeps, unfinished, in_contact,
            remainder);
    fields(archive, counts);
    list_fields(archive, milliseconds);
}

template <class Archive>
void fields(Archive& archive, EventOf<3>& value) {
    auto& [kind_of_event, step, time, place, label] = value;
    archive(kind_of_event, step, time, place.x(), place.y(), place.z(), label);
}

template <class Number, class Rows>
void append_flat(std::vector<Number>& numbers, const Rows& rows) {
    for (const auto& row : rows) numbers.insert(numbers.end(), row.begin(), row.end());
}

template <class Number, class Rows>
std::vector<Number> flat(const Rows& rows) {
    std::vector<Number> numbers;
    numbers.reserve(rows.empty() ? 0 : rows.size() * static_cast<std::size_t>(rows.front().size()));
    append_flat(numbers, rows);
    return numbers;
}

template <class Row, class Number>
std::vector<Row> rows(std::span<const Number> numbers) {
    const auto width = static_cast<std::size_t>(Row().size());
    std::vector<Row> result(numbers.size() / width);
    for (std::size_t i = 0; i < result.size(); ++i)
        std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(i * width), width, result[i].begin());
    return result;
}

template <class Row, class Number>
std::vector<Row> rows(const std::vector<Number>& numbers) {
    return rows<Row>(std::span<const Number>(numbers));
}

void add_state(motion::CheckpointWriter& out, const RunState& state) {
    out.add("step", static_cast<std::int32_t>(state.step));
    out.add("seconds", state.seconds);
    out.add_array<double>("positions", flat<double>(state.tets.vertices));
    out.add_array<std::uint32_t>("tetrahedra", flat<std::uint32_t>(state.tets.tets));
    out.add_array<std::int32_t>("labels", state.tets.labels);
    out.add_array<double>("edge lengths", state.edge_lengths);
    out.add_array<std::uint32_t>("first numbers", state.unchanged.numbers);
    out.add_array<std::uint32_t>("first triangles", flat<std::uint32_t>(state.unchanged.first));
}

RunState taken_state(motion::CheckpointReader& in) {
    RunState state;
    state.step = in.value<std::int32_t>("step");
    state.seconds = in.number("seconds");
    state.tets.vertices = rows<Point3>(in.array<double>("positions"));
    state.tets.tets = rows<std::array<std::uint32_t, 4>>(in.array<std::uint32_t>("tetrahedra"));
    state.tets.labels = in.array<std::int32_t>("labels");
    const std::size_t vertices = state.tets.vertices.size();
    state.edge_lengths = in.array<double>("edge lengths", vertices);
    state.unchanged.numbers = in.array<std::uint32_t>("first numbers", vertices);
    state.unchanged.first = rows<UnchangedTriangles::Key>(in.array<std::uint32_t>("first triangles"));
    return state;
}

void add_history(motion::CheckpointWriter& out, int step, const FlowResult& result) {
    HistoryWriter history;
    std::vector<StepRecord> records = result.steps;
    std::vector<EventOf<3>> events = result.events;
    std::erase_if(records, [&](const StepRecord& record) { return record.step > step; });
    std::erase_if(events, [&](const EventOf<3>& event) { return event.step > step; });
    list_fields(history, records);
    list_fields(history, events);
    const Point3 low = result.domain.min(), high = result.domain.max();
    out.add_array<double>("domain", std::array{low.x(), low.y(), low.z(), high.x(), high.y(), high.z()});
    out.add("edge length", result.edge_length);
    out.add_array<std::int64_t>("history integers", history.integers);
    out.add_array<double>("history reals", history.reals);
    out.add_text("history text", history.text);
}

void take_history(motion::CheckpointReader& in, FlowResult& result) {
    const std::vector<double> d = in.array<double>("domain", 6);
    result.domain = {Point3(d[0], d[1], d[2]), Point3(d[3], d[4], d[5])};
    result.edge_length = in.number("edge length");
    const auto integers = in.array<std::int64_t>("history integers");
    const auto reals = in.array<double>("history reals");
    const std::string text = in.text("history text");
    HistoryReader history{integers, reals, text};
    list_fields(history, result.steps);
    list_fields(history, result.events);
}

void add_frames(motion::CheckpointWriter& out, int step, const Snapshots& snapshots) {
    std::vector<std::int32_t> steps, labels;
    std::vector<std::uint64_t> vertex_counts, triangle_counts;
    std::vector<std::uint32_t> triangles;
    std::vector<double> times, positions;
    for (const Snapshots::Frame& frame : snapshots.frames()) {
        if (frame.step > step) break;
        steps.push_back(frame.step);
        times.push_back(frame.time);
        vertex_counts.push_back(frame.interface.surface.vertices.size());
        triangle_counts.push_back(frame.interface.surface.triangles.size());
        append_flat(positions, frame.interface.surface.vertices);
        append_flat(triangles, frame.interface.surface.triangles);
        append_flat(labels, frame.interface.sides);
    }
    out.add_array<std::int32_t>("frame steps", steps);
    out.add_array<double>("frame times", times);
    out.add_array<std::uint64_t>("frame vertices", vertex_counts);
    out.add_array<std::uint64_t>("frame triangles", triangle_counts);
    out.add_array<double>("frame positions", positions);
    out.add_array<std::uint32_t>("frame corners", triangles);
    out.add_array<std::int32_t>("frame labels", labels);
}

std::vector<Snapshots::Frame> taken_frames(motion::CheckpointReader& in) {
    const auto steps = in.array<std::int32_t>("frame steps");
    const auto times = in.array<double>("frame times", steps.size());
    const auto vertex_counts = in.array<std::uint64_t>("frame vertices", steps.size());
    const auto triangle_counts = in.array<std::uint64_t>("frame triangles", steps.size());
    const auto positions = in.array<double>("frame positions");
    const auto triangles = in.array<std::uint32_t>("frame corners");
    const auto labels = in.array<std::int32_t>("frame labels");
    std::vector<Snapshots::Frame> frames;
    std::size_t vertex = 0, triangle = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const std::size_t n = vertex_counts[i], m = triangle_counts[i];
        Snapshots::Frame& frame = frames.emplace_back(Snapshots::Frame{steps[i], times[i], {}});
        frame.interface.surface.vertices = rows<Point3>(std::span(positions).subspan(3 * vertex, 3 * n));
        frame.interface.surface.triangles =
            rows<std::array<std::uint32_t, 3>>(std::span(triangles).subspan(3 * triangle, 3 * m));
        frame.interface.sides = rows<std::array<int, 2>>(std::span(labels).subspan(2 * triangle, 2 * m));
        vertex += n;
        triangle += m;
    }
    return frames;
}

}  // namespace

std::filesystem::path checkpoint_path(const std::filesystem::path& folder) { return folder / "checkpoint"; }

void write_checkpoint(const std::filesystem::path& path, const io::Json& options, const RunState& state,
                      const FlowResult& result, const Snapshots& snapshots) {
    motion::CheckpointWriter out(kind, version);
    out.add_text("program", core::version());
    out.add_text("options", options.dump());
    add_state(out, state);
    add_history(out, state.step, result);
    add_frames(out, state.step, snapshots);
    std::ostringstream bytes;
    out.write(bytes);
    io::write_file(path, bytes.view());
}

SavedRun read_checkpoint(const std::filesystem::path& path) {
    const std::string source = path.string();
    if (!std::filesystem::exists(path))
        throw core::InputError(source, "", "there is no checkpoint", "start the run anew, without --resume");
    std::istringstream bytes(io::read_file(path));
    motion::CheckpointReader in(bytes, source, kind, version);
    if (const std::string program = in.text("program"); program != core::version())
        throw core::InputError(source, "", "was written by version " + program + " of the program",
                               "go on with that one, or start anew: this one would not make the same steps");
    SavedRun run;
    run.options = io::Json::parse(in.text("options"), source);
    run.state = taken_state(in);
    take_history(in, run.result);
    run.result.seconds = run.state.seconds;
    run.frames = taken_frames(in);
    in.require_end();
    return run;
}

Checkpoints::Checkpoints(std::filesystem::path path, io::Json options, int interval)
    : path_(std::move(path)), options_(std::move(options)), interval_(interval) {
    DSC_ASSERT(interval > 0);
}

void Checkpoints::restore(RunState state) {
    state_ = std::move(state);
    is_saved_ = true;
    since_saved_.emplace();
}

bool Checkpoints::is_due(int step) const { return step % interval_ == 0 && !(state_ && state_->step == step); }

void Checkpoints::take(RunState state, const FlowResult& result, const Snapshots& snapshots) {
    state_ = std::move(state);
    is_saved_ = false;
    if (!since_saved_ || since_saved_->seconds() > least_pause * seconds_to_save_) save(result, snapshots);
}

void Checkpoints::save(const FlowResult& result, const Snapshots& snapshots) {
    if (is_saved_ || !state_) return;
    const core::Stopwatch watch;
    write_checkpoint(path_, options_, *state_, result, snapshots);
    seconds_to_save_ = watch.seconds();
    is_saved_ = true;
    since_saved_.emplace();
}

}  // namespace dsc::flow
