// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of one chart, or of several charts side by side: frames with ticks, lines cut at the seams and thinned to
// what can be seen in print, marks, headings and a legend.
//
// Guarantee: everything lies in the picture; points of lines are within 0.2 px of where they belong.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "apps/cutlocus/picture/chart_box.h"
#include "io/svg.h"

namespace dsc::cutlocus {

enum class MarkShape { dot, ring, square };

struct MarkStyle {
    MarkShape shape = MarkShape::dot;
    std::string colour = "#000000";
    double size = 3.5;  ///< half the width, px
};

class ChartCanvas {
public:
    struct Layout {
        int columns = 1, rows = 1;
        double width = 800;  ///< of all charts without margins, px; the larger side of a chart when there is one only
        std::string title;   ///< may be empty
    };
    ChartCanvas(const ChartBox& box, const Layout& layout);

    /// What is drawn from now on goes into this chart, counted row by row. Charts of a row share the axis of its first.
    void begin_chart(int index, std::string_view heading = {});
    /// Lines of the universal cover, wrapped into the chart; or clipped as they are.
    void lines(std::string_view name, const io::SvgStyle& style, const std::vector<Polyline>& lines,
               bool is_wrapped = true);
    void marks(std::string_view name, const MarkStyle& style, const std::vector<geodesic::Point2>& points);

    void legend_line(std::string_view name, const io::SvgStyle& style);
    void legend_mark(std::string_view name, const MarkStyle& style);

    /// The picture as SVG, with the legend. To be called once.
    std::string text();

private:
    struct LegendEntry {
        std::string name;
        bool is_mark;
        io::SvgStyle line;
        MarkStyle mark;
    };

    struct Measures {
        Measures(const ChartBox& box, const Layout& layout);
        double scale = 1;                // px per unit of the chart
        geodesic::Point2 chart{0, 0};    // px
        geodesic::Point2 picture{0, 0};  // px
        double legend = 0;               // px, its height
    };

    geodesic::Point2 pixel(const geodesic::Point2& x) const;
    void axes(bool has_u, bool has_v);
    void tick(int axis, double value, const std::string& name, bool is_labelled);
    void mark(const geodesic::Point2& at, const MarkStyle& style);
    std::vector<std::vector<LegendEntry>> legend_rows() const;
    void legend();

    ChartBox box_;
    Layout layout_;
    Measures measures_;
    io::Svg picture_;
    geodesic::Point2 corner_{0, 0};  // lower left corner of the present chart, px
    std::vector<LegendEntry> entries_;
};

/// A coordinate as people write it: "0.2π" in a period of 2π, "1.25" elsewhere.
std::string coordinate_text(double value, const std::optional<double>& period);
/// "(0, 0.2π)"
std::string point_text(const geodesic::Point2& x, const geodesic::ChartPeriods& periods);

}  // namespace dsc::cutlocus
