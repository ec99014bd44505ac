// SPDX-License-Identifier: GPL-3.0-or-later
// The file in the folder of a run from which the run goes on: the command line it was started with, and the run as
// fields (motion/checkpoint_fields.h). Guarantee: it is replaced whole or not at all; one that is damaged, or of
// another program or version, is refused. Cost: linear.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "io/json.h"
#include "motion/checkpoint_fields.h"

namespace dsc::apps {

struct CheckpointKind {
    const char* program;
    std::uint32_t version;  ///< of what is written
};

std::filesystem::path checkpoint_path(const std::filesystem::path& folder);

/// Throws core::RunError when the file can't be written.
void write_checkpoint(const std::filesystem::path& path, const CheckpointKind& kind, const io::Json& options,
                      const motion::FieldWriter& run);

class CheckpointFile {
public:
    /// Throws core::InputError when there is no checkpoint, or it can't be read by this program.
    CheckpointFile(const std::filesystem::path& path, const CheckpointKind& kind);

    /// On the command line that the run was started with.
    const io::Json& options() const { return options_; }

    /// The run, to be asked for once. Throws core::InputError when it has other fields.
    template <class Run>
    Run run() {
        motion::FieldReader fields = run_fields();
        Run run;
        fields(run);
        fields.require_end();
        return run;
    }

private:
    motion::FieldReader run_fields();

    motion::CheckpointReader in_;
    io::Json options_;
};

}  // namespace dsc::apps
