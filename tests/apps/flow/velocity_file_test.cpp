// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/velocity_file.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>

#include "core/errors.h"
#include "core/random.h"
#include "io/atomic_file.h"
#include "io/number.h"
#include "tests/support/seed.h"
#include "tests/support/temporary_folder.h"

using namespace dsc;
using namespace dsc::flow;
using motion::Vector;

namespace {

constexpr int cells = 4;
constexpr double spacing = 0.5;
const Vector<3> origin(-1, 0, 2);

/// A grid of image data, `layers` points high, with this velocity at its points.
std::string vti(int layers, const std::function<Vector<3>(const Vector<3>&)>& velocity,
                const std::string& more_arrays = "") {
    const std::string extent = "0 4 0 4 0 " + std::to_string(layers - 1);
    std::string values;
    for (int k = 0; k < layers; ++k)
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i)
                for (const double v : velocity(origin + spacing * Vector<3>(i, j, k)))
                    values += io::number_text(v) + " ";
    return "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\"><ImageData WholeExtent=\"" +
           extent + "\" Origin=\"-1 0 2\" Spacing=\"0.5 0.5 0.5\"><Piece Extent=\"" + extent +
           "\"><PointData><DataArray type=\"Float64\" Name=\"wind\" NumberOfComponents=\"3\" format=\"ascii\">" +
           values + "</DataArray>" + more_arrays + "</PointData></Piece></ImageData></VTKFile>";
}

Vector<3> turning(const Vector<3>& p) { return {-p.y(), p.x(), p.x() * p.y() * p.z()}; }

}  // namespace

TEST_CASE("a velocity on a grid is what it was made of where that is linear in each coordinate, and clamped outside") {
    const tests::TemporaryFolder folder;
    const std::string path = (folder / "wind.vti").string();
    io::write_file(path, vti(cells + 1, turning));
    const motion::VelocityField<3> wind = velocity_from_file<3>(path, "wind");
    core::Random random(tests::seed(1));
    for (int trial = 0; trial < 100; ++trial) {
        Vector<3> p;
        for (double& x : p) x = random.uniform(-1, 1);
        p += origin + Vector<3>::Constant(spacing * cells / 2);
        CHECK((wind(p, random.uniform(0, 5)) - turning(p)).norm() < 1e-13);
    }
    CHECK((wind(Vector<3>(9, 1, 3), 0) - turning(Vector<3>(1, 1, 3))).norm() < 1e-13);
    CHECK((velocity_from_file<3>(path, "")(Vector<3>(0, 1, 3), 0) - turning(Vector<3>(0, 1, 3))).norm() < 1e-13);
}

TEST_CASE("in the plane a grid has one layer, and its third coordinates don't count") {
    const tests::TemporaryFolder folder;
    const std::string path = (folder / "wind.vti").string();
    io::write_file(path, vti(1, turning));
    CHECK((velocity_from_file<2>(path, "wind")(Vector<2>(0.3, 1.2), 0) - Vector<2>(-1.2, 0.3)).norm() < 1e-15);
    io::write_file(path, vti(2, turning));
    CHECK_THROWS_WITH(velocity_from_file<2>(path, ""), Catch::Contains("2 layers"));
}

TEST_CASE("a file without a velocity, with several, or with one that is not finite is refused") {
    const tests::TemporaryFolder folder;
    const std::string path = (folder / "wind.vti").string();
    CHECK_THROWS_AS(velocity_from_file<3>(path, ""), core::InputError);
    io::write_file(path, vti(2, turning));
    CHECK_THROWS_WITH(velocity_from_file<3>(path, "current"), Catch::Contains("current") && Catch::Contains("wind"));
    std::string zeros;
    for (int i = 0; i < 3 * 2 * (cells + 1) * (cells + 1); ++i) zeros += "0 ";
    io::write_file(path, vti(2, turning,
                             "<DataArray type=\"Float64\" Name=\"current\" NumberOfComponents=\"3\" format=\"ascii\">" +
                                 zeros + "</DataArray>"));
    CHECK_THROWS_WITH(velocity_from_file<3>(path, ""), Catch::Contains("several"));
    CHECK(velocity_from_file<3>(path, "current")(Vector<3>(0, 1, 2), 0).norm() == 0);
    io::write_file(path, vti(2, [](const Vector<3>& p) { return Vector<3>(0, std::log(p.y()), 0); }));
    CHECK_THROWS_WITH(velocity_from_file<3>(path, ""), Catch::Contains("finite"));
}
