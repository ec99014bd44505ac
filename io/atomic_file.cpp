// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <utility>

#include "core/errors.h"

namespace dsc::io {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t buffer_size = 1 << 16;
constexpr int max_links = 40;

const char* cure_of(int error) {
    switch (error) {
        case ENOENT: return "create the folder first or choose another path";
        case ENOTDIR: return "a part of the path is a file; choose another path";
        case EACCES:
        case EPERM:
        case EROFS: return "choose a place you may write to";
        case EISDIR: return "it is a folder; name a file";
        case ENOSPC:
        case EDQUOT: return "free some space or choose another disk";
        case ENAMETOOLONG: return "choose a shorter name";
        default: return "choose another path";
    }
}

[[noreturn]] void reject(const fs::path& path, int error) {
    throw core::InputError(path.string(), "", std::string("can't be written: ") + std::strerror(error), cure_of(error));
}

// Follows symbolic links, also one whose target does not exist yet (std::filesystem::canonical would refuse that).
fs::path follow_links(const fs::path& path) {
    fs::path target = path;
    for (int i = 0; i < max_links; ++i) {
        std::error_code error;
        if (!fs::is_symlink(target, error)) return target;
        const fs::path next = fs::read_symlink(target, error);
        if (error) reject(path, error.value());
        target = next.is_absolute() ? next : target.parent_path() / next;
    }
    reject(path, ELOOP);
}

// A name beside the target that no other thread or process uses.
fs::path name_aside(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    std::ostringstream name;
    name << '.' << target.filename().string().substr(0, 200) << '.' << ::getpid() << '-' << counter++ << ".part";
    return target.parent_path() / name.str();
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path) : path_(path), target_(follow_links(path)) {
    if (path.empty()) throw core::InputError("output", "", "the path is empty", "name a file");
    if (!target_.has_filename()) reject(path_, EISDIR);
    struct stat status {};
    const bool exists = ::stat(target_.c_str(), &status) == 0;
    if (!exists && errno != ENOENT) reject(path_, errno);
    if (exists && S_ISDIR(status.st_mode)) reject(path_, EISDIR);
    // A file that is write-protected stays as it is, although renaming over it would succeed.
    if (exists && ::access(target_.c_str(), W_OK) != 0) reject(path_, errno);

    if (exists && !S_ISREG(status.st_mode)) {
        descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    } else {
        aside_ = name_aside(target_);
        descriptor_ = ::open(aside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
    if (descriptor_ < 0) {
        aside_.clear();
        reject(path_, errno);
    }
    if (exists && !aside_.empty()) static_cast<void>(::fchmod(descriptor_, status.st_mode & 07777));
    buffer_.reserve(buffer_size);
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!aside_.empty()) ::unlink(aside_.c_str());
}

void AtomicFile::write(std::string_view text) {
    if (buffer_.size() + text.size() >= buffer_size) flush();
    if (text.size() >= buffer_size) {
        hand_over(text);
    } else {
        buffer_.append(text);
    }
}

void AtomicFile::flush() {
    hand_over(buffer_);
    buffer_.clear();
}

void AtomicFile::hand_over(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor_, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("writing failed");
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void AtomicFile::finish() {
    if (descriptor_ < 0) return;
    flush();
    if (::close(std::exchange(descriptor_, -1)) != 0) fail("closing failed");
}

void AtomicFile::commit() {
    finish();
    if (aside_.empty()) return;
    if (std::rename(aside_.c_str(), target_.c_str()) != 0) fail("renaming the finished file failed");
    aside_.clear();
}

void AtomicFile::fail(const char* what) {
    const int error = errno;
    throw core::RunError(path_.string() + ": " + what + ": " + std::strerror(error) + "; " + cure_of(error));
}

void write_file(const fs::path& path, std::string_view text) {
    AtomicFile file(path);
    file.write(text);
    file.commit();
}

std::string read_file(const fs::path& path) {
    const auto reject_reading = [&](int error) {
        throw core::InputError(path.string(), "", std::string("can't be read: ") + std::strerror(error),
                               error == EISDIR ? "name a file" : "check the path");
    };
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) reject_reading(errno);
    std::string text;
    // Growing step by step would need up to three times the memory of a large file.
    struct stat status {};
    if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) {
        text.reserve(static_cast<std::size_t>(status.st_size));
    }
    char block[buffer_size];
    ssize_t count = 0;
    while ((count = ::read(descriptor, block, sizeof block)) != 0) {
        if (count > 0) text.append(block, static_cast<std::size_t>(count));
        if (count < 0 && errno != EINTR) break;
    }
    const int error = errno;
    ::close(descriptor);
    if (count < 0) reject_reading(error);
    return text;
}

void require_writable(const fs::path& path) { const AtomicFile probe(path); }

void require_writable_folder(const fs::path& folder) {
    if (folder.empty()) throw core::InputError("output", "", "the path is empty", "name a folder");
    std::error_code error;
    fs::create_directory(folder, error);
    if (error) reject(folder, error.value());
    require_writable(folder / "probe");
}

}  // namespace dsc::io
