// SPDX-License-Identifier: GPL-3.0-or-later
// The exceptions of the toolkit. Libraries throw them, programs print what() as one line and map them to an exit code:
// UsageError and InputError to 2, RunError and Cancelled to 1.
#pragma once

#include <stdexcept>
#include <string>

namespace dsc::core {

/// Base of everything the toolkit throws on purpose.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A command line or parameter that can't be: names the option or field and what would be valid.
class UsageError : public Error {
public:
    using Error::Error;
};

/// Input that can't be used: what() reads "SOURCE: PLACE: PROBLEM; CURE" (an empty place or cure is left out).
class InputError : public Error {
public:
    InputError(std::string source, std::string place, std::string problem, std::string cure);

    const std::string& source() const { return source_; }
    const std::string& place() const { return place_; }

private:
    std::string source_;
    std::string place_;
};

/// The computation ran and could not reach what was asked for.
class RunError : public Error {
public:
    using Error::Error;
};

/// The observer asked to stop.
class Cancelled : public Error {
public:
    Cancelled() : Error("cancelled") {}
};

}  // namespace dsc::core
