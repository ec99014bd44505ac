// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace dsc::tests {

namespace {

std::array<int, 2> make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    return ends;
}

// Appends what there is to read; false at the end.
bool read_some(int descriptor, std::string& text) {
    char block[4096];
    const ssize_t count = ::read(descriptor, block, sizeof block);
    if (count > 0) text.append(block, static_cast<std::size_t>(count));
    return count > 0;
}

pid_t start(const std::string& program, const std::vector<std::string>& arguments, int out, int err) {
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        ::dup2(out, STDOUT_FILENO);
        ::dup2(err, STDERR_FILENO);
        ::execv(program.c_str(), argv.data());
        ::_exit(127);
    }
    return child;
}

int exit_code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

int ProgramResult::err_lines() const { return static_cast<int>(std::ranges::count(err, '\n')); }

ProgramResult run_program(const std::string& program, const std::vector<std::string>& arguments,
                          const std::string& interrupt_at) {
    const auto out = make_pipe();
    const auto err = make_pipe();
    const pid_t child = start(program, arguments, out[1], err[1]);
    ::close(out[1]);
    ::close(err[1]);

    ProgramResult result;
    bool is_interrupted = interrupt_at.empty();
    std::array<pollfd, 2> sources{pollfd{out[0], POLLIN, 0}, pollfd{err[0], POLLIN, 0}};
    while (sources[0].fd >= 0 || sources[1].fd >= 0) {
        ::poll(sources.data(), sources.size(), -1);
        if (sources[0].revents != 0 && !read_some(out[0], result.out)) sources[0].fd = -1;
        if (sources[1].revents != 0 && !read_some(err[0], result.err)) sources[1].fd = -1;
        if (!is_interrupted && result.out.find(interrupt_at) != std::string::npos) {
            ::kill(child, SIGINT);
            is_interrupted = true;
        }
    }
    ::close(out[0]);
    ::close(err[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    result.exit_code = exit_code_of(status);
    return result;
}

int run_program_killed(const std::string& program, const std::vector<std::string>& arguments,
                       const std::function<bool()>& is_time) {
    const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    const pid_t child = start(program, arguments, nowhere, nowhere);
    ::close(nowhere);
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        if (is_time()) {
            ::kill(child, SIGKILL);
            ::waitpid(child, &status, 0);
            break;
        }
        ::poll(nullptr, 0, 1);
    }
    return exit_code_of(status);
}

}  // namespace dsc::tests
