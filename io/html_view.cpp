// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/html_view.h"

#include <cmath>
#include <span>

#include "core/assert.h"
#include "io/atomic_file.h"
#include "io/json.h"
#include "io/number.h"
#include "io/view/assets.h"
#include "io/xml.h"

namespace dsc::io {

namespace {

constexpr int view_digits = 7;
constexpr int value_digits = 4;  // of a cell: a colour, and a figure to read

// Coordinates go straight to text: a scene has millions of them, too many for a tree of JSON values.
void append_coordinates(std::string& text, std::span<const Eigen::Vector3d> points) {
    text += '[';
    for (const Eigen::Vector3d& point : points) {
        for (const double x : point) {
            if (std::isfinite(x)) {
                append_number(text, x, view_digits);
            } else {
                text += "null";
            }
            text += ',';
        }
    }
    if (text.back() == ',') text.pop_back();
    text += ']';
}

template <class Range, class Function>
void append_list(std::string& text, const Range& range, Function&& append_element) {
    text += '[';
    bool is_first = true;
    for (const auto& element : range) {
        if (!is_first) text += ",\n";
        is_first = false;
        append_element(element);
    }
    text += ']';
}

void append_lines(std::string& text, const std::vector<ViewLine>& lines) {
    append_list(text, lines, [&](const ViewLine& line) { append_coordinates(text, line); });
}

std::string quoted(const std::string& text) { return Json(text).dump(); }

std::string texts(const std::vector<std::string>& values) {
    return Json::array(Json::Array(values.begin(), values.end())).dump();
}

std::string numbers(std::span<const double> values) { return Json(values).dump(-1, view_digits); }

// The members that every kind of item has; leaves the object open.
void begin_item(std::string& text, const std::string& name, const std::string& colour, bool is_visible) {
    text += "{\"name\":" + quoted(name) + ",\"colour\":" + quoted(colour) +
            ",\"visible\":" + (is_visible ? "true" : "false");
}

// Index tuples as one flat list.
template <class Tuples>
void append_indices(std::string& text, const Tuples& tuples) {
    text += '[';
    for (const auto& tuple : tuples) {
        for (const std::uint32_t v : tuple) text += std::to_string(v) + ",";
    }
    if (text.back() == ',') text.pop_back();
    text += ']';
}

void append(std::string& text, const ViewSurface& surface) {
    DSC_ASSERT(surface.colours.empty() || surface.colours.size() == surface.vertices.size());
    begin_item(text, surface.name, surface.colour, true);
    text += ",\"opacity\":" + number_text(surface.opacity) + ",\"edges\":" + (surface.shows_edges ? "true" : "false") +
            ",\"vertices\":";
    append_coordinates(text, surface.vertices);
    text += ",\"triangles\":";
    append_indices(text, surface.triangles);
    text += ",\"colours\":";
    append_coordinates(text, surface.colours);
    text += '}';
}

void append(std::string& text, const ViewTets& tets) {
    DSC_ASSERT(tets.values.size() == tets.tets.size() && tets.worst != tets.best);
    text += "{\"name\":" + quoted(tets.name) + ",\"valueName\":" + quoted(tets.value_name) +
            ",\"worst\":" + number_text(tets.worst) + ",\"best\":" + number_text(tets.best) +
            ",\"edges\":" + (tets.shows_edges ? "true" : "false") + ",\"vertices\":";
    append_coordinates(text, tets.vertices);
    text += ",\"tets\":";
    append_indices(text, tets.tets);
    text += ",\"values\":" + Json(tets.values).dump(-1, value_digits) + "}";
}

void append(std::string& text, const ViewLines& lines) {
    begin_item(text, lines.name, lines.colour, lines.is_visible);
    text += ",\"width\":" + number_text(lines.width) + ",\"lines\":";
    append_lines(text, lines.lines);
    text += '}';
}

void append(std::string& text, const ViewPoints& points) {
    DSC_ASSERT(points.labels.empty() || points.labels.size() == points.positions.size());
    begin_item(text, points.name, points.colour, points.is_visible);
    text += ",\"size\":" + number_text(points.size) + ",\"labels\":" + texts(points.labels) + ",\"positions\":";
    append_coordinates(text, points.positions);
    text += '}';
}

void append(std::string& text, const ViewSeries& series) {
    DSC_ASSERT(series.times.size() == series.frames.size());
    begin_item(text, series.name, series.colour, series.is_visible);
    text += ",\"width\":" + number_text(series.width) + ",\"times\":" + numbers(series.times) + ",\"frames\":";
    append_list(text, series.frames, [&](const std::vector<ViewLine>& frame) { append_lines(text, frame); });
    text += '}';
}

void append(std::string& text, const ViewSurfaceFrame& frame) {
    text += "{\"vertices\":";
    append_coordinates(text, frame.vertices);
    text += ",\"triangles\":";
    append_indices(text, frame.triangles);
    text += '}';
}

void append(std::string& text, const ViewSurfaceSeries& series) {
    DSC_ASSERT(series.times.size() == series.frames.size());
    begin_item(text, series.name, series.colour, series.is_visible);
    text += ",\"opacity\":" + number_text(series.opacity) + ",\"edges\":" + (series.shows_edges ? "true" : "false") +
            ",\"times\":" + numbers(series.times) + ",\"frames\":";
    append_list(text, series.frames, [&](const ViewSurfaceFrame& frame) { append(text, frame); });
    text += '}';
}

void append(std::string& text, const ViewFan& fan) {
    DSC_ASSERT(fan.values.size() == fan.rays.size() && fan.labels.size() == fan.rays.size());
    begin_item(text, fan.name, fan.colour, true);
    text += ",\"width\":" + number_text(fan.width) + ",\"valueName\":" + quoted(fan.value_name) +
            ",\"labels\":" + texts(fan.labels) + ",\"values\":";
    append_list(text, fan.values, [&](const std::vector<double>& values) { text += numbers(values); });
    text += ",\"rays\":";
    append_lines(text, fan.rays);
    text += '}';
}

template <class Item>
void append_optional(std::string& text, const std::optional<Item>& item) {
    if (item) {
        append(text, *item);
    } else {
        text += "null";
    }
}

void append(std::string& text, const HtmlView& view) {
    const auto append_item = [&](const auto& item) { append(text, item); };
    text += "{\"name\":" + quoted(view.name) + ",\"flat\":" + (view.is_flat ? "true" : "false") + ",\n\"surfaces\":";
    append_list(text, view.surfaces, append_item);
    text += ",\n\"tets\":";
    append_optional(text, view.tets);
    text += ",\n\"lines\":";
    append_list(text, view.lines, append_item);
    text += ",\n\"points\":";
    append_list(text, view.points, append_item);
    text += ",\n\"series\":";
    append_list(text, view.series, append_item);
    text += ",\n\"surfaceSeries\":";
    append_list(text, view.surface_series, append_item);
    text += ",\n\"fan\":";
    append_optional(text, view.fan);
    text += "}";
}

std::string scene_json(const HtmlPage& page) {
    std::string text = "{\"title\":" + quoted(page.title) + ",\"timeName\":" + quoted(page.time_name) +
                       ",\"sharesCamera\":" + (page.shares_camera ? "true" : "false") +
                       ",\"figure\":" + quoted(page.figure) + ",\"facts\":";
    append_list(text, page.facts, [&](const auto& fact) { text += texts({fact.first, fact.second}); });
    text += ",\n\"views\":";
    append_list(text, page.views, [&](const HtmlView& view) { append(text, view); });
    return text + "}";
}

std::string replaced(std::string_view text, std::string_view what, std::string_view with) {
    std::string result;
    std::size_t begin = 0;
    for (std::size_t found = 0; (found = text.find(what, begin)) != std::string_view::npos;
         begin = found + what.size()) {
        result.append(text.substr(begin, found - begin)).append(with);
    }
    return result.append(text.substr(begin));
}

// Inside a script element only "</script" and "<!--" mean something to HTML. Both can occur in JavaScript only in
// strings, patterns and comments, where the backslash changes nothing.
std::string script_element(std::string_view script) {
    return "<script>\n" + replaced(replaced(script, "</script", "<\\/script"), "<!--", "<\\!--") + "\n</script>\n";
}

constexpr std::string_view three_notice =
    R"(/*! three.js and its examples OrbitControls and LineSegments2, https://threejs.org
The MIT License. Copyright (c) 2010-2019 three.js authors
Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:
The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.
THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE. */
)";

}  // namespace

std::string html_page(const HtmlPage& page) {
    std::string text =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
        "style-src 'unsafe-inline'; img-src data: blob:\">\n";
    text += "<title>" + xml_escaped(page.title) + "</title>\n";
    text += "<style>\n" + std::string(assets::style()) + "</style>\n</head>\n<body>\n";
    text += "<main id=\"canvas\"></main>\n<aside id=\"panel\"><h1>" + xml_escaped(page.title) +
            "</h1><div id=\"views\"></div><div id=\"cut\"></div><table id=\"facts\"></table><div id=\"figure\"></div>"
            "<div id=\"time\"></div><div id=\"legend\"></div><div id=\"picked\"></div><p id=\"help\"></p></aside>\n";
    // In JSON '<' occurs in strings only, where it can be written as an escape.
    text +=
        "<script type=\"application/json\" id=\"scene\">" + replaced(scene_json(page), "<", "\\u003c") + "</script>\n";
    text += script_element(std::string(three_notice) + std::string(assets::three()));
    text += script_element(assets::orbit_controls());
    text += script_element(assets::line_segments_geometry());
    text += script_element(assets::line_material());
    text += script_element(assets::line_segments());
    text += script_element(assets::tets());
    text += script_element(assets::viewer());
    if (!page.script.empty()) text += script_element(page.script);
    return text + "</body>\n</html>\n";
}

void write_html_page(const std::filesystem::path& path, const HtmlPage& page) { write_file(path, html_page(page)); }

}  // namespace dsc::io
