// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/common/checkpoint_file.h"

#include <sstream>

#include "core/errors.h"
#include "core/version.h"
#include "io/atomic_file.h"

namespace dsc::apps {

namespace {

motion::CheckpointReader opened(const std::filesystem::path& path, const CheckpointKind& kind) {
    if (!std::filesystem::exists(path))
        throw core::InputError(path.string(), "", "there is no checkpoint", "start the run anew, without --resume");
    std::istringstream bytes(io::read_file(path));
    return {bytes, path.string(), kind.program, kind.version};
}

}  // namespace

std::filesystem::path checkpoint_path(const std::filesystem::path& folder) { return folder / "checkpoint"; }

void write_checkpoint(const std::filesystem::path& path, const CheckpointKind& kind, const io::Json& options,
                      const motion::FieldWriter& run) {
    motion::CheckpointWriter out(kind.program, kind.version);
    out.add_text("program", core::version());
    out.add_text("options", options.dump());
    run.write(out, "run");
    std::ostringstream bytes;
    out.write(bytes);
    io::write_file(path, bytes.view());
}

CheckpointFile::CheckpointFile(const std::filesystem::path& path, const CheckpointKind& kind)
    : in_(opened(path, kind)) {
    if (const std::string program = in_.text("program"); program != core::version())
        throw core::InputError(path.string(), "", "was written by version " + program + " of the program",
                               "go on with that one, or start anew: this one would not make the same steps");
    options_ = io::Json::parse(in_.text("options"), path.string());
}

motion::FieldReader CheckpointFile::run_fields() {
    motion::FieldReader fields(in_, "run");
    in_.require_end();
    return fields;
}

}  // namespace dsc::apps
