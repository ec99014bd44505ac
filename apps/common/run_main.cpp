// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/common/run_main.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "apps/common/interrupt.h"
#include "core/errors.h"

namespace dsc::apps {

namespace {

int report(const std::string& name, std::string message, ExitCode code) {
    std::ranges::replace(message, '\n', ' ');
    std::fprintf(stderr, "%s: %s\n", name.c_str(), message.c_str());
    return code;
}

int result_of(const std::string& name, const std::function<int()>& program) {
    try {
        return program();
    } catch (const core::UsageError& error) {
        return report(name, error.what(), exit_usage);
    } catch (const core::InputError& error) {
        return report(name, error.what(), exit_usage);
    } catch (const core::Error& error) {
        return report(name, error.what(), exit_failed);
    } catch (const std::bad_alloc&) {
        return report(name, "out of memory", exit_failed);
    } catch (const std::exception& error) {
        return report(name, std::string("internal error: ") + error.what(), exit_failed);
    }
}

}  // namespace

int run_main(const std::string& name, const std::function<int()>& program) {
    catch_interrupts();
    const int code = result_of(name, program);
    std::cout.flush();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout) {
        return report(name, "writing to stdout failed; check the disk or the pipe", exit_failed);
    }
    return code;
}

}  // namespace dsc::apps
