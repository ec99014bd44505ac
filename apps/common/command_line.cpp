// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/common/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iterator>

#include "core/errors.h"
#include "core/version.h"
#include "io/atomic_file.h"
#include "io/number.h"

namespace dsc::apps {

namespace fs = std::filesystem;

namespace {

std::string range_text(const NumberRange& range) {
    std::string text;
    const auto add = [&](const char* sign, const std::optional<double>& limit) {
        if (limit) text += (text.empty() ? "" : " and ") + std::string(sign) + " " + io::number_text(*limit);
    };
    add(">", range.above);
    add(">=", range.at_least);
    add("<", range.below);
    add("<=", range.at_most);
    return text;
}

bool is_within(double value, const NumberRange& range) {
    return !(range.above && value <= *range.above) && !(range.at_least && value < *range.at_least) &&
           !(range.below && value >= *range.below) && !(range.at_most && value > *range.at_most);
}

[[noreturn]] void reject(const std::string& option, const std::string& text, const std::string& expected) {
    throw core::UsageError(option + ": \"" + text + "\" is not " + expected);
}

double parsed_number(const std::string& option, const std::string& text, const NumberRange& range) {
    const std::optional<double> value = io::parse_finite(text);
    if (!value) reject(option, text, "a finite number");
    if (!is_within(*value, range)) reject(option, text, "a number " + range_text(range));
    return *value;
}

template <class Integer>
Integer parsed_integer(const std::string& option, const std::string& text, const NumberRange& range) {
    Integer value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size()) reject(option, text, "an integer");
    if (!is_within(static_cast<double>(value), range)) reject(option, text, "an integer " + range_text(range));
    return value;
}

// "--lambda" of "-l,--lambda".
std::string long_name(const std::string& names) { return names.substr(names.rfind(',') + 1); }

// Absolute and without links, to see whether two paths are the same; as it is where that fails.
fs::path plain_path(const std::string& path) {
    std::error_code error;
    const fs::path plain = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? fs::path(path) : plain;
}

std::string with_range(const std::string& help, const NumberRange& range) {
    const std::string limits = range_text(range);
    return limits.empty() ? help : help + " (" + limits + ")";
}

}  // namespace

struct CommandLine::Implementation {
    explicit Implementation(const std::string& program, const std::string& description)
        : name(program), app(description, program) {}

    struct Alternatives {
        std::vector<std::string> names;
        bool is_required;
    };
    struct Output {
        std::string option;
        const std::optional<std::string>* path;
        bool is_folder;
    };
    struct Input {
        std::string option, path;
    };

    // Registers an option that takes one text, which `take` converts and stores.
    CLI::Option* add(const std::string& names, const std::string& help, const std::string& type,
                     std::function<void(const std::string& option, const std::string& text)> take) {
        const std::string option = long_name(names);
        const auto receive = [option, take = std::move(take)](const CLI::results_t& results) {
            if (results.size() > 1) throw core::UsageError(option + " is given twice");
            take(option, results.front());
            return true;
        };
        CLI::Option* added = app.add_option(names, receive, help);
        added->type_name(type)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
        added->group(heading);
        return added;
    }

    void add_choice(const std::string& names, const std::string& help, const std::vector<std::string>& choices,
                    std::function<void(const std::string&)> take) {
        std::string list;
        for (const std::string& choice : choices) list += (list.empty() ? "" : "|") + choice;
        add(names, help, list, [choices, list, take](const std::string& option, const std::string& text) {
            if (std::ranges::find(choices, text) == choices.end()) reject(option, text, "one of " + list);
            take(text);
        });
    }

    void add_path(const std::string& names, std::optional<std::string>& value, const std::string& help,
                  const std::string& type) {
        add(names, help, type, [&value](const std::string& option, const std::string& text) {
            if (text.empty()) reject(option, text, "a path");
            value = text;
        });
    }

    CLI::Option* add_input(const std::string& names, const std::string& help,
                           std::function<void(const std::string&)> take) {
        return add(names, help, "FILE",
                   [this, take = std::move(take)](const std::string& option, const std::string& text) {
                       if (text.empty()) reject(option, text, "a path");
                       inputs.push_back({option, text});
                       take(text);
                   });
    }

    void check_alternatives() const;
    void judge_output_kind();
    void check_inputs_are_kept() const;
    void check_outputs() const;

    std::string name;
    CLI::App app;
    std::string heading = "Options";
    CommonOptions common;
    std::string folder_option;
    bool may_replace_input = false;
    std::vector<Alternatives> alternatives;
    std::vector<Input> inputs;  ///< those that are given
    std::vector<Output> outputs;
};

CommandLine::CommandLine(const std::string& program, const std::string& description, const std::string& example,
                         const CommonHelp& common)
    : implementation_(std::make_unique<Implementation>(program, description)) {
    CLI::App& app = implementation_->app;
    CommonOptions& options = implementation_->common;
    app.set_version_flag("--version", program + " " + core::version(), "print the version");
    app.set_help_flag("-h,--help", "print this help");
    app.footer("Example:\n  " + example +
               "\n\nExit code: 0 done; 1 ran but failed or was stopped; 2 usage or bad input.");
    heading("Common options");
    implementation_->folder_option = common.folder_option;
    implementation_->may_replace_input = common.may_replace_input;
    if (common.has_output) {
        if (common.output_is_folder) {
            output_folder("-o,--output", options.output, common.output);
        } else {
            output_file("-o,--output", options.output, common.output);
        }
    }
    output_file("--json", options.json, "write a report with all figures to this file");
    implementation_->add("--seed", "seed of everything random (default 1)", "N",
                         [&options](const std::string& option, const std::string& text) {
                             options.seed = parsed_integer<std::int64_t>(option, text, {.at_least = 0});
                         });
    integer("--threads", options.threads, "threads to use at most, 0 for all; the result doesn't depend on it",
            {.at_least = 0, .at_most = 4096});
    flag("--quiet", options.quiet, "print nothing but results and errors");
    implementation_->add_choice("--progress", "progress line on stderr, auto: on a terminal", {"auto", "none", "bar"},
                                [&options](const std::string& mode) {
                                    options.progress = mode == "bar"    ? ProgressMode::bar
                                                       : mode == "none" ? ProgressMode::none
                                                                        : ProgressMode::automatic;
                                });
    heading("Options");
}

CommandLine::~CommandLine() = default;

void CommandLine::heading(const std::string& text) { implementation_->heading = text; }

void CommandLine::flag(const std::string& names, bool& value, const std::string& help) {
    implementation_->app.add_flag(names, value, help)->group(implementation_->heading);
}

void CommandLine::number(const std::string& names, double& value, const std::string& help, const NumberRange& range) {
    const std::string text = with_range(help, range) + ", default " + io::number_text(value);
    implementation_->add(names, text, "X", [&value, range](const std::string& option, const std::string& given) {
        value = parsed_number(option, given, range);
    });
}

void CommandLine::number(const std::string& names, std::optional<double>& value, const std::string& help,
                         const NumberRange& range) {
    implementation_->add(names, with_range(help, range), "X",
                         [&value, range](const std::string& option, const std::string& given) {
                             value = parsed_number(option, given, range);
                         });
}

void CommandLine::integer(const std::string& names, int& value, const std::string& help, const NumberRange& range) {
    const std::string text = with_range(help, range) + ", default " + std::to_string(value);
    implementation_->add(names, text, "N", [&value, range](const std::string& option, const std::string& given) {
        value = parsed_integer<int>(option, given, range);
    });
}

void CommandLine::pair(const std::string& names, std::optional<std::array<double, 2>>& value, const std::string& help,
                       const NumberRange& range) {
    implementation_->add(names, with_range(help, range), "X,Y",
                         [&value, range](const std::string& option, const std::string& given) {
                             const std::size_t comma = given.find(',');
                             if (comma == std::string::npos) reject(option, given, "two numbers separated by a comma");
                             value = {parsed_number(option, given.substr(0, comma), range),
                                      parsed_number(option, given.substr(comma + 1), range)};
                         });
}

void CommandLine::text(const std::string& names, std::optional<std::string>& value, const std::string& help) {
    implementation_->add(names, help, "TEXT",
                         [&value](const std::string&, const std::string& given) { value = given; });
}

void CommandLine::choice(const std::string& names, std::string& value, const std::vector<std::string>& choices,
                         const std::string& help) {
    implementation_->add_choice(names, help + ", default " + value, choices,
                                [&value](const std::string& c) { value = c; });
}

void CommandLine::choice(const std::string& names, std::optional<std::string>& value,
                         const std::vector<std::string>& choices, const std::string& help) {
    implementation_->add_choice(names, help, choices, [&value](const std::string& c) { value = c; });
}

void CommandLine::input_file(const std::string& names, std::optional<std::string>& value, const std::string& help) {
    implementation_->add_input(names, help, [&value](const std::string& given) { value = given; });
}

void CommandLine::input_file(const std::string& names, std::string& value, const std::string& help) {
    implementation_->add_input(names, help, [&value](const std::string& given) { value = given; })->required();
}

void CommandLine::output_file(const std::string& names, std::optional<std::string>& value, const std::string& help) {
    implementation_->add_path(names, value, help, "FILE");
    implementation_->outputs.push_back({long_name(names), &value, false});
}

void CommandLine::output_folder(const std::string& names, std::optional<std::string>& value, const std::string& help) {
    implementation_->add_path(names, value, help, "DIR");
    implementation_->outputs.push_back({long_name(names), &value, true});
}

void CommandLine::alternatives(const std::vector<std::string>& names, bool is_required) {
    implementation_->alternatives.push_back({names, is_required});
}

void CommandLine::Implementation::check_alternatives() const {
    for (const Alternatives& group : alternatives) {
        std::string list;
        for (const std::string& option : group.names) list += (list.empty() ? "" : ", ") + option;
        const auto is_given = [this](const std::string& option) { return app.count(option) > 0; };
        const auto count = std::ranges::count_if(group.names, is_given);
        if (count > 1) throw core::UsageError("only one of " + list + " can be given");
        if (count == 0 && group.is_required) throw core::UsageError("one of " + list + " has to be given");
    }
}

void CommandLine::Implementation::judge_output_kind() {
    if (folder_option.empty() || app.get_option(folder_option)->count() == 0) return;
    for (Output& output : outputs)
        if (output.path == &common.output) output.is_folder = true;
}

void CommandLine::Implementation::check_inputs_are_kept() const {
    for (const Output& output : outputs) {
        if (!*output.path || output.is_folder || (may_replace_input && output.path == &common.output)) continue;
        for (const Input& input : inputs)
            if (plain_path(**output.path) == plain_path(input.path))
                throw core::UsageError(output.option + " would replace the input \"" + input.path +
                                       "\"; choose another path");
    }
}

void CommandLine::Implementation::check_outputs() const {
    check_inputs_are_kept();
    for (auto first = outputs.begin(); first != outputs.end(); ++first) {
        if (!*first->path) continue;
        for (auto second = std::next(first); second != outputs.end(); ++second) {
            if (*second->path && plain_path(**first->path) == plain_path(**second->path)) {
                throw core::UsageError(first->option + " and " + second->option + " name the same path \"" +
                                       **first->path + "\"");
            }
        }
    }
    for (const Output& output : outputs) {
        if (*output.path && !output.is_folder) io::require_writable(**output.path);
    }
    // Folders last: they are created, which should not happen when something else is wrong.
    for (const Output& output : outputs) {
        if (*output.path && output.is_folder) io::require_writable_folder(**output.path);
    }
}

bool CommandLine::parse(int argc, const char* const* argv) {
    CLI::App& app = implementation_->app;
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::fputs(app.help().c_str(), stdout);
        return false;
    } catch (const CLI::CallForVersion& version) {
        std::puts(version.what());
        return false;
    } catch (const CLI::ParseError& error) {
        throw core::UsageError(std::string(error.what()) + "; see " + implementation_->name + " --help");
    }
    implementation_->check_alternatives();
    implementation_->judge_output_kind();
    implementation_->check_outputs();
    if (implementation_->common.quiet) implementation_->common.progress = ProgressMode::none;
    return true;
}

const CommonOptions& CommandLine::common() const { return implementation_->common; }

bool CommandLine::is_given(const std::string& name) const { return implementation_->app.count(name) > 0; }

io::Json CommandLine::given() const {
    io::Json given = io::Json::object();
    for (const CLI::Option* option : implementation_->app.get_options()) {
        if (option->count() == 0) continue;
        const std::string name = option->get_name();
        if (option->get_expected_max() == 0) {
            given[name] = true;
        } else {
            given[name] = option->results().front();
        }
    }
    return given;
}

}  // namespace dsc::apps
