// SPDX-License-Identifier: GPL-3.0-or-later
// A file that appears whole or not at all: written aside in the same folder and renamed on commit().
// Guarantee: until commit() returns, what was at the path before is untouched; without commit() nothing is left behind.
// A symbolic link stays a link, its target is replaced; an existing file keeps its permissions; a device or pipe
// (/dev/stdout) is written to directly. Throws core::InputError when the path can't be written to, core::RunError when
// writing fails later (disk full).
//
//     io::AtomicFile file("locus.csv");
//     file.write("u,v\n");
//     file.commit();
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace dsc::io {

class AtomicFile {
public:
    explicit AtomicFile(const std::filesystem::path& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view text);
    /// Hands everything to the system, so that commit() has only to rename; nothing can be written afterwards. For
    /// files that belong together: finish all, then commit all.
    void finish();
    /// Makes the file visible at its path; nothing can be written afterwards.
    void commit();

    const std::filesystem::path& path() const { return path_; }

private:
    void flush();
    void hand_over(std::string_view text);
    [[noreturn]] void fail(const char* what);

    std::filesystem::path path_;    // as given, for messages
    std::filesystem::path target_;  // with symbolic links followed
    std::filesystem::path aside_;   // empty when writing directly
    std::string buffer_;
    int descriptor_ = -1;
};

/// Writes a whole file, atomically.
void write_file(const std::filesystem::path& path, std::string_view text);

/// The whole content of a file; throws core::InputError when it can't be read.
std::string read_file(const std::filesystem::path& path);

/// Throws core::InputError unless a file can be written at `path`; leaves everything as it was. To be called before a
/// long computation whose result goes there.
void require_writable(const std::filesystem::path& path);

/// The same for a folder in which files are to be written; creates the folder (its parent has to exist).
void require_writable_folder(const std::filesystem::path& folder);

}  // namespace dsc::io
