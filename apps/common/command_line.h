// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of a program: its options with their checks, and the flags all programs share.
// Guarantee: parse() either fills every variable or throws core::UsageError or core::InputError naming the option; a
// number is always finite and in its range; no output has the path of another or of an input, and each can be written
// to (no file is touched yet, a missing output folder is created).
//
//     apps::CommandLine line("cutlocus", "Cut locus of a point", "cutlocus --torus elliptic --lambda 2 -o locus.csv");
//     double lambda = 1;
//     line.number("--lambda", lambda, "height of the section, in radii", {.above = 0});
//     if (!line.parse(argc, argv)) return apps::exit_done;  // --help or --version was printed
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/common/progress.h"
#include "io/json.h"

namespace dsc::apps {

/// The flags every program has.
struct CommonOptions {
    std::optional<std::string> output;                ///< -o
    std::optional<std::string> json;                  ///< --json
    std::int64_t seed = 1;                            ///< --seed
    int threads = 0;                                  ///< --threads, 0: all
    bool quiet = false;                               ///< --quiet
    ProgressMode progress = ProgressMode::automatic;  ///< --progress; none with --quiet
};

/// Limits of a number; absent ones don't bind.
struct NumberRange {
    std::optional<double> above = {};     ///< value > above
    std::optional<double> at_least = {};  ///< value >= at_least
    std::optional<double> below = {};     ///< value < below
    std::optional<double> at_most = {};   ///< value <= at_most
};

struct CommonHelp {
    std::string output = "write the result to this file";  ///< what -o means here
    bool has_output = true;
    bool output_is_folder = false;
    std::string folder_option = {};  ///< an option ("--points") with which -o is a folder instead of a file
    bool may_replace_input = false;  ///< -o may name an input: the result is a better version of it
};

class CommandLine {
public:
    /// `example` is shown by --help.
    CommandLine(const std::string& program, const std::string& description, const std::string& example,
                const CommonHelp& common = {});
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// Options that follow are shown under this heading.
    void heading(const std::string& text);

    void flag(const std::string& names, bool& value, const std::string& help);
    void number(const std::string& names, double& value, const std::string& help, const NumberRange& range = {});
    void number(const std::string& names, std::optional<double>& value, const std::string& help,
                const NumberRange& range = {});
    void integer(const std::string& names, int& value, const std::string& help, const NumberRange& range = {});
    /// Two numbers separated by a comma: "--point u,v".
    void pair(const std::string& names, std::optional<std::array<double, 2>>& value, const std::string& help,
              const NumberRange& range = {});
    void text(const std::string& names, std::optional<std::string>& value, const std::string& help);
    /// One of `choices`.
    void choice(const std::string& names, std::string& value, const std::vector<std::string>& choices,
                const std::string& help);
    void choice(const std::string& names, std::optional<std::string>& value, const std::vector<std::string>& choices,
                const std::string& help);
    void input_file(const std::string& names, std::optional<std::string>& value, const std::string& help);
    /// One that has to be given; a name without dashes ("IN") is a positional argument.
    void input_file(const std::string& names, std::string& value, const std::string& help);
    void output_file(const std::string& names, std::optional<std::string>& value, const std::string& help);
    void output_folder(const std::string& names, std::optional<std::string>& value, const std::string& help);
    /// At most one of these options may be given, or exactly one when `is_required`.
    void alternatives(const std::vector<std::string>& names, bool is_required);

    /// False when --help or --version was asked for and printed.
    bool parse(int argc, const char* const* argv);

    const CommonOptions& common() const;
    /// True when the option stood on the command line.
    bool is_given(const std::string& name) const;
    /// The options that stood on the command line with their texts, for the report.
    io::Json given() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace dsc::apps
