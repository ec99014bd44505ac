// SPDX-License-Identifier: GPL-3.0-or-later
// Every bad input is refused with exit code 2 and one line that says what is wrong and where; nothing is overwritten.
#include "tests/apps/improve/box_mesh.h"
#include "tests/apps/improve/program.h"

using namespace dsc;
using namespace dsc::tests;
using geometry::TetData;

namespace {

// Two tetrahedra on the two sides of the face 1 2 3.
TetData pair_of_tets() {
    return {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, .tets = {{0, 1, 2, 3}, {4, 1, 3, 2}}};
}

// A folder with an output of an earlier run, which every refused run has to leave alone.
class Refusals {
public:
    Refusals() { io::write_file(out_, "old"); }

    void check(const std::string& input, const std::vector<std::string>& words) {
        check_refused({input, "-o", out_}, words);
        check_refused({input, "--report"}, words);
        CHECK(io::read_file(out_) == "old");
    }
    void check_text(const std::string& name, const std::string& text, std::vector<std::string> words) {
        io::write_file(folder_ / name, text);
        words.push_back(name);
        check((folder_ / name).string(), words);
    }
    void check_mesh(const TetData& data, std::vector<std::string> words) {
        words.push_back("bad.mesh");
        check(write_mesh(folder_, "bad.mesh", data), words);
    }
    const TemporaryFolder& folder() const { return folder_; }

private:
    TemporaryFolder folder_;
    std::string out_ = (folder_ / "out.mesh").string();
};

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    REQUIRE(at != std::string::npos);
    return text.replace(at, what.size(), with);
}

std::string medit_text(const TetData& data) {
    const TemporaryFolder folder;
    return io::read_file(write_mesh(folder, "a.mesh", data));
}

}  // namespace

TEST_CASE("a file that can't be read is refused by name") {
    Refusals refusals;
    refusals.check((refusals.folder() / "absent.mesh").string(), {"absent.mesh"});
    refusals.check((refusals.folder() / "absent.node").string(), {"absent"});
    refusals.check(refusals.folder().path().string() + "/", {});
    refusals.check_text("mesh.stl", "solid", {".stl"});
    refusals.check_text("mesh.MESHES", "MeshVersionFormatted 2", {});
    refusals.check_text("empty.mesh", "", {});
    refusals.check_text("garbage.mesh", std::string("\0\xff\x80 MeshVersion", 15), {});
    refusals.check_text("garbage.vtu", "<VTKFile", {});
    refusals.check_text("garbage.vtk", "not VTK\n", {});
    refusals.check_text("garbage.msh", "$Nothing\n", {});
    io::write_file(refusals.folder() / "lonely.node", "1 3 0 0\n0 0 0 0\n");
    refusals.check((refusals.folder() / "lonely.node").string(), {"lonely.ele"});
}

TEST_CASE("a truncated file is refused in every format") {
    Refusals refusals;
    const TetData data = shaken_box(3);
    for (const std::string extension : {".mesh", ".msh", ".vtu", ".vtk", ".node", ".ele"}) {
        write_mesh(refusals.folder(), "whole.node", data);  // the companion of a truncated .node or .ele
        const std::string path = write_mesh(refusals.folder(), "whole" + extension, data);
        const std::string text = io::read_file(path);
        for (const double part : {0.2, 0.5, 0.9}) {
            INFO(extension << " " << part);
            io::write_file(path, text.substr(0, static_cast<std::size_t>(part * static_cast<double>(text.size()))));
            refusals.check(path, {"whole"});
        }
    }
}

TEST_CASE("wrong indices and numbers are refused with their place") {
    Refusals refusals;
    const std::string text = medit_text(pair_of_tets());
    const std::string last = "5 2 4 3";
    refusals.check_text("range.mesh", replaced(text, last, "6 2 4 3"), {"line", "6"});
    refusals.check_text("zero.mesh", replaced(text, last, "0 2 4 3"), {"line"});
    refusals.check_text("negative.mesh", replaced(text, last, "-1 2 4 3"), {"line", "-1"});
    refusals.check_text("twice.mesh", replaced(text, last, "5 2 4 2"), {"line"});
    refusals.check_text("word.mesh", replaced(text, last, "5 2 four 3"), {"line", "four"});
    refusals.check_text("nan.mesh", replaced(text, "1 1 1", "1 nan 1"), {"line"});
    refusals.check_text("infinite.mesh", replaced(text, "1 1 1", "1 1 inf"), {"line"});
    refusals.check_text("huge.mesh", replaced(text, "Vertices\n5", "Vertices\n5000000000000"), {"line"});
}

TEST_CASE("an inverted or flat tetrahedron is refused by its number") {
    Refusals refusals;
    TetData data = box_mesh(2);
    std::swap(data.tets[17][0], data.tets[17][1]);
    refusals.check_mesh(data, {"tetrahedron 17", "inverted"});
    data = box_mesh(2);
    data.vertices.push_back((data.vertices[0] + data.vertices[1]) / 2);
    data.tets.push_back({0, 1, static_cast<std::uint32_t>(data.vertices.size() - 1), 4});
    refusals.check_mesh(data, {"tetrahedron 48", "flat"});
}

TEST_CASE("what is no manifold is refused") {
    Refusals refusals;
    SECTION("a face of three tetrahedra") {
        TetData data = pair_of_tets();
        data.vertices.emplace_back(2, 1, 1);
        data.tets.push_back({5, 1, 3, 2});
        refusals.check_mesh(data, {"tetrahedron 2", "face 1 2 3"});
    }
    SECTION("two tetrahedra on the same side of a face") {
        TetData data = pair_of_tets();
        data.vertices.emplace_back(0.1, 0, 0);
        data.tets[1] = {5, 1, 2, 3};
        refusals.check_mesh(data, {"tetrahedron 1", "face 1 2 3"});
    }
    SECTION("the same tetrahedron twice") {
        TetData data = pair_of_tets();
        data.tets.push_back(data.tets.front());
        refusals.check_mesh(data, {"tetrahedron 2", "face"});
    }
    SECTION("two tetrahedra that share an edge only") {
        refusals.check_mesh({.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                             .tets = {{0, 2, 3, 1}, {0, 4, 5, 1}}},
                            {"edge 0 1"});
    }
    SECTION("two tetrahedra that share a vertex only") {
        refusals.check_mesh(
            {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
             .tets = {{0, 1, 2, 3}, {0, 5, 4, 6}}},
            {"vertex 0"});
    }
    SECTION("no tetrahedra") { refusals.check_mesh({.vertices = {{0, 0, 0}}}, {"no tetrahedra"}); }
}

TEST_CASE("values out of their range are refused with the option") {
    const TemporaryFolder folder;
    const std::string input = write_mesh(folder, "a.mesh", pair_of_tets());
    check_refused({}, {"IN"});
    check_refused({input, input}, {});
    const std::vector<std::array<std::string, 2>> wrong{{"--measure", "cosine"},
                                                        {"--schedule", "worst"},
                                                        {"--feature-angle", "0"},
                                                        {"--feature-angle", "181"},
                                                        {"--feature-angle", "nan"},
                                                        {"--max-boundary-change", "-1"},
                                                        {"--max-boundary-change", "1"},
                                                        {"--max-boundary-change", "inf"},
                                                        {"--target-angle", "0"},
                                                        {"--target-angle", "71"},
                                                        {"--target-angle", "x"},
                                                        {"--time-limit", "0"},
                                                        {"--time-limit", "-3"},
                                                        {"--time-limit", "nan"},
                                                        {"--seed", "-1"},
                                                        {"--threads", "-1"}};
    for (const auto& [option, value] : wrong) check_refused({input, option, value}, {option});
    check_refused({input, "--report", "-o", (folder / "b.mesh").string()}, {"--report", "-o"});
    CHECK(folder.content() == std::vector<std::string>{"a.mesh"});
}

TEST_CASE("an output that can't be written is refused before anything is done") {
    const TemporaryFolder folder;
    const std::string input = write_mesh(folder, "a.mesh", pair_of_tets()), old = (folder / "old.json").string();
    io::write_file(old, "old");
    check_refused({input, "-o", (folder / "b.stl").string(), "--json", old}, {"b.stl"});
    check_refused({input, "-o", "/no/such/folder/b.mesh", "--json", old}, {"/no/such/folder/b.mesh"});
    check_refused({input, "-o", folder.path().string(), "--json", old}, {});
    check_refused({input, "-o", old, "--json", old}, {"--json"});
    for (const char* option : {"--json", "--svg", "--html"})
        check_refused({input, "-o", (folder / "b.mesh").string(), option, "/no/such/folder/x"}, {"/no/such/folder/x"});
    CHECK(io::read_file(old) == "old");
    CHECK(folder.content() == std::vector<std::string>{"a.mesh", "old.json"});
}

TEST_CASE("an input that is its own output stays as it was when it is refused") {
    const TemporaryFolder folder;
    const std::string path = (folder / "a.mesh").string(),
                      text = replaced(medit_text(pair_of_tets()), "1 1 1", "1 1 nan");
    io::write_file(path, text);
    check_refused({path, "-o", path}, {"a.mesh"});
    CHECK(io::read_file(path) == text);
}
