// SPDX-License-Identifier: GPL-3.0-or-later
// The folder that a flow writes to: what has to be asked before, and the files that do not depend on the dimension.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "apps/flow/options.h"
#include "apps/flow/result.h"
#include "io/html_view.h"
#include "io/json.h"

namespace dsc::flow {

/// Throws core::UsageError when a result would overwrite `input`: the natural name for going on from it would be lost.
void require_other_files(const std::string& input, const std::filesystem::path& folder);

/// Removes a checkpoint of an earlier run, which --resume would take for one of this run.
void remove_checkpoint(const std::filesystem::path& folder);

/// Removes what a run that was killed was about to put in place of its files.
void remove_unfinished_files(const std::filesystem::path& folder);

/// Writes report.json, and index.html when there are snapshots. `page` makes the page, with the title given.
void write_reports(const Options& options, const io::Json& report,
                   const std::function<io::HtmlPage(const std::string& title)>& page);

/// Throws core::RunError when the flow was cancelled or stopped. `has_checkpoint`: it can go on.
void require_end(FlowEnd end, const std::string& reason, const std::string& folder, bool has_checkpoint);

}  // namespace dsc::flow
