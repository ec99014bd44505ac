// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/fluid/checkpoint.h"

#include <array>
#include <span>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

#include "core/assert.h"
#include "core/errors.h"
#include "core/version.h"
#include "io/atomic_file.h"
#include "motion/checkpoint.h"

namespace dsc::fluid_app {

namespace {

constexpr const char* kind = "fluid";
constexpr std::uint32_t version = 1;

// Numbers of records, events and frames in one row each, by the same list of fields for writing and reading.
struct Writer {
    std::vector<double> numbers;
    std::string text;

    void operator()(auto&... values) { (add(values), ...); }

private:
    void add(const std::string& value) {
        numbers.push_back(static_cast<double>(value.size()));
        text += value;
    }
    void add(const Point3& value) { numbers.insert(numbers.end(), value.begin(), value.end()); }
    template <class Number>
    requires std::is_arithmetic_v<Number>
    void add(Number value) { numbers.push_back(static_cast<double>(value)); }
    template <class First, class Second>
    void add(const std::pair<First, Second>& value) {
        add(value.first);
        add(value.second);
    }
    template <class Value, std::size_t Size>
    void add(const std::array<Value, Size>& values) {
        for (const Value& value : values) add(value);
    }
    template <class Value>
    void add(const std::vector<Value>& values) {
        numbers.push_back(static_cast<double>(values.size()));
        for (const Value& value : values) add(value);
    }
};

// Precondition: what a Writer with the same fields has written.
struct Reader {
    std::span<const double> numbers;
    std::string_view text;

    void operator()(auto&... values) { (take(values), ...); }

private:
    double next() {
        DSC_ASSERT(!numbers.empty());
        const double value = numbers.front();
        numbers = numbers.subspan(1);
        return value;
    }
    void take(std::string& value) {
        const auto size = static_cast<std::size_t>(next());
        value = text.substr(0, size);
        text.remove_prefix(size);
    }
    void take(Point3& value) {
        for (int k = 0; k < 3; ++k) value[k] = next();
    }
    template <class Number>
    requires std::is_arithmetic_v<Number>
    void take(Number& value) { value = static_cast<Number>(next()); }
    template <class First, class Second>
    void take(std::pair<First, Second>& value) {
        take(value.first);
        take(value.second);
    }
    template <class Value, std::size_t Size>
    void take(std::array<Value, Size>& values) {
        for (Value& value : values) take(value);
    }
    template <class Value>
    void take(std::vector<Value>& values) {
        values.resize(static_cast<std::size_t>(next()));
        for (Value& value : values) take(value);
    }
};

template <class Archive>
void fields(Archive& archive, TrackedState& state) {
    auto& [tets, velocities, pressures, parts, kept_volumes, edge_lengths] = state;
    archive(tets.vertices, tets.tets, tets.labels, velocities, pressures, parts, kept_volumes, edge_lengths);
}

// By structured bindings, so that a field that is added can't be forgotten here.
template <class Archive>
void fields(Archive& archive, StepRecord& record) {
    auto& [step, time, dt, vertices, cells, tets, surface_faces, volumes, kept_volumes, centre, momentum,
           angular_momentum, kinetic_energy, surface_energy, potential_energy, max_speed, max_divergence,
           solver_iterations, transferred, unfinished, min_dihedral, milliseconds] = record;
    archive(step, time, dt, vertices, cells, tets, surface_faces, volumes, kept_volumes, centre, momentum,
            angular_momentum, kinetic_energy, surface_energy, potential_energy, max_speed, max_divergence,
            solver_iterations, transferred, unfinished, min_dihedral, milliseconds);
}

template <class Archive>
void fields(Archive& archive, Event& event) {
    auto& [kind_of_event, step, time, place] = event;
    archive(kind_of_event, step, time, place);
}

template <class Archive>
void fields(Archive& archive, Frame& frame) {
    auto& [time, surface, velocities, pressures] = frame;
    archive(time, surface.vertices, surface.triangles, velocities, pressures);
}

template <class Value>
void add_list(motion::CheckpointWriter& out, const std::string& name, const std::vector<Value>& values) {
    Writer writer;
    for (Value value : values) fields(writer, value);
    out.add(name + " count", static_cast<std::uint64_t>(values.size()));
    out.add_array<double>(name, writer.numbers);
    out.add_text(name + " text", writer.text);
}

template <class Value>
std::vector<Value> taken_list(motion::CheckpointReader& in, const std::string& name) {
    std::vector<Value> values(in.value<std::uint64_t>(name + " count"));
    const std::vector<double> numbers = in.array<double>(name);
    const std::string text = in.text(name + " text");
    Reader reader{numbers, text};
    for (Value& value : values) fields(reader, value);
    return values;
}

}  // namespace

std::filesystem::path checkpoint_path(const std::filesystem::path& folder) { return folder / "checkpoint"; }

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
    run.edge_length = in.number("edge length");
    run.state.step = in.value<std::int32_t>("step");
    run.state.time = in.number("time");
    run.state.seconds = in.number("seconds");
    run.state.fluid = taken_list<TrackedState>(in, "fluid").at(0);
    run.steps = taken_list<StepRecord>(in, "records");
    run.events = taken_list<Event>(in, "events");
    run.frames = taken_list<Frame>(in, "frames");
    in.require_end();
    return run;
}

Checkpoints::Checkpoints(std::filesystem::path path, io::Json options, double edge_length, int interval)
    : path_(std::move(path)), options_(std::move(options)), edge_length_(edge_length), interval_(interval) {
    DSC_ASSERT(interval > 0);
}

void Checkpoints::take(RunState state, const std::vector<StepRecord>& steps, const std::vector<Event>& events,
                       const std::vector<Frame>& frames) {
    state_ = std::move(state);
    motion::CheckpointWriter out(kind, version);
    out.add_text("program", core::version());
    out.add_text("options", options_.dump());
    out.add("edge length", edge_length_);
    out.add("step", static_cast<std::int32_t>(state_->step));
    out.add("time", state_->time);
    out.add("seconds", state_->seconds);
    add_list(out, "fluid", std::vector<TrackedState>{state_->fluid});
    add_list(out, "records", steps);
    add_list(out, "events", events);
    add_list(out, "frames", frames);
    std::ostringstream bytes;
    out.write(bytes);
    io::write_file(path_, bytes.view());
}

}  // namespace dsc::fluid_app
