// SPDX-License-Identifier: GPL-3.0-or-later
// A program that ends in every way a program can, for program_test.cpp.
#include <chrono>
#include <cstdio>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

#include "apps/common/command_line.h"
#include "apps/common/run_main.h"
#include "core/errors.h"
#include "io/atomic_file.h"

namespace {

using namespace dsc;

void end_as(const std::string& how, const core::Observer& observer) {
    if (how == "usage") throw core::UsageError("--x: wrong");
    if (how == "input") throw core::InputError("file.csv", "line 3", "is wrong", "mend it");
    if (how == "run") throw core::RunError("did not converge\nin 10 steps");
    if (how == "memory") throw std::bad_alloc();
    if (how == "internal") throw std::logic_error("surprise");
    if (how == "wait") {
        std::puts("ready");
        std::fflush(stdout);
        for (;;) {
            observer.check_cancelled();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    return apps::run_main("probe", [&] {
        apps::CommandLine line("probe", "Ends as told", "probe --end run");
        std::string how = "done";
        line.choice("--end", how, {"done", "usage", "input", "run", "memory", "internal", "wait"}, "how to end");
        if (!line.parse(argc, argv)) return static_cast<int>(apps::exit_done);
        apps::ProgressObserver observer(line.common().progress);
        observer.progress("working", 0.5, "half");
        end_as(how, observer);
        std::puts("result");
        if (line.common().output) io::write_file(*line.common().output, "result");
        return static_cast<int>(apps::exit_done);
    });
}
