// SPDX-License-Identifier: GPL-3.0-or-later
// MEDIT's text format. Source: P. Frey, MEDIT: an interactive mesh visualization software, INRIA RT-0253, appendix; the
// keywords added by libMeshb 7.
#include <cctype>
#include <optional>
#include <utility>

#include "io/tet/assembly.h"
#include "io/tet/formats.h"
#include "io/tet/row_writer.h"
#include "io/text_scanner.h"

namespace dsc::io::tet {

namespace {

constexpr std::size_t least_vertex_bytes = 8;
constexpr std::size_t least_tet_bytes = 10;

// Sections of volume cells that are no linear tetrahedra.
bool is_other_volume(std::string_view keyword) {
    for (const std::string_view kind : {"Hexahedra", "Prisms", "Pentahedra", "Pyramids"}) {
        if (keyword.starts_with(kind)) return true;
    }
    return keyword.starts_with("TetrahedraP");
}

class MeditReader {
public:
    explicit MeditReader(TextScanner scanner) : scanner_(std::move(scanner)), assembly_(scanner_.source(), 1) {}

    geometry::TetData read() {
        read_head();
        while (!scanner_.at_end() && !is_ended_) read_section(scanner_.word("a keyword"));
        if (!has_vertices_) scanner_.fail("there is no section Vertices", "give a whole MEDIT file");
        if (tets_before_vertices_) read_tets(*tets_before_vertices_);
        return assembly_.finish();
    }

private:
    void read_head() {
        if (scanner_.word("MeshVersionFormatted") != "MeshVersionFormatted") {
            scanner_.fail("is no MEDIT text file: it does not begin with MeshVersionFormatted",
                          "write ASCII .mesh (not .meshb)");
        }
        scanner_.integer("the version");
    }

    void read_section(std::string_view keyword) {
        if (keyword == "Dimension") {
            if (scanner_.integer("the dimension") != 3) scanner_.fail("the dimension is not 3", "give a volume mesh");
        } else if (keyword == "Vertices") {
            read_vertices();
        } else if (keyword == "Tetrahedra") {
            if (std::exchange(has_tets_, true)) scanner_.fail("there is a second section Tetrahedra", "join the two");
            if (has_vertices_) {
                read_tets(scanner_);
            } else {
                tets_before_vertices_ = scanner_;
                skip_section();
            }
        } else if (is_other_volume(keyword)) {
            if (scanner_.integer("a count") != 0) {
                scanner_.fail("the mesh has " + std::string(keyword), "convert them to linear tetrahedra");
            }
        } else if (keyword == "End") {
            is_ended_ = true;
        } else if (std::isalpha(static_cast<unsigned char>(keyword.front())) != 0) {
            skip_section();
        } else {
            scanner_.fail(in_quotes(keyword) + " where a keyword is expected",
                          "correct the count of the section before");
        }
    }

    // Up to the next keyword: so that no list of all keywords ever invented is needed. Numbers never begin with a
    // letter.
    void skip_section() {
        while (is_within_section(scanner_)) scanner_.word("a number");
    }
    static bool is_within_section(TextScanner& scanner) {
        return !scanner.at_end() && std::isalpha(static_cast<unsigned char>(scanner.rest().front())) == 0;
    }

    void read_vertices() {
        if (std::exchange(has_vertices_, true)) scanner_.fail("there is a second section Vertices", "join the two");
        const std::size_t count = scanner_.count("vertices", least_vertex_bytes);
        assembly_.reserve_vertices(count);
        for (std::size_t i = 0; i < count; ++i) {
            scanner_.begin_record("a vertex");
            const double x = scanner_.real("a coordinate");
            const double y = scanner_.real("a coordinate");
            const double z = scanner_.real("a coordinate");
            scanner_.integer("the reference of a vertex");
            scanner_.end_record();
            assembly_.add_vertex(x, y, z);
        }
    }

    void read_tets(TextScanner& scanner) {
        const auto reject = [&](const std::string& problem, const std::string& cure) { scanner.fail(problem, cure); };
        const std::size_t count = scanner.count("tetrahedra", least_tet_bytes);
        assembly_.reserve_tets(count);
        for (std::size_t i = 0; i < count; ++i) {
            scanner.begin_record("a tetrahedron");
            std::array<std::int64_t, 4> tet{};
            for (std::int64_t& vertex : tet) vertex = scanner.integer("the number of a vertex");
            const std::int64_t label = scanner.integer("the reference of a tetrahedron");
            scanner.end_record();
            assembly_.add_tet(tet, label, reject);
        }
        if (is_within_section(scanner)) scanner.fail("there are more tetrahedra than announced", "correct their count");
    }

    TextScanner scanner_;
    TetAssembly assembly_;
    std::optional<TextScanner> tets_before_vertices_;  // at their count
    bool has_vertices_ = false;
    bool has_tets_ = false;
    bool is_ended_ = false;
};

}  // namespace

geometry::TetData read_medit(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    return MeditReader(TextScanner(path.string(), text, {.comment = '#'})).read();
}

void write_medit(const std::filesystem::path& path, const geometry::TetData& data) {
    RowWriter out(path);
    out.text("MeshVersionFormatted 2\nDimension 3\nVertices\n");
    out.row(data.vertices.size());
    for (const Eigen::Vector3d& p : data.vertices) out.row(p, 0);
    out.text("Tetrahedra\n");
    out.row(data.tets.size());
    for (std::size_t i = 0; i < data.tets.size(); ++i) {
        const auto& t = data.tets[i];
        out.row(t[0] + 1ULL, t[1] + 1ULL, t[2] + 1ULL, t[3] + 1ULL, data.label(i));
    }
    out.text("End\n");
    out.file().commit();
}

}  // namespace dsc::io::tet
