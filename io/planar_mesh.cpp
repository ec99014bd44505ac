// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/planar_mesh.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>

#include "geometry/predicates.h"
#include "io/atomic_file.h"
#include "io/number.h"
#include "io/text_scanner.h"

namespace dsc::io {

namespace {

constexpr std::size_t least_vertex_bytes = 6;
constexpr std::size_t least_triangle_bytes = 8;

class Reader {
public:
    explicit Reader(TextScanner scanner) : scanner_(std::move(scanner)) {}

    geometry::SurfaceData read() {
        if (scanner_.word("MeshVersionFormatted") != "MeshVersionFormatted")
            scanner_.fail("is no MEDIT text file: it does not begin with MeshVersionFormatted", "write ASCII .mesh");
        scanner_.integer("the version");
        while (!scanner_.at_end()) {
            const std::string_view keyword = scanner_.word("a keyword");
            if (keyword == "End") break;
            if (keyword == "Dimension") {
                if (scanner_.integer("the dimension") != 2)
                    scanner_.fail("the dimension is not 2", "give a planar mesh");
            } else if (keyword == "Vertices") {
                read_vertices();
            } else if (keyword == "Triangles") {
                read_triangles();
            } else {
                while (!scanner_.at_end() && std::isalpha(static_cast<unsigned char>(scanner_.rest().front())) == 0)
                    scanner_.word("a number");
            }
        }
        if (data_.triangles.empty()) scanner_.fail("there are no triangles", "give a whole planar mesh");
        if (std::ranges::all_of(data_.triangles, [&](const auto& triangle) { return is_clockwise(triangle); }))
            for (auto& triangle : data_.triangles) std::swap(triangle[1], triangle[2]);
        return std::move(data_);
    }

private:
    void read_vertices() {
        const std::size_t count = scanner_.count("vertices", least_vertex_bytes);
        for (std::size_t i = 0; i < count; ++i) {
            scanner_.begin_record("a vertex");
            const double x = scanner_.real("a coordinate"), y = scanner_.real("a coordinate");
            scanner_.integer("the reference of a vertex");
            scanner_.end_record();
            data_.vertices.emplace_back(x, y, 0);
        }
    }

    void read_triangles() {
        const std::size_t count = scanner_.count("triangles", least_triangle_bytes);
        for (std::size_t i = 0; i < count; ++i) {
            scanner_.begin_record("a triangle");
            std::array<std::uint32_t, 3> triangle{};
            for (std::uint32_t& vertex : triangle) {
                const std::int64_t number = scanner_.integer("the number of a vertex");
                if (number < 1 || static_cast<std::size_t>(number) > data_.vertices.size())
                    scanner_.fail("vertex " + std::to_string(number) + " does not exist",
                                  "give the section Vertices first, and numbers from 1 on");
                vertex = static_cast<std::uint32_t>(number - 1);
            }
            const std::int64_t label = scanner_.integer("the reference of a triangle");
            if (label != static_cast<int>(label)) scanner_.fail("the label is too large", "use labels below 2^31");
            scanner_.end_record();
            data_.triangles.push_back(triangle);
            data_.labels.push_back(static_cast<int>(label));
        }
    }

    bool is_clockwise(const std::array<std::uint32_t, 3>& triangle) const {
        const auto corner = [&](std::size_t i) { return geometry::Point2(data_.vertices[triangle[i]].head<2>()); };
        return geometry::orientation(corner(0), corner(1), corner(2)) == geometry::Sign::negative;
    }

    TextScanner scanner_;
    geometry::SurfaceData data_;
};

}  // namespace

geometry::SurfaceData read_planar_mesh(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    return Reader(TextScanner(path.string(), text, {.comment = '#'})).read();
}

void write_planar_mesh(const std::filesystem::path& path, const geometry::SurfaceData& data) {
    std::string text = "MeshVersionFormatted 2\nDimension 2\nVertices\n" + std::to_string(data.vertices.size()) + "\n";
    for (const Eigen::Vector3d& p : data.vertices) {
        append_number(text, p.x());
        text += ' ';
        append_number(text, p.y());
        text += " 0\n";
    }
    text += "Triangles\n" + std::to_string(data.triangles.size()) + "\n";
    for (std::size_t i = 0; i < data.triangles.size(); ++i) {
        for (const std::uint32_t v : data.triangles[i]) text += std::to_string(v + 1) + " ";
        text += std::to_string(data.label(i)) + "\n";
    }
    text += "End\n";
    write_file(path, text);
}

}  // namespace dsc::io
