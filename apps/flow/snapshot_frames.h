// SPDX-License-Identifier: GPL-3.0-or-later
// The interface at chosen times as a series for ParaView, written as it grows, and as frames that are kept for the
// page. The same in space and in the plane: `Drawing` says what is kept of an interface. Guarantee: the first and the
// last state are among them; the rest is evenly spaced over the steps. Cost: linear in the mesh for each of them.
//
//     struct Drawing {
//         using Mesh, Interface;
//         static Interface interface(const Mesh&);
//         static io::PolyData poly_data(const Interface&);
//     };
#pragma once

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "apps/flow/snapshot_times.h"
#include "core/fields.h"
#include "io/vtp.h"

namespace dsc::flow {

template <class Interface>
struct SnapshotFrame {
    int step = 0;
    double time = 0;
    Interface interface;
};

template <class Visitor, class Frame>
requires core::ConstOrNot<Frame, SnapshotFrame<decltype(Frame::interface)>>
void fields(Visitor& visitor, Frame& frame) {
    auto& [step, time, interface] = frame;
    visitor(step, time, interface);
}

template <class Drawing>
class SnapshotFrames {
public:
    using Mesh = typename Drawing::Mesh;
    using Frame = SnapshotFrame<typename Drawing::Interface>;

    /// Writes to FOLDER/series.pvd when `count` is positive.
    SnapshotFrames(const std::filesystem::path& folder, int steps, int count) : times_to_keep_(steps, count) {
        if (count > 0) files_.emplace(folder, "series");
    }

    /// Keeps the state if its time has come; precondition: steps in ascending order.
    void add(const Mesh& mesh, int step, double time) {
        if (times_to_keep_.take(step)) keep({step, time, Drawing::interface(mesh)});
    }
    /// Keeps it in any case: the last state of a run that ended early.
    void add_last(const Mesh& mesh, int step, double time) {
        if (times_to_keep_.take_last(step)) keep({step, time, Drawing::interface(mesh)});
    }
    /// What an earlier part of the run has kept, in its order: its files are written again.
    void restore(Frame frame) {
        if (times_to_keep_.take_last(frame.step)) keep(std::move(frame));
    }

    const std::vector<Frame>& frames() const { return frames_; }

private:
    void keep(Frame frame) {
        files_->add(frame.time, Drawing::poly_data(frame.interface));
        frames_.push_back(std::move(frame));
    }

    SnapshotTimes times_to_keep_;
    std::optional<io::PvdSeries> files_;
    std::vector<Frame> frames_;
};

}  // namespace dsc::flow
