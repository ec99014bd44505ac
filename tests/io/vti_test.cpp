// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vti.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>

#include "core/errors.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using Catch::Contains;

namespace {

const std::string grid = "WholeExtent=\"1 2 0 2 0 0\" Origin=\"-0.5 0 7\" Spacing=\"0.5 0.25 1\"";
const std::vector<double> ramp = {0, 1, 2, 3, 4, 5.5};

io::ImageData read_image(const std::string& text) {
    const tests::TemporaryFolder folder;
    std::ofstream(folder / "image.vti", std::ios::binary) << text;
    return io::read_vti(folder / "image.vti");
}

std::string document(const std::string& arrays, const std::string& head = grid, const std::string& tail = "",
                     const std::string& options = "header_type=\"UInt64\"") {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" " +
           options + ">\n<ImageData " + head + ">\n<Piece Extent=\"1 2 0 2 0 0\">\n<PointData>\n" + arrays +
           "</PointData>\n</Piece>\n</ImageData>\n" + tail + "</VTKFile>\n";
}

std::string array(const std::string& name, int components, const std::string& numbers) {
    return "<DataArray type=\"Float64\" Name=\"" + name + "\" NumberOfComponents=\"" + std::to_string(components) +
           "\" format=\"ascii\">" + numbers + "</DataArray>\n";
}

std::string raw_bytes(const std::vector<double>& values) {
    std::string bytes(8 * values.size(), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

void check_ramp(const io::ImageData& image) {
    CHECK(image.counts == std::array<std::size_t, 3>{2, 3, 1});
    CHECK(image.origin == Eigen::Vector3d(0, 0, 7));
    CHECK(image.spacing == Eigen::Vector3d(0.5, 0.25, 1));
    CHECK(image.array("u", 1).values == ramp);
}

std::string complaint(const std::string& text) {
    try {
        read_image(text);
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("a VTI file is read however its numbers are stored") {
    check_ramp(read_image(document(array("u", 1, "0 1 2\n3 4 5.5"))));

    std::string inline_array;
    io::append_vtk_array(inline_array, "u", 1, ramp, io::VtkEncoding::binary);
    check_ramp(read_image(document(inline_array)));

    const std::uint64_t size = 8 * ramp.size();
    const std::string header(reinterpret_cast<const char*>(&size), 8);
    const std::string appended = "<DataArray type=\"Float64\" Name=\"u\" format=\"appended\" offset=\"0\"/>\n";
    check_ramp(read_image(document(
        appended, grid, "<AppendedData encoding=\"raw\">\n_" + header + raw_bytes(ramp) + "\n</AppendedData>\n")));
    check_ramp(read_image(document(
        appended, grid,
        "<AppendedData encoding=\"base64\">\n_" + io::base64(header + raw_bytes(ramp)) + "\n</AppendedData>\n")));
}

TEST_CASE("arrays are found by name or by their number of components") {
    const io::ImageData image = read_image(document(array("u", 1, "0 1 2 3 4 5") + array("p", 1, "0 0 0 0 0 0") +
                                                    array("v", 3, "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17")));
    CHECK(image.array("v", 3).values[17] == 17);
    CHECK(&image.array("", 3) == &image.array("v", 3));
    CHECK_THROWS_WITH(image.array("", 1), Contains("has several arrays with 1 components") && Contains("u (1), p (1)"));
    CHECK_THROWS_WITH(image.array("w", 3), Contains("has no array \"w\" with 3 components") && Contains("v (3)"));
    CHECK_THROWS_WITH(image.array("v", 2), Contains("has no array"));
    CHECK_THROWS_WITH(read_image(document("")).array("", 3), Contains("there are none"));
}

TEST_CASE("VTI files that can't be used are refused with place and cure") {
    CHECK_THAT(complaint("<VTKFile type=\"PolyData\"/>"), Contains("is no VTK file of type ImageData"));
    CHECK_THAT(complaint("<VTKFile type=\"ImageData\"><ImageData>"), Contains("is no XML"));
    CHECK_THAT(complaint("<VTKFile type=\"ImageData\"><ImageData/></VTKFile>"), Contains("has no element Piece"));
    CHECK_THAT(complaint(document(array("u", 1, "0 1 2 3 4"))), Contains("image.vti") && Contains("array \"u\""));
    CHECK_THAT(complaint(document(array("u", 1, "0 1 2 3 4 5 6"))), Contains("array \"u\""));
    CHECK_THAT(complaint(document(array("u", 1, "0 1 2 x 4 5"))), Contains("array \"u\""));
    CHECK_THAT(complaint(document(array("u", 0, ""))), Contains("has no components"));
    CHECK_THAT(complaint(document("", "Origin=\"0 0 0\" Spacing=\"1 0 1\"")), Contains("Spacing is not positive"));
    CHECK_THAT(complaint(document("", "Origin=\"0 0\"")), Contains("the attribute Origin"));
    CHECK_THAT(complaint(document("", "Direction=\"0 1 0 1 0 0 0 0 1\"")), Contains("not parallel to the axes"));
    const auto with_extent = [](const std::string& extent) {
        std::string text = document(array("u", 1, "0"));
        const std::string old = "Piece Extent=\"1 2 0 2 0 0";
        return text.replace(text.find(old), old.size(), "Piece Extent=\"" + extent);
    };
    CHECK_THAT(complaint(with_extent("3 2 0 2 0 0")), Contains("Extent is no range"));
    CHECK_THAT(complaint(with_extent("0 0.5 0 2 0 0")), Contains("Extent is no range"));
    CHECK_THAT(complaint(with_extent("0 2000000000 0 2000000000 0 0")), Contains("too large"));
    CHECK_THAT(complaint(with_extent("0 20000 0 20000 0 0")), Contains("has 1 numbers where 400040001 are announced"));
}
