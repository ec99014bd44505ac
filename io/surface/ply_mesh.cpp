// SPDX-License-Identifier: GPL-3.0-or-later
// What of a PLY file is a surface or a point cloud, and PLY files of surfaces.
#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include "core/assert.h"
#include "core/errors.h"
#include "io/atomic_file.h"
#include "io/surface/assembly.h"
#include "io/surface/bytes.h"
#include "io/surface/formats.h"
#include "io/surface/ply.h"

namespace dsc::io::surface {

namespace {

constexpr std::string_view coordinates[] = {"x", "y", "z", "nx", "ny", "nz"};
constexpr std::string_view label[] = {"label"};

bool has_all(const PlyElement& element, std::span<const std::string_view> properties) {
    return std::ranges::all_of(properties, [&](std::string_view property) { return element.has(property); });
}

void require(const PlyReader& reader, const std::string& source, const char* name) {
    if (std::ranges::find(reader.elements(), name, &PlyElement::name) == reader.elements().end()) {
        throw core::InputError(source, "", std::string("contains no element ") + name, "give a whole PLY file");
    }
}

// Calls add(row) for each vertex, whose numbers are its coordinates and, when there are all three, its normal.
template <class Add>
void read_vertices(PlyReader& reader, const PlyElement& element, const Add& add) {
    if (!has_all(element, std::span(coordinates).first(3))) {
        reader.body().fail("the vertices lack one of the properties x, y and z", "give a PLY file of points in space");
    }
    PlyRows rows(element, std::span(coordinates).first(has_all(element, coordinates) ? 6 : 3));
    for (std::uint64_t i = 0; i < element.count; ++i) {
        rows.read(reader.body());
        add(rows.numbers());
    }
}

void read_faces(PlyReader& reader, const PlyElement& element, SurfaceAssembly& assembly) {
    const auto reject = [&](const std::string& problem, const std::string& cure) { reader.body().fail(problem, cure); };
    const char* list = element.has_list("vertex_index") ? "vertex_index" : "vertex_indices";
    if (!element.has_list(list)) reject("the faces have no list vertex_indices", "give a PLY file of a surface");
    const bool has_label = element.has("label");
    PlyRows rows(element, label, list);
    for (std::uint64_t i = 0; i < element.count; ++i) {
        rows.read(reader.body());
        if (has_label) {
            if (!is_whole(rows.numbers()[0])) reject("the label is not a whole number", "correct it");
            assembly.add_polygon(rows.list(), static_cast<std::int64_t>(rows.numbers()[0]), reject);
        } else {
            assembly.add_polygon(rows.list(), reject);
        }
    }
}

}  // namespace

geometry::SurfaceData read_ply(const std::filesystem::path& path) {
    const std::string bytes = read_file(path);
    PlyReader reader(path.string(), bytes);
    require(reader, path.string(), "vertex");
    require(reader, path.string(), "face");
    SurfaceAssembly assembly(path.string(), 0);
    for (const PlyElement& element : reader.elements()) {
        reader.require_room(element);
        if (element.name == "vertex") {
            assembly.reserve_vertices(element.count);
            read_vertices(reader, element,
                          [&](const std::vector<double>& p) { assembly.add_vertex(p[0], p[1], p[2]); });
        } else if (element.name == "face") {
            assembly.reserve_triangles(element.count);
            read_faces(reader, element, assembly);
        } else {
            reader.skip_rows(element);
        }
    }
    reader.body().require_end();
    return assembly.finish();
}

geometry::PointData read_ply_points(const std::filesystem::path& path) {
    const std::string bytes = read_file(path);
    PlyReader reader(path.string(), bytes);
    require(reader, path.string(), "vertex");
    geometry::PointData data;
    for (const PlyElement& element : reader.elements()) {
        reader.require_room(element);
        if (element.name != "vertex") {
            reader.skip_rows(element);
            continue;
        }
        data.points.reserve(element.count);
        if (has_all(element, coordinates)) data.normals.reserve(element.count);
        read_vertices(reader, element, [&](const std::vector<double>& p) {
            data.points.emplace_back(p[0], p[1], p[2]);
            if (p.size() == 6) data.normals.emplace_back(p[3], p[4], p[5]);
        });
    }
    reader.body().require_end();
    return data;
}

namespace {

std::string ply_head(const geometry::SurfaceData& data, const SurfaceColumns& columns) {
    std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(data.vertices.size());
    const auto add = [&](const std::string& type_and_name) { head += "\nproperty " + type_and_name; };
    for (const char* name : {"x", "y", "z"}) add(std::string("double ") + name);
    if (!columns.normals.empty()) {
        for (const char* name : {"nx", "ny", "nz"}) add(std::string("double ") + name);
    }
    for (const auto& column : columns.vertex_columns) add("double " + column.name);
    head += "\nelement face " + std::to_string(data.triangles.size());
    add("list uchar int vertex_indices");
    if (!data.labels.empty()) add("int label");
    for (const auto& column : columns.face_columns) add("int " + column.name);
    return head + "\nend_header\n";
}

void append_vector(std::string& bytes, const Eigen::Vector3d& v) {
    for (const double x : v) append_bytes(bytes, x);
}

}  // namespace

void write_ply(const std::filesystem::path& path, const geometry::SurfaceData& data, const SurfaceColumns& columns) {
    DSC_ASSERT(data.vertices.size() <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()));
    AtomicFile file(path);
    file.write(ply_head(data, columns));
    std::string row;
    for (std::size_t i = 0; i < data.vertices.size(); ++i) {
        row.clear();
        append_vector(row, data.vertices[i]);
        if (!columns.normals.empty()) append_vector(row, columns.normals[i]);
        for (const auto& column : columns.vertex_columns) append_bytes(row, column.values[i]);
        file.write(row);
    }
    for (std::size_t i = 0; i < data.triangles.size(); ++i) {
        row.clear();
        append_bytes(row, std::uint8_t{3});
        for (const std::uint32_t v : data.triangles[i]) append_bytes(row, static_cast<std::int32_t>(v));
        if (!data.labels.empty()) append_bytes(row, static_cast<std::int32_t>(data.labels[i]));
        for (const auto& column : columns.face_columns) append_bytes(row, static_cast<std::int32_t>(column.values[i]));
        file.write(row);
    }
    file.commit();
}

}  // namespace dsc::io::surface
