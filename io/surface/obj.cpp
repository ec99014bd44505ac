// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront's text format. Source: Advanced Visualizer manual, appendix B1, "Object Files (.obj)".
#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "io/atomic_file.h"
#include "io/number.h"
#include "io/surface/assembly.h"
#include "io/surface/formats.h"
#include "io/tet/row_writer.h"
#include "io/text_scanner.h"

namespace dsc::io::surface {

namespace {

// All others tell of a damaged file: with an unknown word for "v", every index behind it would mean another vertex.
bool is_left_out(std::string_view keyword) {
    static constexpr std::string_view keywords[] = {
        "vt",   "vn",  "vp",    "g",        "s",      "o",          "l",        "p",    "usemtl", "mtllib",
        "mg",   "deg", "bmat",  "step",     "cstype", "curv",       "curv2",    "surf", "parm",   "trim",
        "hole", "sp",  "scrv",  "end",      "con",    "bevel",      "c_interp", "lod",  "usemap", "maplib",
        "call", "csh", "ctech", "d_interp", "stech",  "shadow_obj", "trace_obj"};
    return std::ranges::find(keywords, keyword) != std::end(keywords);
}

/// Vertices and faces in the order of the file; `Target` has add_vertex(point) and add_face(numbers, reject), numbers
/// from 1.
template <class Target>
class ObjReader {
public:
    ObjReader(TextScanner scanner, Target& target) : scanner_(std::move(scanner)), target_(target) {}

    void read() {
        while (!scanner_.at_end()) {
            const std::string_view keyword = scanner_.word("a keyword");
            if (keyword == "v") {
                read_vertex();
            } else if (keyword == "f") {
                read_face();
            } else if (!is_left_out(keyword)) {
                scanner_.fail(in_quotes(keyword) + " where a keyword is expected", "correct or remove the line");
            }
            while (!next_word().empty()) {
            }
        }
    }

private:
    // The next word of the line, which a backslash at its end joins to the next one; empty when there is none.
    std::string_view next_word() {
        while (!scanner_.at_line_end()) {
            std::string_view word = scanner_.word("a word");
            if (word.ends_with('\\') && scanner_.at_line_end()) {
                word.remove_suffix(1);
                scanner_.skip_line();
            }
            if (!word.empty()) return word;
        }
        return {};
    }

    double read_coordinate() {
        const std::string_view word = next_word();
        if (word.empty()) scanner_.fail("a vertex has fewer than 3 coordinates", "complete the line");
        const std::optional<double> value = parse_finite(word);
        if (!value) scanner_.fail(in_quotes(word) + " where a coordinate is expected", "write a finite number");
        return *value;
    }

    // A weight or a colour may follow.
    void read_vertex() {
        const double x = read_coordinate();
        const double y = read_coordinate();
        const double z = read_coordinate();
        target_.add_vertex(x, y, z);
        ++vertices_;
    }

    void read_face() {
        polygon_.clear();
        for (std::string_view word = next_word(); !word.empty(); word = next_word()) {
            const std::int64_t number = number_of_vertex(word);
            // Negative ones are counted back from the last vertex.
            polygon_.push_back(number < 0 ? vertices_ + 1 + number : number);
            if (number < 0 && polygon_.back() < 1 && vertices_ > 0) {
                scanner_.fail("vertex " + std::to_string(number) + " does not exist",
                              "use -1 to -" + std::to_string(vertices_));
            }
        }
        target_.add_face(polygon_,
                         [this](const std::string& problem, const std::string& cure) { scanner_.fail(problem, cure); });
    }

    // A corner is VERTEX, VERTEX/TEXTURE, VERTEX//NORMAL or VERTEX/TEXTURE/NORMAL.
    std::int64_t number_of_vertex(std::string_view corner) const {
        const char* end = corner.data() + corner.size();
        std::int64_t number = 0;
        const auto [last, error] = std::from_chars(corner.data(), end, number);
        if (error != std::errc() || (last != end && *last != '/')) {
            scanner_.fail(in_quotes(corner) + " where the number of a vertex is expected", "write a whole number");
        }
        return number;
    }

    TextScanner scanner_;
    Target& target_;
    std::int64_t vertices_ = 0;
    std::vector<std::int64_t> polygon_;
};

// Growing step by step would need up to three times the memory of the data.
std::size_t count_lines(std::string_view text, std::string_view beginning) {
    std::size_t count = text.starts_with(beginning) ? 1 : 0;
    for (std::size_t i = text.find('\n'); i != text.npos; i = text.find('\n', i + 1)) {
        if (text.substr(i + 1, beginning.size()) == beginning) ++count;
    }
    return count;
}

struct SurfaceTarget {
    SurfaceAssembly assembly;

    void add_vertex(double x, double y, double z) { assembly.add_vertex(x, y, z); }
    template <class Reject>
    void add_face(const std::vector<std::int64_t>& numbers, const Reject& reject) {
        assembly.add_polygon(numbers, reject);
    }
};

struct PointTarget {
    geometry::PointData data;

    void add_vertex(double x, double y, double z) { data.points.emplace_back(x, y, z); }
    template <class Reject>
    void add_face(const std::vector<std::int64_t>& /*numbers*/, const Reject& /*reject*/) {}
};

}  // namespace

geometry::SurfaceData read_obj(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    SurfaceTarget target{SurfaceAssembly(path.string(), 1)};
    target.assembly.reserve_vertices(count_lines(text, "v "));
    target.assembly.reserve_triangles(count_lines(text, "f "));
    ObjReader(TextScanner(path.string(), text, {.comment = '#'}), target).read();
    return target.assembly.finish();
}

geometry::PointData read_obj_points(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    PointTarget target;
    target.data.points.reserve(count_lines(text, "v "));
    ObjReader(TextScanner(path.string(), text, {.comment = '#'}), target).read();
    return std::move(target.data);
}

void write_obj(const std::filesystem::path& path, const geometry::SurfaceData& data) {
    tet::RowWriter out(path);
    for (const Eigen::Vector3d& p : data.vertices) {
        out.text("v ");
        out.row(p);
    }
    for (const auto& [a, b, c] : data.triangles) {
        out.text("f ");
        out.row(a + 1ULL, b + 1ULL, c + 1ULL);
    }
    out.file().commit();
}

}  // namespace dsc::io::surface
