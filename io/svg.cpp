// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg.h"

#include <cmath>

#include "core/assert.h"
#include "io/number.h"
#include "io/xml.h"

namespace dsc::io {

namespace {

// A thousandth of a pixel in pictures of up to 10000 px.
constexpr int picture_digits = 7;

std::string px(double value) { return number_text(std::abs(value) < 1e-4 ? 0.0 : value, picture_digits); }

std::string attributes(const SvgStyle& style) {
    std::string text;
    if (!style.stroke.empty()) text += " stroke=\"" + xml_escaped(style.stroke) + "\"";
    if (style.stroke_width > 0) text += " stroke-width=\"" + px(style.stroke_width) + "\"";
    if (!style.fill.empty()) text += " fill=\"" + xml_escaped(style.fill) + "\"";
    if (style.opacity < 1) text += " opacity=\"" + px(style.opacity) + "\"";
    if (!style.dash.empty()) text += " stroke-dasharray=\"" + xml_escaped(style.dash) + "\"";
    return text;
}

}  // namespace

Svg::Svg(const Eigen::Vector2d& lower, const Eigen::Vector2d& upper, double width, double margin)
    : lower_(lower), upper_(upper), scale_(width / (upper - lower).x()), margin_(margin) {
    DSC_ASSERT((upper - lower).minCoeff() > 0 && width > 0 && margin >= 0);
}

Eigen::Vector2d Svg::pixel(const Eigen::Vector2d& point) const {
    return {margin_ + scale_ * (point.x() - lower_.x()), margin_ + scale_ * (upper_.y() - point.y())};
}

void Svg::begin_group(std::string_view name, const SvgStyle& style) {
    body_ += "<g data-name=\"" + xml_escaped(name) + "\"" + attributes(style) + ">\n";
    ++open_groups_;
}

void Svg::begin_clipped_group(std::string_view name, const SvgStyle& style) {
    body_ += "<g data-name=\"" + xml_escaped(name) + "\" clip-path=\"url(#box)\"" + attributes(style) + ">\n";
    ++open_groups_;
}

void Svg::end_group() {
    DSC_ASSERT(open_groups_ > 0);
    body_ += "</g>\n";
    --open_groups_;
}

void Svg::append_path(std::span<const Eigen::Vector2d> points, bool is_closed, const SvgStyle& style) {
    std::string data;
    bool is_pen_down = false;
    for (const Eigen::Vector2d& point : points) {
        const Eigen::Vector2d p = pixel(point);
        if (!p.allFinite()) {
            is_pen_down = false;
            continue;
        }
        data += (is_pen_down ? "L" : "M") + px(p.x()) + " " + px(p.y());
        is_pen_down = true;
    }
    if (data.empty()) return;
    body_ += "<path d=\"" + data + (is_closed ? "Z" : "") + "\"" + attributes(style) + "/>\n";
}

void Svg::line(std::span<const Eigen::Vector2d> points, const SvgStyle& style) {
    SvgStyle open = style;
    if (open.fill.empty()) open.fill = "none";
    append_path(points, false, open);
}

void Svg::polygon(std::span<const Eigen::Vector2d> points, const SvgStyle& style) { append_path(points, true, style); }

void Svg::circle(const Eigen::Vector2d& center, double radius, const SvgStyle& style) {
    dot(center, radius * scale_, style);
}

void Svg::dot(const Eigen::Vector2d& center, double radius, const SvgStyle& style) {
    const Eigen::Vector2d p = pixel(center);
    if (!p.allFinite()) return;
    body_ += "<circle cx=\"" + px(p.x()) + "\" cy=\"" + px(p.y()) + "\" r=\"" + px(radius) + "\"" + attributes(style) +
             "/>\n";
}

void Svg::label(const Eigen::Vector2d& position, std::string_view text, double size, SvgAnchor anchor,
                const Eigen::Vector2d& offset) {
    static constexpr const char* anchors[] = {"start", "middle", "end"};
    const Eigen::Vector2d p = pixel(position);
    if (!p.allFinite()) return;
    body_ += "<text x=\"" + px(p.x() + offset.x()) + "\" y=\"" + px(p.y() - offset.y()) + "\" font-size=\"" + px(size) +
             "\" text-anchor=\"" + anchors[static_cast<int>(anchor)] + "\" stroke=\"none\">" + xml_escaped(text) +
             "</text>\n";
}

void Svg::title(std::string_view text) { title_ = text; }

std::string Svg::text() const {
    DSC_ASSERT(open_groups_ == 0);
    const Eigen::Vector2d box = scale_ * (upper_ - lower_);
    const std::string width = px(box.x() + 2 * margin_);
    const std::string height = px(box.y() + 2 * margin_);
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width +
        "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height +
        "\" font-family=\"sans-serif\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    if (!title_.empty()) text += "<title>" + xml_escaped(title_) + "</title>\n";
    text += "<defs><clipPath id=\"box\"><rect x=\"" + px(margin_) + "\" y=\"" + px(margin_) + "\" width=\"" +
            px(box.x()) + "\" height=\"" + px(box.y()) + "\"/></clipPath></defs>\n";
    text += "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    return text + body_ + "</svg>\n";
}

}  // namespace dsc::io
