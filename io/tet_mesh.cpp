// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tet_mesh.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>

#include "core/assert.h"
#include "core/errors.h"
#include "io/atomic_file.h"
#include "io/tet/formats.h"

namespace dsc::io {

namespace {

std::string extension_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

std::filesystem::path tetgen_stem(const std::filesystem::path& path) {
    const std::string extension = extension_of(path);
    return extension == ".node" || extension == ".ele" ? std::filesystem::path(path).replace_extension() : path;
}

[[maybe_unused]] bool is_consistent(const geometry::TetData& data) {
    return (data.labels.empty() || data.labels.size() == data.tets.size()) &&
           std::ranges::all_of(data.tets, [&](const auto& tet) {
               return std::ranges::all_of(tet, [&](std::uint32_t v) { return v < data.vertices.size(); });
           });
}

}  // namespace

TetFormat tet_format(const std::filesystem::path& path) {
    const std::string extension = extension_of(path);
    if (extension == ".mesh") return TetFormat::medit;
    if (extension == ".msh") return TetFormat::gmsh;
    if (extension == ".vtu") return TetFormat::vtu;
    if (extension == ".vtk") return TetFormat::legacy_vtk;
    const bool is_number = !extension.empty() && extension.find_first_not_of("0123456789", 1) == extension.npos;
    if (extension == ".node" || extension == ".ele" || extension.empty() || is_number) return TetFormat::tetgen;
    throw core::InputError(path.string(), "", "no format of tetrahedral meshes has the extension " + extension,
                           "use .node, .ele, .mesh, .msh, .vtu or .vtk");
}

TetMeshFile read_tet_mesh(const std::filesystem::path& path) {
    TetMeshFile file{.data = {}, .format = tet_format(path), .dialect = {}};
    switch (file.format) {
        case TetFormat::tetgen: file.data = tet::read_tetgen(tetgen_stem(path), file.dialect.first_index); break;
        case TetFormat::medit: file.data = tet::read_medit(path); break;
        case TetFormat::gmsh: file.data = tet::read_gmsh(path, file.dialect.gmsh); break;
        case TetFormat::vtu: file.data = tet::read_vtu(path); break;
        case TetFormat::legacy_vtk: file.data = tet::read_legacy_vtk(path); break;
    }
    return file;
}

void write_tet_mesh(const std::filesystem::path& path, const geometry::TetData& data, const TetMeshDialect& dialect) {
    DSC_ASSERT(is_consistent(data));
    DSC_ASSERT(dialect.first_index == 0 || dialect.first_index == 1);
    switch (tet_format(path)) {
        case TetFormat::tetgen: tet::write_tetgen(tetgen_stem(path), data, dialect.first_index); break;
        case TetFormat::medit: tet::write_medit(path, data); break;
        case TetFormat::gmsh: tet::write_gmsh(path, data, dialect.gmsh); break;
        case TetFormat::vtu: tet::write_vtu(path, data); break;
        case TetFormat::legacy_vtk: tet::write_legacy_vtk(path, data); break;
    }
}

void require_writable_tet_mesh(const std::filesystem::path& path) {
    if (tet_format(path) != TetFormat::tetgen) {
        require_writable(path);
        return;
    }
    for (const char* extension : {".node", ".ele"}) {
        std::filesystem::path file = tetgen_stem(path);
        file += extension;
        require_writable(file);
    }
}

}  // namespace dsc::io
