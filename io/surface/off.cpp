// SPDX-License-Identifier: GPL-3.0-or-later
// The Object File Format. Source: Geomview manual, "OFF Files".
#include <utility>
#include <vector>

#include "io/atomic_file.h"
#include "io/surface/assembly.h"
#include "io/surface/formats.h"
#include "io/tet/row_writer.h"
#include "io/text_scanner.h"

namespace dsc::io::surface {

namespace {

class OffReader {
public:
    explicit OffReader(TextScanner scanner) : scanner_(std::move(scanner)) { read_head(); }

    geometry::SurfaceData read_surface() {
        SurfaceAssembly assembly(scanner_.source(), 0);
        assembly.reserve_vertices(vertices_);
        for (std::size_t i = 0; i < vertices_; ++i) {
            scanner_.begin_record("a vertex");
            const Eigen::Vector3d p = read_vector();
            end_vertex();
            assembly.add_vertex(p.x(), p.y(), p.z());
        }
        assembly.reserve_triangles(faces_);
        for (std::size_t i = 0; i < faces_; ++i) read_face(assembly);
        scanner_.require_end("faces");
        return assembly.finish();
    }

    geometry::PointData read_points() {
        geometry::PointData data;
        data.points.reserve(vertices_);
        if (has_normals_) data.normals.reserve(vertices_);
        for (std::size_t i = 0; i < vertices_; ++i) {
            scanner_.begin_record("a vertex");
            data.points.push_back(read_vector());
            if (has_normals_) data.normals.push_back(read_vector());
            end_vertex();
        }
        if (faces_ == 0) scanner_.require_end("vertices");
        return data;
    }

private:
    // The word is OFF behind letters that say what follows the coordinates, in this order.
    void read_head() {
        std::string_view word = scanner_.word("OFF");
        const auto begins_with = [&](std::string_view letters) {
            const bool does = word.starts_with(letters);
            if (does) word.remove_prefix(letters.size());
            return does;
        };
        const bool has_texture = begins_with("ST");
        const bool has_colors = begins_with("C");
        has_normals_ = begins_with("N");
        has_more_ = has_texture || has_colors || has_normals_;
        if (word != "OFF") scanner_.fail("is no OFF file in space: it does not begin with OFF", "save it as ASCII OFF");

        scanner_.begin_record("the number of vertices");
        vertices_ = scanner_.count("vertices", 6);
        faces_ = scanner_.count("faces", 4);
        scanner_.skip_record();  // the number of edges, which nobody needs
    }

    Eigen::Vector3d read_vector() {
        const double x = scanner_.real("a coordinate");
        const double y = scanner_.real("a coordinate");
        const double z = scanner_.real("a coordinate");
        return {x, y, z};
    }

    void end_vertex() {
        if (has_more_) {
            scanner_.skip_record();
        } else {
            scanner_.end_record();
        }
    }

    void read_face(SurfaceAssembly& assembly) {
        scanner_.begin_record("a face");
        polygon_.resize(scanner_.count("vertices of a face", 2));
        for (std::int64_t& vertex : polygon_) vertex = scanner_.integer("the number of a vertex");
        scanner_.skip_record();  // the colour
        assembly.add_polygon(
            polygon_, [this](const std::string& problem, const std::string& cure) { scanner_.fail(problem, cure); });
    }

    TextScanner scanner_;
    bool has_normals_ = false;
    bool has_more_ = false;
    std::size_t vertices_ = 0;
    std::size_t faces_ = 0;
    std::vector<std::int64_t> polygon_;
};

}  // namespace

geometry::SurfaceData read_off(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    return OffReader(TextScanner(path.string(), text, {.comment = '#'})).read_surface();
}

geometry::PointData read_off_points(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    return OffReader(TextScanner(path.string(), text, {.comment = '#'})).read_points();
}

void write_off(const std::filesystem::path& path, const geometry::SurfaceData& data) {
    tet::RowWriter out(path);
    out.text("OFF\n");
    out.row(data.vertices.size(), data.triangles.size(), 0);
    for (const Eigen::Vector3d& p : data.vertices) out.row(p);
    for (const auto& [a, b, c] : data.triangles) out.row(3, a, b, c);
    out.file().commit();
}

}  // namespace dsc::io::surface
