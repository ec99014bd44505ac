// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cutlocus/picture/chart_canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/number.h"

namespace dsc::cutlocus {

using geodesic::Point2;
using geodesic::Vector2;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double thinning = 0.2;  // px
constexpr double left_margin = 58, right_margin = 20, gap = 26, heading_height = 34, title_height = 34;
constexpr double axis_height = 34, legend_row_height = 22;
constexpr double text_size = 15, legend_text_size = 14, title_size = 17;
const io::SvgStyle ink{.stroke = "#202020", .stroke_width = 1};

// Hundredths of a pixel: shorter texts, nothing to be seen.
Point2 rounded(const Point2& x) { return {std::round(100 * x.x()) / 100, std::round(100 * x.y()) / 100}; }

bool is_full_turn(const std::optional<double>& period) { return period && std::abs(*period - 2 * pi) < 1e-9; }

double text_width(std::string_view text, double size) {
    const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
    return 0.56 * size * static_cast<double>(letters);
}

std::string minus_signs(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '-' ? "−" : std::string(1, c);
    return result;
}

/// Quarters of a full turn: "−π/2".
std::string quarter_name(int quarters) {
    const std::string sign = quarters < 0 ? "−" : "";
    const int size = std::abs(quarters);
    if (size == 0) return "0";
    const std::string half = size % 2 == 0 ? "" : "/2";
    const int factor = size % 2 == 0 ? size / 2 : size;
    return sign + (factor == 1 ? "" : std::to_string(factor)) + "π" + half;
}

}  // namespace

std::string coordinate_text(double value, const std::optional<double>& period) {
    if (is_full_turn(period)) {
        const double thousandths = std::round(1000 * value / pi);
        if (std::abs(value - thousandths * pi / 1000) < 1e-7) {
            if (thousandths == 0) return "0";
            const double share = thousandths / 1000;
            const std::string factor = std::abs(share) == 1 ? (share < 0 ? "-" : "") : io::number_text(share, 4);
            return minus_signs(factor + "π");
        }
    }
    return minus_signs(io::number_text(std::abs(value) < 1e-7 * period.value_or(0) ? 0 : value, 6));
}

std::string point_text(const Point2& x, const geodesic::ChartPeriods& periods) {
    return "(" + coordinate_text(x.x(), periods.u) + ", " + coordinate_text(x.y(), periods.v) + ")";
}

ChartCanvas::Measures::Measures(const ChartBox& box, const Layout& layout) {
    const Vector2 size = box.upper() - box.lower();
    const double width = (layout.width - gap * (layout.columns - 1)) / layout.columns;
    scale = width / (layout.columns == 1 ? size.maxCoeff() : size.x());
    chart = scale * size;
    const double rows = layout.rows;
    const double heading = layout.columns * layout.rows > 1 ? heading_height : 0;
    picture = {left_margin + layout.columns * chart.x() + gap * (layout.columns - 1) + right_margin, 0};
    // A narrow picture needs more rows for the 660 px that the longest legend takes.
    constexpr double longest_legend = 660;
    legend = 12 + legend_row_height * std::ceil(longest_legend / (picture.x() - 12));
    picture.y() = (layout.title.empty() ? 14 : title_height) + rows * (chart.y() + heading) + axis_height + legend;
}

ChartCanvas::ChartCanvas(const ChartBox& box, const Layout& layout)
    : box_(box),
      layout_(layout),
      measures_(box, layout),
      picture_({0, 0}, measures_.picture, measures_.picture.x(), 0) {
    if (layout.title.empty()) return;
    picture_.title(layout.title);
    picture_.begin_group("title", {.fill = "#000000"});
    const double width = measures_.picture.x() - 12;
    const double size = std::min(title_size, title_size * width / text_width(layout.title, title_size));
    picture_.label({measures_.picture.x() / 2, measures_.picture.y() - 0.66 * title_height}, layout.title, size,
                   io::SvgAnchor::middle);
    picture_.end_group();
}

Point2 ChartCanvas::pixel(const Point2& x) const { return rounded(corner_ + measures_.scale * (x - box_.lower())); }

void ChartCanvas::begin_chart(int index, std::string_view heading) {
    const int column = index % layout_.columns, row = index / layout_.columns;
    const double heading_space = layout_.columns * layout_.rows > 1 ? heading_height : 0;
    corner_ = {left_margin + column * (measures_.chart.x() + gap),
               measures_.legend + axis_height + (layout_.rows - 1 - row) * (measures_.chart.y() + heading_space)};
    axes(row == layout_.rows - 1, column == 0);
    if (heading.empty()) return;
    picture_.begin_group("heading", {.fill = "#000000"});
    picture_.label(corner_ + Vector2(measures_.chart.x() / 2, measures_.chart.y() + 7), heading, text_size,
                   io::SvgAnchor::middle);
    picture_.end_group();
}

void ChartCanvas::axes(bool has_u, bool has_v) {
    picture_.begin_group("axes", {.stroke = ink.stroke, .stroke_width = ink.stroke_width, .fill = "none"});
    const Point2 opposite = corner_ + measures_.chart;
    picture_.polygon(std::vector<Point2>{corner_, {opposite.x(), corner_.y()}, opposite, {corner_.x(), opposite.y()}});
    picture_.end_group();
    picture_.begin_group("ticks", {.stroke = ink.stroke, .stroke_width = ink.stroke_width, .fill = "#202020"});
    for (int axis = 0; axis < 2; ++axis) {
        const bool is_labelled = axis == 0 ? has_u : has_v;
        const double lower = box_.lower()[axis], upper = box_.upper()[axis], slack = 1e-9 * (upper - lower);
        const bool is_turn = is_full_turn(axis == 0 ? box_.periods().u : box_.periods().v);
        const double step = is_turn ? pi / 2 : round_step((upper - lower) / 6);
        const int first = static_cast<int>(std::ceil((lower - slack) / step));
        for (int i = first; i * step <= upper + slack; ++i)
            tick(axis, i * step, is_turn ? quarter_name(i) : minus_signs(io::number_text(i * step, 6)), is_labelled);
        if (!is_labelled) continue;
        // The name of the axis stands between two ticks.
        Point2 at = corner_;
        at[axis] += measures_.scale * (step * (std::floor((lower + upper) / (2 * step) + 1e-9) + 0.5) - lower);
        if (axis == 0)
            picture_.label(at, "u", text_size, io::SvgAnchor::middle, {0, -20});
        else
            picture_.label(at, "v", text_size, io::SvgAnchor::end, {-12, -5});
    }
    picture_.end_group();
}

void ChartCanvas::tick(int axis, double value, const std::string& name, bool is_labelled) {
    constexpr double length = 5;
    Point2 at = corner_;
    at[axis] += measures_.scale * (value - box_.lower()[axis]);
    at = rounded(at);
    Vector2 out(0, 0);
    out[1 - axis] = -length;
    picture_.line(std::vector<Point2>{at, at + out});
    if (!is_labelled) return;
    if (axis == 0)
        picture_.label(at, name, text_size, io::SvgAnchor::middle, {0, -20});
    else
        picture_.label(at, name, text_size, io::SvgAnchor::end, {-9, -5});
}

void ChartCanvas::lines(std::string_view name, const io::SvgStyle& style, const std::vector<Polyline>& lines,
                        bool is_wrapped) {
    io::SvgStyle unfilled = style;
    unfilled.fill = "none";
    picture_.begin_group(name, unfilled);
    const double longest = measures_.chart.minCoeff() / 12;
    for (const Polyline& line : lines) {
        for (const Polyline& piece : is_wrapped ? box_.pieces(line) : box_.clipped(line)) {
            Polyline drawn;
            for (const Point2& x : piece) drawn.push_back(corner_ + measures_.scale * (x - box_.lower()));
            drawn = thinned(drawn, thinning, longest);
            for (Point2& x : drawn) x = rounded(x);
            picture_.line(drawn);
        }
    }
    picture_.end_group();
}

void ChartCanvas::marks(std::string_view name, const MarkStyle& style, const std::vector<Point2>& points) {
    picture_.begin_group(name, {});
    for (const Point2& point : points)
        for (const Point2& place : box_.places(point)) mark(pixel(place), style);
    picture_.end_group();
}

void ChartCanvas::mark(const Point2& at, const MarkStyle& style) {
    const double r = style.size;
    switch (style.shape) {
        case MarkShape::dot: picture_.dot(at, r, {.fill = style.colour}); break;
        case MarkShape::ring:
            picture_.dot(at, r, {.stroke = style.colour, .stroke_width = 1.5, .fill = "#ffffff"});
            break;
        case MarkShape::square:
            picture_.polygon(
                std::vector<Point2>{at + Vector2(-r, -r), at + Vector2(r, -r), at + Vector2(r, r), at + Vector2(-r, r)},
                {.fill = style.colour});
            break;
    }
}

void ChartCanvas::legend_line(std::string_view name, const io::SvgStyle& style) {
    entries_.push_back({std::string(name), false, style, {}});
}
void ChartCanvas::legend_mark(std::string_view name, const MarkStyle& style) {
    entries_.push_back({std::string(name), true, {}, style});
}

namespace {

constexpr double line_symbol = 26, mark_symbol = 12, symbol_to_text = 6, entry_to_entry = 20;

double legend_width(std::string_view name, bool is_mark) {
    return (is_mark ? mark_symbol : line_symbol) + symbol_to_text + text_width(name, legend_text_size);
}

}  // namespace

std::vector<std::vector<ChartCanvas::LegendEntry>> ChartCanvas::legend_rows() const {
    std::vector<std::vector<LegendEntry>> rows(1);
    double used = 0;
    for (const LegendEntry& entry : entries_) {
        const double width = legend_width(entry.name, entry.is_mark);
        if (used > 0 && used + width > measures_.picture.x() - 12) {
            rows.emplace_back();
            used = 0;
        }
        rows.back().push_back(entry);
        used += width + entry_to_entry;
    }
    return rows;
}

void ChartCanvas::legend() {
    picture_.begin_group("legend", {.fill = "#000000"});
    double y = measures_.legend - legend_row_height / 2;
    for (const std::vector<LegendEntry>& row : legend_rows()) {
        double total = -entry_to_entry;
        for (const LegendEntry& entry : row) total += legend_width(entry.name, entry.is_mark) + entry_to_entry;
        double x = std::max(6.0, (left_margin + measures_.picture.x() - right_margin - total) / 2);
        x = std::max(6.0, std::min(x, measures_.picture.x() - 6 - total));
        for (const LegendEntry& entry : row) {
            const double symbol = entry.is_mark ? mark_symbol : line_symbol;
            if (entry.is_mark)
                mark({x + symbol / 2, y}, entry.mark);
            else
                picture_.line(std::vector<Point2>{{x, y}, {x + symbol, y}}, entry.line);
            picture_.label({x + symbol + symbol_to_text, y}, entry.name, legend_text_size, io::SvgAnchor::start,
                           {0, -5});
            x += legend_width(entry.name, entry.is_mark) + entry_to_entry;
        }
        y -= legend_row_height;
    }
    picture_.end_group();
}

std::string ChartCanvas::text() {
    if (!entries_.empty()) legend();
    return picture_.text();
}

}  // namespace dsc::cutlocus
