// SPDX-License-Identifier: GPL-3.0-or-later
// Stereolithography. Source: 3D Systems, StereoLithography Interface Specification (1989), as quoted by M. Burns,
// "Automated Fabrication" (1993), section 6.5.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include "core/errors.h"
#include "io/atomic_file.h"
#include "io/surface/bytes.h"
#include "io/surface/formats.h"
#include "io/surface/vertex_merger.h"
#include "io/text_scanner.h"

namespace dsc::io::surface {

namespace {

constexpr std::size_t head_size = 80;
constexpr std::size_t count_end = head_size + 4;
constexpr std::size_t facet_size = 50;

using Facet = std::array<Eigen::Vector3d, 3>;

class StlAssembly {
public:
    void reserve(std::size_t triangles) { data_.triangles.reserve(triangles); }

    void add(const Facet& facet) {
        std::array<std::uint32_t, 3> t{};
        for (std::size_t k = 0; k < 3; ++k) t[k] = merger_.number(facet[k]);
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) data_.triangles.push_back(t);
    }

    geometry::SurfaceData finish(const std::string& source) {
        if (data_.triangles.empty()) {
            throw core::InputError(source, "", "contains no facets with three different corners", "give a surface");
        }
        data_.vertices = std::move(merger_).places();
        return std::move(data_);
    }

private:
    VertexMerger merger_;
    geometry::SurfaceData data_;
};

// --- ASCII ---

bool is_same_word(std::string_view word, std::string_view lower_case) {
    return std::ranges::equal(word, lower_case,
                              [](unsigned char c, unsigned char lower) { return std::tolower(c) == lower; });
}

void require_word(TextScanner& scanner, const char* keyword) {
    const std::string_view word = scanner.word(keyword);
    if (!is_same_word(word, keyword)) {
        scanner.fail(in_quotes(word) + " where " + keyword + " is expected", "correct the facet");
    }
}

Facet read_facet(TextScanner& scanner) {
    require_word(scanner, "normal");
    scanner.skip_words(3, "the normal of a facet");  // which follows from its corners
    require_word(scanner, "outer");
    require_word(scanner, "loop");
    Facet facet;
    for (Eigen::Vector3d& corner : facet) {
        require_word(scanner, "vertex");
        for (double& x : corner) x = scanner.real("a coordinate");
    }
    require_word(scanner, "endloop");
    require_word(scanner, "endfacet");
    return facet;
}

geometry::SurfaceData read_ascii(TextScanner scanner, std::size_t size) {
    constexpr std::size_t usual_facet_bytes = 200;
    StlAssembly assembly;
    assembly.reserve(size / usual_facet_bytes);
    while (!scanner.at_end()) {
        require_word(scanner, "solid");
        scanner.skip_line();  // the name
        std::string_view word = scanner.word("facet or endsolid");
        for (; is_same_word(word, "facet"); word = scanner.word("facet or endsolid")) assembly.add(read_facet(scanner));
        if (!is_same_word(word, "endsolid")) {
            scanner.fail(in_quotes(word) + " where facet or endsolid is expected", "correct the facet before");
        }
        scanner.skip_line();
    }
    return assembly.finish(scanner.source());
}

// --- binary ---

// The text of a binary file may begin with "solid", too: then its size, which follows from the number of facets, tells.
bool has_size_of_binary(std::string_view bytes) {
    if (bytes.size() < count_end) return false;
    const auto count = number_at<std::uint32_t>(bytes.data() + head_size, std::endian::little);
    return bytes.size() == count_end + facet_size * std::uint64_t{count};
}

geometry::SurfaceData read_binary(const std::string& source, std::string_view bytes) {
    const std::size_t count = (bytes.size() - count_end) / facet_size;
    StlAssembly assembly;
    assembly.reserve(count);
    const char* at = bytes.data() + count_end;
    for (std::size_t i = 0; i < count; ++i, at += facet_size) {
        Facet facet;
        for (Eigen::Index k = 0; k < 9; ++k) {
            const auto x = number_at<float>(at + sizeof(float) * static_cast<std::size_t>(3 + k), std::endian::little);
            if (!std::isfinite(x)) {
                throw core::InputError(source, "facet " + std::to_string(i + 1), "a coordinate is not a finite number",
                                       "correct or remove the facet");
            }
            facet[static_cast<std::size_t>(k / 3)][k % 3] = static_cast<double>(x);
        }
        assembly.add(facet);
    }
    return assembly.finish(source);
}

void append_floats(std::string& bytes, const Eigen::Vector3f& v) {
    for (const float x : v) append_bytes(bytes, x);
}

void require_floats(const std::filesystem::path& path, const geometry::SurfaceData& data) {
    for (std::size_t i = 0; i < data.vertices.size(); ++i) {
        if (data.vertices[i].lpNorm<Eigen::Infinity>() <= std::numeric_limits<float>::max()) continue;
        throw core::InputError(path.string(), "vertex " + std::to_string(i),
                               "a coordinate is beyond the floats that STL has room for", "choose .ply, .obj or .off");
    }
}

}  // namespace

geometry::SurfaceData read_stl(const std::filesystem::path& path) {
    const std::string bytes = read_file(path);
    if (has_size_of_binary(bytes)) return read_binary(path.string(), bytes);
    TextScanner scanner(path.string(), bytes);
    const TextScanner begin = scanner;
    if (!is_same_word(scanner.word("solid"), "solid")) {
        throw core::InputError(path.string(), "", "is neither an ASCII STL file nor has it the size of a binary one",
                               "the file is truncated or its number of facets is wrong");
    }
    return read_ascii(begin, bytes.size());
}

void write_stl(const std::filesystem::path& path, const geometry::SurfaceData& data) {
    require_floats(path, data);
    AtomicFile file(path);
    std::string bytes = "binary STL";
    bytes.resize(head_size, ' ');
    append_bytes(bytes, static_cast<std::uint32_t>(data.triangles.size()));
    file.write(bytes);
    for (const auto& [a, b, c] : data.triangles) {
        const Eigen::Vector3d &p = data.vertices[a], &q = data.vertices[b], &r = data.vertices[c];
        bytes.clear();
        append_floats(bytes,
                      (q - p).stableNormalized().cross((r - p).stableNormalized()).stableNormalized().cast<float>());
        for (const Eigen::Vector3d& corner : {p, q, r}) append_floats(bytes, corner.cast<float>());
        append_bytes(bytes, std::uint16_t{0});
        file.write(bytes);
    }
    file.commit();
}

}  // namespace dsc::io::surface
