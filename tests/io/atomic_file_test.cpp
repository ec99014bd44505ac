// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/atomic_file.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "core/errors.h"
#include "tests/support/temporary_folder.h"

using namespace dsc::io;
using dsc::tests::TemporaryFolder;
using Names = std::vector<std::string>;

TEST_CASE("a file appears when it is committed, and nothing is left when it is not") {
    const TemporaryFolder folder;
    {
        AtomicFile file(folder / "a");
        file.write("half");
        CHECK_FALSE(std::filesystem::exists(folder / "a"));
    }
    CHECK(folder.content().empty());
    write_file(folder / "a", "whole");
    CHECK(read_file(folder / "a") == "whole");
    CHECK(folder.content() == Names{"a"});
}

TEST_CASE("the old file stays until the new one is committed") {
    const TemporaryFolder folder;
    write_file(folder / "a", "old");
    ::chmod((folder / "a").c_str(), 0640);
    {
        AtomicFile file(folder / "a");
        file.write(std::string(200000, 'x'));  // more than the buffer holds
        CHECK(read_file(folder / "a") == "old");
    }
    CHECK(read_file(folder / "a") == "old");
    write_file(folder / "a", "new");
    CHECK(read_file(folder / "a") == "new");
    struct stat status {};
    ::stat((folder / "a").c_str(), &status);
    CHECK((status.st_mode & 07777) == 0640);
    CHECK(folder.content() == Names{"a"});
}

TEST_CASE("a symbolic link stays a link and its target is replaced, also when it does not exist yet") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "data");
    std::filesystem::create_symlink("data/real", folder / "link");
    write_file(folder / "link", "one");
    write_file(folder / "link", "two");
    CHECK(std::filesystem::is_symlink(folder / "link"));
    CHECK(read_file(folder / "data/real") == "two");

    std::filesystem::create_symlink("loop", folder / "loop");
    CHECK_THROWS_AS(write_file(folder / "loop", "x"), dsc::core::InputError);
}

TEST_CASE("a device is written to and stays a device") {
    write_file("/dev/null", "gone");
    CHECK(std::filesystem::is_character_file("/dev/null"));
    CHECK_THROWS_AS(write_file("/dev/full", "does not fit"), dsc::core::RunError);
}

TEST_CASE("what can't be written is named, with a cure, before anything happens") {
    const TemporaryFolder folder;
    write_file(folder / "file", "");
    for (const auto& path :
         {folder / "no/such/folder", folder / "file/below", folder.path(), std::filesystem::path()}) {
        INFO(path);
        CHECK_THROWS_AS(require_writable(path), dsc::core::InputError);
        CHECK_THROWS_AS(AtomicFile(path), dsc::core::InputError);
    }
    CHECK_THROWS_WITH(require_writable(folder / "no/file"), Catch::Contains("no/file") && Catch::Contains("; "));
    CHECK_THROWS_AS(read_file(folder / "absent"), dsc::core::InputError);
    CHECK_THROWS_AS(read_file(folder.path()), dsc::core::InputError);
    require_writable(folder / "file");
    require_writable(folder / "other");
    CHECK(folder.content() == Names{"file"});
}

TEST_CASE("a folder for output is created, but not its parents") {
    const TemporaryFolder folder;
    require_writable_folder(folder / "new");
    require_writable_folder(folder / "new");
    CHECK(folder.content() == Names{"new"});
    CHECK(std::filesystem::is_empty(folder / "new"));
    CHECK_THROWS_AS(require_writable_folder(folder / "a/b"), dsc::core::InputError);
}

TEST_CASE("a finished file appears only when it is committed") {
    const TemporaryFolder folder;
    write_file(folder / "a", "old");
    {
        AtomicFile file(folder / "a");
        file.write("new");
        file.finish();
        CHECK(read_file(folder / "a") == "old");
    }
    CHECK(read_file(folder / "a") == "old");
    AtomicFile file(folder / "a");
    file.write("new");
    file.finish();
    file.commit();
    CHECK(read_file(folder / "a") == "new");
    CHECK(folder.content() == Names{"a"});
}

TEST_CASE("small and large texts stay in their order") {
    const TemporaryFolder folder;
    std::string all;
    AtomicFile file(folder / "a");
    for (const std::size_t size : {1, 70000, 3, 65535, 65536, 200000, 2}) {
        const std::string text(size, static_cast<char>('a' + all.size() % 26));
        file.write(text);
        all += text;
    }
    file.commit();
    CHECK(read_file(folder / "a") == all);
}
