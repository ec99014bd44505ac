// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/tetgen.h"

#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "core/errors.h"

extern char** environ;

namespace dsc::dsc3d {

namespace {

namespace fs = std::filesystem;

class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "dsc_tetgen_XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw core::RunError("TetGen: no temporary folder can be made in " + fs::temp_directory_path().string() +
                                 ": " + std::strerror(errno));
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string file(const char* name) const { return (path_ / name).string(); }

private:
    fs::path path_;
};

void write(const std::string& path, const std::string& text) {
    std::ofstream file(path);
    file << text;
    if (!file.flush()) throw core::RunError("TetGen: can't write to " + path + "; is the disk full?");
}

std::string node_text(const std::vector<Point3>& points) {
    std::string text = std::to_string(points.size()) + " 3 0 0\n";
    char line[128];
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point3& p = points[i];
        std::snprintf(line, sizeof line, "%zu %.17g %.17g %.17g\n", i, p.x(), p.y(), p.z());
        text += line;
    }
    return text;
}

template <class Indices>
std::string polygon_text(const Indices& indices) {
    std::string text = std::to_string(indices.size());
    for (const std::uint32_t i : indices) text += ' ' + std::to_string(i);
    return text + '\n';
}

std::string poly_text(const TetGenInput& input) {
    std::string text = node_text(input.points);
    text += std::to_string(input.triangles.size() + input.facets.size()) + " 0\n";
    for (const auto& triangle : input.triangles) text += "1\n" + polygon_text(triangle);
    for (const PlaneFacet& facet : input.facets) {
        text += std::to_string(1 + facet.points.size()) + '\n' + polygon_text(facet.outline);
        for (const std::uint32_t point : facet.points) text += polygon_text(std::array{point});
    }
    return text + "0\n0\n";
}

std::string last_line(const std::string& path) {
    std::ifstream file(path);
    std::string line, last;
    while (std::getline(file, line))
        if (line.find_first_not_of(" \t") != std::string::npos) last = line;
    return last;
}

// Looks every few milliseconds, so that a run can be stopped by its observer alone.
int wait_for(pid_t process, core::Observer& observer) {
    int status = 0;
    while (::waitpid(process, &status, WNOHANG) == 0) {
        if (observer.is_cancelled()) {
            ::kill(process, SIGKILL);
            ::waitpid(process, &status, 0);
            throw core::Cancelled();
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return status;
}

void run(const std::string& program, std::vector<std::string> arguments, const std::string& log,
         core::Observer& observer) {
    arguments.insert(arguments.begin(), program);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    pid_t process = 0;
    const int problem = ::posix_spawnp(&process, program.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (problem != 0)
        throw core::RunError("the program " + program + " can't be run (" + std::strerror(problem) +
                             "); it makes tetrahedra between surfaces: install the package tetgen");
    const int status = wait_for(process, observer);
    if (WIFSIGNALED(status))
        throw core::RunError("the program " + program + " was ended by signal " + std::to_string(WTERMSIG(status)) +
                             " (" + ::strsignal(WTERMSIG(status)) + ")");
    if (WEXITSTATUS(status) != 0)
        throw core::RunError("the program " + program + " failed with exit code " +
                             std::to_string(WEXITSTATUS(status)) + ": " + last_line(log));
}

// The next line that holds data.
std::istringstream next_line(std::istream& file, const std::string& path) {
    std::string line;
    while (std::getline(file, line)) {
        line.erase(std::min(line.find('#'), line.size()));
        if (line.find_first_not_of(" \t\r") != std::string::npos) return std::istringstream(line);
    }
    throw core::RunError("TetGen: " + path + " ends too early");
}

template <class Use>
void read_rows(const std::string& path, Use&& use) {
    std::ifstream file(path);
    std::size_t count = 0;
    next_line(file, path) >> count;
    for (std::size_t i = 0; i < count; ++i) {
        std::istringstream row = next_line(file, path);
        std::size_t number = 0;
        row >> number;
        if (!use(i, row) || row.fail() || number != i) throw core::RunError("TetGen: " + path + " can't be understood");
    }
}

geometry::TetData read(const std::string& node, const std::string& ele, const TetGenInput& input) {
    geometry::TetData data;
    data.vertices = input.points;
    read_rows(node, [&](std::size_t i, std::istringstream& row) {
        Point3 p;
        row >> p.x() >> p.y() >> p.z();
        if (i >= data.vertices.size()) data.vertices.push_back(p);
        return true;
    });
    read_rows(ele, [&](std::size_t, std::istringstream& row) {
        std::array<std::uint32_t, 4> t = {};
        row >> t[0] >> t[1] >> t[2] >> t[3];
        data.tets.push_back(t);
        return *std::ranges::max_element(t) < data.vertices.size();
    });
    // Versions differ in the orientation, which is the same for all tetrahedra.
    for (auto& t : data.tets) {
        if (!geometry::is_positive(data.vertices[t[0]], data.vertices[t[1]], data.vertices[t[2]], data.vertices[t[3]]))
            std::swap(t[2], t[3]);
    }
    return data;
}

}  // namespace

geometry::TetData tetgen(const TetGenInput& input, const std::string& program, core::Observer& observer) {
    const TemporaryFolder folder;
    write(folder.file("in.poly"), poly_text(input));
    write(folder.file("in.a.node"), node_text(input.free_points));
    // Boundary kept (Y), coplanar facets not joined (M), points inserted (i), no file of faces (F).
    run(program, {"-pYMiFQ", folder.file("in.poly")}, folder.file("log"), observer);
    return read(folder.file("in.1.node"), folder.file("in.1.ele"), input);
}

}  // namespace dsc::dsc3d
