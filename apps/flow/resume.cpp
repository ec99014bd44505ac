// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/resume.h"

#include <optional>

#include "apps/common/resumed_arguments.h"
#include "core/assert.h"

namespace dsc::flow {

Options resumed_options(const io::Json& at_start, const Options& resuming) {
    const apps::ResumedArguments arguments("flow", at_start, resuming.given);
    std::optional<Options> options = parse_options(arguments.argc(), arguments.argv());
    DSC_ASSERT(options);
    options->given = at_start;
    options->is_resumed = true;
    return *options;
}

}  // namespace dsc::flow
