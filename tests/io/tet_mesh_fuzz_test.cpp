// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged files: each gives a valid result or core::InputError with one line, never anything else.
#include <catch2/catch.hpp>
#include <cctype>
#include <functional>
#include <vector>

#include "tests/io/tet/support.h"
#include "tests/support/seed.h"

using namespace dsc;
using namespace dsc::tests;
using core::Random;

namespace {

using Mutation = std::function<void(std::string& text, Random& random)>;

std::size_t any_place(const std::string& text, Random& random) { return random.below(text.size()); }

// The line around a place, with its end.
std::pair<std::size_t, std::size_t> any_line(const std::string& text, Random& random) {
    const std::size_t place = any_place(text, random);
    const std::size_t before = place == 0 ? text.npos : text.rfind('\n', place - 1);
    const std::size_t begin = before == text.npos ? 0 : before + 1;
    return {begin, std::min(text.find('\n', place), text.size() - 1) + 1 - begin};
}

// A number, which may be within a word; empty when there is none behind the place that is tried.
std::pair<std::size_t, std::size_t> any_number(const std::string& text, Random& random) {
    const auto is_digit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(text[i])) != 0; };
    std::size_t begin = any_place(text, random);
    while (begin < text.size() && !is_digit(begin)) ++begin;
    std::size_t end = begin;
    while (end < text.size() && is_digit(end)) ++end;
    return {begin, end - begin};
}

const std::vector<Mutation> mutations = {
    [](std::string& text, Random& random) {  // bytes flipped
        for (std::uint64_t k = 1 + random.below(4); k > 0; --k) {
            text[any_place(text, random)] ^= static_cast<char>(1 << random.below(8));
        }
    },
    [](std::string& text, Random& random) { text.resize(any_place(text, random)); },
    [](std::string& text, Random& random) {  // a line deleted
        const auto [begin, size] = any_line(text, random);
        text.erase(begin, size);
    },
    [](std::string& text, Random& random) {  // a line doubled
        const auto [begin, size] = any_line(text, random);
        text.insert(begin, text.substr(begin, size));
    },
    [](std::string& text, Random& random) {  // a number put in the place of another
        const auto [from, from_size] = any_number(text, random);
        const std::string number = text.substr(std::min(from, text.size()), from_size);
        const auto [to, to_size] = any_number(text, random);
        if (to < text.size()) text.replace(to, to_size, number);
    },
    [](std::string& text, Random& random) {  // a number out of all bounds
        static const char* const numbers[] = {
            "-1",  "0",   "4294967295", "4294967296", "99999999", "9223372036854775807",
            "1e9", "nan", "1e999",      "-0",         "0.5",      "18446744073709551615"};
        const auto [begin, size] = any_number(text, random);
        if (begin < text.size()) text.replace(begin, size, numbers[random.below(std::size(numbers))]);
    },
    [](std::string& text, Random& random) {  // a number in the first lines, where the counts are
        std::string head = text.substr(0, 200);
        const auto [begin, size] = any_number(head, random);
        if (begin < head.size())
            text.replace(begin, size, std::to_string(random.below(2) == 0 ? ~0U : random.below(99)));
    },
    [](std::string& text, Random& random) {  // a binary word out of all bounds
        for (std::size_t place = any_place(text, random), k = 0; k < 8 && place < text.size(); ++k)
            text[place++] = '\xff';
    },
};

std::string binary_legacy_vtk(const geometry::TetData& data) {
    std::string text = "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
                       std::to_string(data.vertices.size()) + " double\n";
    const auto append = [&](const auto& value) {
        const std::string image(reinterpret_cast<const char*>(&value), sizeof value);
        text.append(image.rbegin(), image.rend());
    };
    for (const Eigen::Vector3d& p : data.vertices) {
        for (const double x : p) append(x);
    }
    const std::string count = std::to_string(data.tets.size());
    text += "\nCELLS " + count + " " + std::to_string(5 * data.tets.size()) + "\n";
    for (const auto& tet : data.tets) {
        append(4);
        for (const std::uint32_t v : tet) append(v);
    }
    text += "\nCELL_TYPES " + count + "\n";
    for (std::size_t i = 0; i < data.tets.size(); ++i) append(10);
    text += "\nCELL_DATA " + count + "\nFIELD f 1\nlabel 1 " + count + " int\n";
    for (const int label : data.labels) append(label);
    return text;
}

void check_valid(const geometry::TetData& data) {
    CHECK_FALSE(data.tets.empty());
    CHECK((data.labels.empty() || data.labels.size() == data.tets.size()));
    CHECK(std::ranges::all_of(data.vertices, [](const Eigen::Vector3d& p) { return p.allFinite(); }));
    CHECK(std::ranges::all_of(data.tets, [&](std::array<std::uint32_t, 4> tet) {
        std::ranges::sort(tet);
        return std::ranges::adjacent_find(tet) == tet.end() && tet[3] < data.vertices.size();
    }));
}

}  // namespace

TEST_CASE("a damaged file gives a valid mesh or an error of one line") {
    Random random(seed(61));
    const TemporaryFolder folder;
    const geometry::TetData data = random_mesh(random, 2);
    io::write_tet_mesh(folder / "m.node", data, {.first_index = 1});
    io::write_tet_mesh(folder / "m.mesh", data);
    io::write_tet_mesh(folder / "old.msh", data, {.gmsh = io::GmshVersion::v2_2});
    io::write_tet_mesh(folder / "new.msh", data);
    io::write_tet_mesh(folder / "m.vtu", data);
    io::write_tet_mesh(folder / "m.vtk", data);
    io::write_file(folder / "binary.vtk", binary_legacy_vtk(data));
    int errors = 0;
    int results = 0;
    for (const char* name : {"m.node", "m.ele", "m.mesh", "old.msh", "new.msh", "m.vtu", "m.vtk", "binary.vtk"}) {
        const std::string whole = io::read_file(folder / name);
        CHECK(io::read_tet_mesh(folder / name).data.tets.size() == data.tets.size());
        for (std::size_t i = 0; i < 5 * mutations.size(); ++i) {
            CAPTURE(name, i);
            std::string text = whole;
            mutations[i % mutations.size()](text, random);
            io::write_file(folder / name, text);
            try {
                check_valid(io::read_tet_mesh(folder / name).data);
                ++results;
            } catch (const core::InputError& error) {
                const std::string message = error.what();
                CHECK(message.find('\n') == message.npos);
                CHECK(message.starts_with((folder.path() / "").string()));
                ++errors;
            }
        }
        io::write_file(folder / name, whole);
    }
    CHECK(errors > 100);
    CHECK(results > 10);
}
