// SPDX-License-Identifier: GPL-3.0-or-later
// What the program improve does when all is well.
#include <algorithm>
#include <set>

#include "apps/improve/mesh_statistics.h"
#include "dsc3d/mesh.h"
#include "tests/apps/improve/box_mesh.h"
#include "tests/apps/improve/program.h"

using namespace dsc;
using namespace dsc::tests;
using geometry::QualityMeasure;
using geometry::TetData;

namespace {

TetData read_mesh(const std::filesystem::path& path) { return io::read_tet_mesh(path).data; }

double worst_quality(const TetData& data, QualityMeasure measure = QualityMeasure::minimum_biased_sine) {
    return improve::mesh_statistics(data, measure).worst_quality;
}

double volume_of_label(const TetData& data, int label) {
    TetData region{.vertices = data.vertices};
    for (std::size_t tet = 0; tet < data.tets.size(); ++tet)
        if (data.label(tet) == label) region.tets.push_back(data.tets[tet]);
    return improve::mesh_statistics(region, QualityMeasure::minimum_sine).volume;
}

using Triangle = std::set<std::array<double, 3>>;

// The boundary as places, whatever the numbers of its vertices are.
std::set<Triangle> boundary(const TetData& data) {
    std::set<Triangle> once;
    for (const auto& tet : data.tets) {
        for (std::size_t opposite = 0; opposite < 4; ++opposite) {
            Triangle face;
            for (std::size_t corner = 0; corner < 4; ++corner) {
                const Eigen::Vector3d& x = data.vertices[tet[corner]];
                if (corner != opposite) face.insert({x.x(), x.y(), x.z()});
            }
            if (!once.insert(face).second) once.erase(face);
        }
    }
    return once;
}

}  // namespace

TEST_CASE("the mesh is better, valid, and as large as before") {
    const TemporaryFolder folder;
    const TetData before = shaken_box(4);
    const std::string input = write_mesh(folder, "in.mesh", before), output = (folder / "out.mesh").string();
    for (const auto& [name, measure] : {std::pair("sine", QualityMeasure::minimum_sine),
                                        {"biased-sine", QualityMeasure::minimum_biased_sine},
                                        {"volume-length", QualityMeasure::volume_length},
                                        {"radius-ratio", QualityMeasure::radius_ratio}}) {
        INFO(name);
        improve_output({input, "-o", output, "--measure", name});
        const TetData after = read_mesh(output);
        CHECK(worst_quality(after, measure) > worst_quality(before, measure));
        CHECK(improve::mesh_statistics(after, measure).volume == Approx(1).epsilon(1e-9));
        CHECK(validate(dsc3d::Mesh(after)).empty());
    }
}

TEST_CASE("what is printed and the JSON report agree with the files") {
    const TemporaryFolder folder;
    const std::string input = write_mesh(folder, "in.mesh", shaken_box(4)), output = (folder / "out.vtu").string();
    const std::string text = improve_output({input, "-o", output, "--json", (folder / "a.json").string()});
    CHECK_THAT(text, Catch::Contains("before") && Catch::Contains("after") && Catch::Contains("converged"));
    CHECK_THAT(text, !Catch::Contains("not written"));
    const io::Json report = read_json(folder / "a.json");
    const auto before = improve::mesh_statistics(read_mesh(input), QualityMeasure::minimum_biased_sine);
    const auto after = improve::mesh_statistics(read_mesh(output), QualityMeasure::minimum_biased_sine);
    CHECK(report["input"].string() == input);
    CHECK(report["output"].string() == output);
    CHECK(report["before"]["min_dihedral"].number() == Approx(before.smallest_angle));
    CHECK(report["before"]["tets"].integer() == 384);
    CHECK(report["after"]["tets"].integer() == static_cast<std::int64_t>(after.tets));
    CHECK(report["after"]["max_dihedral"].number() == Approx(after.largest_angle));
    CHECK(report["after"]["worst_quality"].number() == Approx(after.worst_quality));
    CHECK(report["end"].string() == "converged");
    CHECK(report["operations"]["smoothings"].integer() > 0);
}

TEST_CASE("without -o nothing is written, which is said; --report doesn't even try") {
    const TemporaryFolder folder;
    const std::string input = write_mesh(folder, "in.mesh", shaken_box(3)), text = io::read_file(input);
    CHECK_THAT(improve_output({input}), Catch::Contains("after") && Catch::Contains("not written"));
    const std::string report = improve_output({input, "--report"});
    CHECK_THAT(report, Catch::Contains("tetrahedra") && !Catch::Contains("after") && !Catch::Contains("not written"));
    CHECK(folder.content() == std::vector<std::string>{"in.mesh"});
    CHECK(io::read_file(input) == text);
    const std::string json = (folder / "a.json").string();
    CHECK(improve_output({input, "--report", "--quiet", "--json", json}).empty());
    CHECK(read_json(json)["after"].is_null());
    CHECK(read_json(json)["before"]["tets"].integer() == 162);
}

TEST_CASE("the output may be the input, and every format may go to every other one") {
    const TemporaryFolder folder;
    const std::string input = write_mesh(folder, "a.mesh", shaken_box(3)),
                      other = write_mesh(folder, "b.mesh", shaken_box(3));
    improve_output({input, "-o", input});
    improve_output({other, "-o", (folder / "c.mesh").string()});
    CHECK(io::read_file(input) == io::read_file(folder / "c.mesh"));
    const TetData expected = read_mesh(input);
    for (const std::string extension : {".node", ".ele", ".mesh", ".msh", ".vtu", ".vtk"}) {
        INFO(extension);
        const std::string in = write_mesh(folder, "in" + extension, shaken_box(3));
        const std::string out = (folder / ("out" + extension)).string();
        improve_output({in, "-o", out, "--quiet"});
        CHECK(read_mesh(out).vertices == expected.vertices);
        CHECK(read_mesh(out).tets.size() == expected.tets.size());
    }
}

TEST_CASE("a mirrored mesh is turned") {
    const TemporaryFolder folder;
    TetData data = shaken_box(3);
    const std::string input = write_mesh(folder, "in.mesh", data);
    for (auto& tet : data.tets) std::swap(tet[2], tet[3]);
    const std::string mirrored = write_mesh(folder, "mirrored.mesh", data);
    improve_output({input, "-o", (folder / "a.mesh").string()});
    improve_output({mirrored, "-o", (folder / "b.mesh").string()});
    CHECK(io::read_file(folder / "a.mesh") == io::read_file(folder / "b.mesh"));
}

TEST_CASE("the same input gives the same bits, on one thread and on two") {
    const TemporaryFolder folder;
    const std::string input = write_mesh(folder, "in.mesh", shaken_box(4));
    const auto improved = [&](const Arguments& more) {
        Arguments arguments{input, "-o", (folder / "out.mesh").string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        improve_output(arguments);
        return io::read_file(folder / "out.mesh");
    };
    const std::string once = improved({});
    CHECK(improved({}) == once);
    CHECK(improved({"--threads", "1"}) == once);
    CHECK(improved({"--threads", "2"}) == once);
}

TEST_CASE("regions keep their labels and their interface") {
    const TemporaryFolder folder;
    const std::string input = write_mesh(folder, "in.mesh", two_regions(4)), output = (folder / "out.mesh").string();
    const std::string json = (folder / "a.json").string();
    improve_output({input, "-o", output, "--json", json});
    const TetData after = read_mesh(output);
    CHECK(std::set<int>(after.labels.begin(), after.labels.end()) == std::set<int>{3, 7});
    CHECK(volume_of_label(after, 3) == Approx(0.5).epsilon(1e-9));
    CHECK(volume_of_label(after, 7) == Approx(0.5).epsilon(1e-9));
    CHECK(read_json(json)["after"]["regions"].integer() == 2);
}

TEST_CASE("--merge-regions forgets the labels and frees the interface") {
    const TemporaryFolder folder;
    const std::string input = write_mesh(folder, "in.mesh", two_regions(4)), json = (folder / "r.json").string();
    improve_output({input, "--merge-regions", "--json", json});
    const auto report = read_json(json);
    CHECK(report["before"]["regions"].integer() == 1);
    CHECK(report["after"]["regions"].integer() == 1);
}

TEST_CASE("--keep-vertices keeps them all and --no-boundary every triangle of the boundary") {
    const TemporaryFolder folder;
    const TetData before = shaken_box(4);
    const std::string input = write_mesh(folder, "in.mesh", before), output = (folder / "out.mesh").string();
    improve_output({input, "-o", output, "--keep-vertices"});
    CHECK(read_mesh(output).vertices.size() == before.vertices.size());
    improve_output({input, "-o", output, "--no-boundary"});
    CHECK(boundary(read_mesh(output)) == boundary(before));
}

TEST_CASE("--keep-vertices leaves all vertices their numbers, also when there are some that no tetrahedron uses") {
    const TemporaryFolder folder;
    TetData before = shaken_box(4);
    before.vertices.insert(before.vertices.begin(), {9, 9, 9});
    before.vertices.push_back({8, 8, 8});
    for (auto& tet : before.tets)
        for (std::uint32_t& v : tet) ++v;
    const std::string input = write_mesh(folder, "in.mesh", before), output = (folder / "out.mesh").string();
    improve_output({input, "-o", output, "--keep-vertices", "--no-boundary"});
    const TetData after = read_mesh(output);
    REQUIRE(after.vertices.size() == before.vertices.size());
    CHECK(after.vertices.front() == before.vertices.front());
    CHECK(after.vertices.back() == before.vertices.back());
    CHECK(boundary(after) == boundary(before));
}

TEST_CASE("a pass that is left out does nothing") {
    const TemporaryFolder folder;
    const std::string input = write_mesh(folder, "in.mesh", shaken_box(4)), json = (folder / "a.json").string();
    improve_output({input, "--json", json, "--no-mfrt", "--no-thinning"});
    CHECK(read_json(json)["operations"]["multi_face_retriangulations"].integer() == 0);
    CHECK(read_json(json)["operations"]["collapses"].integer() == 0);
    CHECK_FALSE(read_json(json)["parameters"]["mfrt"].boolean());
}

TEST_CASE("the pictures are written") {
    const TemporaryFolder folder;
    const std::string input = write_mesh(folder, "in.mesh", shaken_box(3));
    improve_output({input, "--svg", (folder / "a.svg").string(), "--html", (folder / "a.html").string()});
    CHECK_THAT(io::read_file(folder / "a.svg"), Catch::Contains("<svg") && Catch::Contains("after: "));
    CHECK_THAT(io::read_file(folder / "a.html"), Catch::Contains("<html"));
}
