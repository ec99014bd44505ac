// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/output.h"

#include <system_error>
#include <vector>

#include "apps/common/checkpoint_file.h"
#include "core/errors.h"
#include "io/atomic_file.h"

namespace dsc::flow {

namespace {

// The last name of the path, also of one that ends in a slash or is a dot.
std::string name_of_folder(const std::filesystem::path& folder) {
    std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
    if (path.filename().empty()) path = path.parent_path();
    return path.filename().string();
}

// What an earlier run has left and this one does not replace would be taken for its own.
void remove_earlier_series(const std::filesystem::path& folder) {
    for (const char* name : {"series.pvd", "index.html"}) {
        std::error_code absent;
        std::filesystem::remove(folder / name, absent);
    }
}

}  // namespace

void require_other_files(const std::string& input, const std::filesystem::path& folder) {
    for (const char* name : {"final.obj", "final.mesh"}) {
        std::error_code absent;
        if (std::filesystem::equivalent(input, folder / name, absent))
            throw core::UsageError(input + " would be overwritten by the result; choose another folder for -o");
    }
}

void remove_checkpoint(const std::filesystem::path& folder) {
    std::error_code absent;
    std::filesystem::remove(apps::checkpoint_path(folder), absent);
}

void remove_unfinished_files(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".part")) continue;
        for (const char* stem : {".checkpoint.", ".series", ".final.", ".report.json.", ".index.html.", ".probe."})
            if (name.starts_with(stem)) found.push_back(entry.path());
    }
    for (const std::filesystem::path& path : found) std::filesystem::remove(path);
}

void write_reports(const Options& options, const io::Json& report,
                   const std::function<io::HtmlPage(const std::string& title)>& page) {
    const std::filesystem::path folder = options.folder;
    const std::string text = report.dump(1) + "\n";
    io::write_file(folder / "report.json", text);
    if (options.common.json) io::write_file(*options.common.json, text);
    if (options.snapshots > 0) {
        io::write_html_page(folder / "index.html", page(name_of_folder(folder)));
    } else {
        remove_earlier_series(folder);
    }
}

void require_end(FlowEnd end, const std::string& reason, const std::string& folder, bool has_checkpoint) {
    if (end != FlowEnd::cancelled && end != FlowEnd::stopped) return;
    const bool can_go_on = end == FlowEnd::cancelled && has_checkpoint;
    throw core::RunError(reason + "; " + folder + " has the state before" +
                         (can_go_on ? "; flow --resume -o " + folder + " goes on" : ""));
}

}  // namespace dsc::flow
