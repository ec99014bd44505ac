// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg_paths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <pugixml.hpp>
#include <utility>

#include "core/errors.h"
#include "io/atomic_file.h"
#include "io/number.h"

namespace dsc::io {

namespace {

using Point = Eigen::Vector2d;
using Transform = Eigen::Affine2d;

constexpr double chords_of_size = 100;
/// More chords in a picture are taken for a mistake in the edge length.
constexpr double most_chords = 1e6;
/// Nearer points are the same: sums of relative coordinates are rounded [size of the picture's paths].
constexpr double same_place = 1e-12;

/// A part of a subpath: a straight one has no controls, a curve one or two.
struct Piece {
    std::vector<Point> controls;
    Point end;
};

struct Subpath {
    std::string name;
    Point begin;
    std::vector<Piece> pieces;
    bool is_closed = false;
};

/// Numbers of an attribute, separated by blanks, commas, or nothing at all where a sign or point tells them apart.
class Numbers {
public:
    Numbers(std::string source, std::string name, std::string_view text)
        : source_(std::move(source)), name_(std::move(name)), text_(text) {}

    void skip_separators() {
        while (at_ < text_.size() && std::strchr(" \t\r\n,", text_[at_]) != nullptr) ++at_;
    }
    bool at_end() {
        skip_separators();
        return at_ == text_.size();
    }
    bool at_letter() { return !at_end() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0; }
    char letter() { return text_[at_++]; }

    double number() {
        skip_separators();
        const std::size_t begin = at_;
        const auto skip_digits = [&] {
            while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
        };
        const auto skip_sign = [&] {
            if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
        };
        skip_sign();
        skip_digits();
        if (at_ < text_.size() && text_[at_] == '.') {
            ++at_;
            skip_digits();
        }
        if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
            ++at_;
            skip_sign();
            skip_digits();
        }
        const std::optional<double> value = parse_finite(text_.substr(begin, at_ - begin));
        if (!value) {
            at_ = begin;
            fail("there is no number where one is expected");
        }
        return *value;
    }
    Point point() {
        const double x = number();
        return {x, number()};
    }

    [[noreturn]] void fail(const std::string& problem) const {
        throw core::InputError(source_, name_ + ", character " + std::to_string(at_ + 1), problem,
                               "use paths of M, L, H, V, C, S, Q, T and Z");
    }

private:
    std::string source_, name_;
    std::string_view text_;
    std::size_t at_ = 0;
};

class PathReader {
public:
    PathReader(Numbers numbers, std::string name, const Transform& transform, std::vector<Subpath>& subpaths)
        : in_(std::move(numbers)), name_(std::move(name)), transform_(transform), subpaths_(subpaths) {}

    void read() {
        char command = 0;
        while (!in_.at_end()) {
            if (in_.at_letter()) {
                command = in_.letter();
            } else if (command == 0 || command == 'Z' || command == 'z') {
                in_.fail("there is a number where a command is expected");
            }
            const bool is_relative = command >= 'a';
            const Point base = is_relative ? at_ : Point(0, 0);
            apply(static_cast<char>(std::toupper(command)), base);
            // More coordinates after a move are lines.
            if (command == 'M') command = 'L';
            if (command == 'm') command = 'l';
        }
    }

private:
    void apply(char command, const Point& base) {
        if (command != 'M' && !has_begun_) in_.fail("a path has to begin with M");
        switch (command) {
            case 'M': return begin(base + in_.point());
            case 'L': return add({}, base + in_.point());
            case 'H': return add({}, {base.x() + in_.number(), at_.y()});
            case 'V': return add({}, {at_.x(), base.y() + in_.number()});
            case 'Q': {
                const Point control = base + in_.point();
                return add({control}, base + in_.point());
            }
            case 'T': {
                const Point control = last_controls_ == 1 ? Point(2 * at_ - control_) : at_;
                return add({control}, base + in_.point());
            }
            case 'C': {
                const Point first = base + in_.point(), second = base + in_.point();
                return add({first, second}, base + in_.point());
            }
            case 'S': {
                const Point first = last_controls_ == 2 ? Point(2 * at_ - control_) : at_;
                const Point second = base + in_.point();
                return add({first, second}, base + in_.point());
            }
            case 'Z':
                if (is_open_) subpath().is_closed = true;
                at_ = begin_;
                last_controls_ = 0;
                is_open_ = false;
                return;
            default: in_.fail(std::string("command ") + command + " is not known here");
        }
    }

    void begin(const Point& place) {
        begin_ = at_ = place;
        last_controls_ = 0;
        has_begun_ = true;
        is_open_ = false;
    }

    // A subpath begins with its first piece: a move alone, one after Z, or another Z makes none.
    Subpath& subpath() {
        if (!is_open_) subpaths_.push_back({.name = name_, .begin = transform_ * begin_});
        is_open_ = true;
        return subpaths_.back();
    }

    void add(std::vector<Point> controls, const Point& end) {
        last_controls_ = controls.size();
        if (!controls.empty()) control_ = controls.back();
        for (Point& control : controls) control = transform_ * control;
        subpath().pieces.push_back({std::move(controls), transform_ * end});
        at_ = end;
    }

    Numbers in_;
    std::string name_;
    const Transform& transform_;
    std::vector<Subpath>& subpaths_;
    Point begin_ = Point::Zero(), at_ = Point::Zero(), control_ = Point::Zero();
    std::size_t last_controls_ = 0;
    bool has_begun_ = false, is_open_ = false;
};

Transform single_transform(const std::string& name, const std::vector<double>& v, Numbers& numbers) {
    Transform t = Transform::Identity();
    const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
    if (name == "translate" && (v.size() == 1 || v.size() == 2)) {
        t.translate(Point(v[0], v.size() == 2 ? v[1] : 0));
    } else if (name == "scale" && (v.size() == 1 || v.size() == 2)) {
        t.scale(Point(v[0], v.back()));
    } else if (name == "rotate" && (v.size() == 1 || v.size() == 3)) {
        const Point about = v.size() == 3 ? Point(v[1], v[2]) : Point(0, 0);
        t.translate(about).rotate(radians(v[0])).translate(-about);
    } else if (name == "matrix" && v.size() == 6) {
        t.matrix() << v[0], v[2], v[4], v[1], v[3], v[5], 0, 0, 1;
    } else if (name == "skewX" && v.size() == 1) {
        t.linear()(0, 1) = std::tan(radians(v[0]));
    } else if (name == "skewY" && v.size() == 1) {
        t.linear()(1, 0) = std::tan(radians(v[0]));
    } else {
        numbers.fail("the transform is not known");
    }
    return t;
}

Transform parsed_transform(const std::string& source, std::string_view text) {
    Transform result = Transform::Identity();
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n,"), text.size()));
        if (text.empty()) return result;
        const std::size_t open = text.find('('), close = text.find(')');
        Numbers numbers(source, "transform", "");
        if (open == std::string_view::npos || close == std::string_view::npos || close < open)
            numbers.fail("the transform has no parentheses");
        std::string name(text.substr(0, open));
        while (!name.empty() && std::isspace(static_cast<unsigned char>(name.back())) != 0) name.pop_back();
        numbers = Numbers(source, "transform", text.substr(open + 1, close - open - 1));
        std::vector<double> values;
        while (!numbers.at_end()) values.push_back(numbers.number());
        result = result * single_transform(name, values, numbers);
        text.remove_prefix(close + 1);
    }
}

class Collector {
public:
    explicit Collector(std::string source) : source_(std::move(source)) {}

    std::vector<Subpath> run(const pugi::xml_node& root, const Transform& transform) {
        // Groups are kept on a stack of our own, however deep they lie in one another; the last one is visited next.
        std::vector<std::pair<pugi::xml_node, Transform>> waiting = {{root, transform}};
        while (!waiting.empty()) {
            const auto [node, outer] = waiting.back();
            waiting.pop_back();
            if (is_hidden(local_name(node))) continue;
            const Transform inner = outer * parsed_transform(source_, node.attribute("transform").value());
            read(node, inner);
            for (pugi::xml_node child = node.last_child(); child; child = child.previous_sibling())
                waiting.emplace_back(child, inner);
        }
        return std::move(subpaths_);
    }

private:
    // What is only defined is not seen in the picture.
    static bool is_hidden(std::string_view kind) {
        constexpr std::array<std::string_view, 6> hidden = {"defs", "clipPath", "mask", "symbol", "marker", "pattern"};
        return std::ranges::find(hidden, kind) != hidden.end();
    }

    // What is seen, but is no path: to leave it out would give another shape than that of the picture.
    void refuse_unreadable(std::string_view kind) const {
        constexpr std::array<std::string_view, 7> seen = {"rect", "circle", "ellipse", "line", "use", "text", "image"};
        if (std::ranges::find(seen, kind) == seen.end()) return;
        throw core::InputError(source_, "", "the element \"" + std::string(kind) + "\" is not read here",
                               "convert it to a path of M, L, H, V, C, S, Q, T and Z, or remove it");
    }

    void read(const pugi::xml_node& node, const Transform& transform) {
        const std::string_view kind = local_name(node);
        refuse_unreadable(kind);
        const std::size_t first = subpaths_.size();
        if (kind == "path") {
            const std::string name = next_name();
            PathReader(Numbers(source_, name, node.attribute("d").value()), name, transform, subpaths_).read();
            name_parts(first);
        } else if (kind == "polygon" || kind == "polyline") {
            const std::string name = next_name();
            Numbers numbers(source_, name, node.attribute("points").value());
            Subpath subpath{.name = name, .is_closed = kind == "polygon"};
            if (!numbers.at_end()) subpath.begin = transform * numbers.point();
            while (!numbers.at_end()) subpath.pieces.push_back({{}, transform * numbers.point()});
            if (!subpath.pieces.empty()) subpaths_.push_back(std::move(subpath));
        }
        for (std::size_t i = first; i < subpaths_.size(); ++i) require_finite(subpaths_[i]);
    }

    // The subpaths of one path.
    void name_parts(std::size_t first) {
        if (subpaths_.size() - first < 2) return;
        for (std::size_t i = first; i < subpaths_.size(); ++i)
            subpaths_[i].name += ", part " + std::to_string(i - first + 1);
    }

    // Finite numbers may be too large when they are added or transformed.
    void require_finite(const Subpath& subpath) const {
        bool is_finite = subpath.begin.allFinite();
        for (const Piece& piece : subpath.pieces) {
            is_finite = is_finite && piece.end.allFinite();
            for (const Point& control : piece.controls) is_finite = is_finite && control.allFinite();
        }
        if (!is_finite)
            throw core::InputError(source_, subpath.name, "a coordinate is too large", "scale the picture down");
    }

    static std::string_view local_name(const pugi::xml_node& node) {
        const std::string_view name = node.name();
        return name.substr(name.find(':') == std::string_view::npos ? 0 : name.find(':') + 1);
    }

    std::string next_name() { return "path " + std::to_string(++count_); }

    std::string source_;
    std::vector<Subpath> subpaths_;
    std::size_t count_ = 0;
};

Point bezier(const Point& begin, const Piece& piece, double t) {
    const double s = 1 - t;
    if (piece.controls.size() == 1) return s * s * begin + 2 * s * t * piece.controls[0] + t * t * piece.end;
    return s * s * s * begin + 3 * s * s * t * piece.controls[0] + 3 * s * t * t * piece.controls[1] +
           t * t * t * piece.end;
}

class Flattener {
public:
    Flattener(std::string source, double edge_length, double tolerance)
        : source_(std::move(source)), edge_length_(edge_length), tolerance_(tolerance) {}

    SvgPath flattened(const Subpath& subpath) {
        SvgPath path{.name = subpath.name, .points = {subpath.begin}, .is_closed = subpath.is_closed};
        for (const Piece& piece : subpath.pieces) {
            if (piece.controls.empty()) {
                path.points.push_back(piece.end);
            } else {
                append_curve(path, piece);
            }
        }
        const auto are_same = [&](const Point& p, const Point& q) { return (p - q).stableNorm() <= tolerance_; };
        const auto repeated = std::ranges::unique(path.points, are_same);
        path.points.erase(repeated.begin(), repeated.end());
        if (path.points.size() > 1 && are_same(path.points.front(), path.points.back())) {
            path.points.pop_back();
            path.is_closed = true;
        }
        return path;
    }

private:
    // Places along a curve at even distances, which are taken from a table of its length.
    void append_curve(SvgPath& path, const Piece& piece) {
        constexpr std::size_t samples = 256;
        const Point begin = path.points.back();
        std::array<double, samples + 1> length{};
        Point last = begin;
        for (std::size_t i = 1; i <= samples; ++i) {
            const Point place = bezier(begin, piece, static_cast<double>(i) / samples);
            length[i] = length[i - 1] + (place - last).stableNorm();
            last = place;
        }
        const double whole = length.back();
        const std::size_t chords = chord_count(path.name, whole);
        for (std::size_t k = 1, i = 1; k < chords; ++k) {
            const double wanted = whole * (static_cast<double>(k) / static_cast<double>(chords));
            while (length[i] < wanted) ++i;
            const double share = (wanted - length[i - 1]) / (length[i] - length[i - 1]);
            path.points.push_back(bezier(begin, piece, (static_cast<double>(i - 1) + share) / samples));
        }
        path.points.push_back(piece.end);
    }

    // A curve that stays in one place has one chord, of no length.
    std::size_t chord_count(const std::string& name, double length) {
        const double count = length > 0 ? std::ceil(length / edge_length_) : 1;
        chords_ += count;
        if (!(chords_ <= most_chords))
            throw core::InputError(source_, name, "its curves have more than a million chords of the edge length",
                                   "give a greater edge length");
        return static_cast<std::size_t>(count);
    }

    std::string source_;
    double edge_length_, tolerance_;
    double chords_ = 0;  ///< so far, in all
};

}  // namespace

std::vector<SvgPath> read_svg_paths(const std::filesystem::path& path, std::optional<double> edge_length) {
    const std::string text = read_file(path);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    if (!parsed)
        throw core::InputError(path.string(), "character " + std::to_string(parsed.offset + 1), parsed.description(),
                               "give an SVG file");
    Transform upward = Transform::Identity();
    upward.linear()(1, 1) = -1;
    const std::vector<Subpath> subpaths = Collector(path.string()).run(document.document_element(), upward);
    if (subpaths.empty())
        throw core::InputError(path.string(), "", "there is no path", "give a picture with closed paths");
    // With the control points, as a curve may end where it begins.
    Eigen::AlignedBox2d box;
    for (const Subpath& subpath : subpaths) {
        box.extend(subpath.begin);
        for (const Piece& piece : subpath.pieces) {
            box.extend(piece.end);
            for (const Point& control : piece.controls) box.extend(control);
        }
    }
    const double size = box.sizes().maxCoeff();
    Flattener flattener(path.string(), edge_length.value_or(size / chords_of_size), size * same_place);
    std::vector<SvgPath> result;
    for (const Subpath& subpath : subpaths) result.push_back(flattener.flattened(subpath));
    return result;
}

}  // namespace dsc::io
