// SPDX-License-Identifier: GPL-3.0-or-later
// A 2D picture in user coordinates (x to the right, y up), written as SVG.
// Lengths of the picture itself (line widths, text sizes, dots, margin) are in pixels, everything else in user units.
// Guarantee: well-formed XML whatever the texts contain; points that are not finite interrupt a line.
//
//     io::Svg picture({-pi, -pi}, {pi, pi});
//     picture.begin_group("cut locus", {.stroke = "#c00000", .stroke_width = 2});
//     picture.line(points);
//     picture.end_group();
//     io::write_file("locus.svg", picture.text());
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dsc::io {

/// Empty colours and zero sizes are inherited from the group.
struct SvgStyle {
    std::string stroke;       ///< CSS colour or "none"
    double stroke_width = 0;  ///< px
    std::string fill;         ///< CSS colour or "none"
    double opacity = 1;       ///< in [0, 1]
    std::string dash;         ///< lengths of strokes and gaps in px, "4 2"
};

enum class SvgAnchor { start, middle, end };

class Svg {
public:
    /// A picture of the box [lower, upper] that is `width` px wide, without the `margin` on each side.
    Svg(const Eigen::Vector2d& lower, const Eigen::Vector2d& upper, double width = 800, double margin = 40);

    void begin_group(std::string_view name, const SvgStyle& style);
    /// A group of which only what lies in the box of the picture is seen.
    void begin_clipped_group(std::string_view name, const SvgStyle& style);
    void end_group();

    void line(std::span<const Eigen::Vector2d> points, const SvgStyle& style = {});
    void polygon(std::span<const Eigen::Vector2d> points, const SvgStyle& style = {});
    void circle(const Eigen::Vector2d& center, double radius, const SvgStyle& style = {});
    /// A circle of `radius` px, whatever the scale.
    void dot(const Eigen::Vector2d& center, double radius, const SvgStyle& style = {});
    /// `offset` moves the text in px (x to the right, y up).
    void label(const Eigen::Vector2d& position, std::string_view text, double size = 14,
               SvgAnchor anchor = SvgAnchor::start, const Eigen::Vector2d& offset = Eigen::Vector2d::Zero());
    void title(std::string_view text);

    /// The whole document; all groups have to be ended.
    std::string text() const;

private:
    void append_path(std::span<const Eigen::Vector2d> points, bool is_closed, const SvgStyle& style);
    Eigen::Vector2d pixel(const Eigen::Vector2d& point) const;

    Eigen::Vector2d lower_, upper_;
    double scale_;
    double margin_;
    int open_groups_ = 0;
    std::string title_;
    std::string body_;
};

}  // namespace dsc::io
