// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/improve/histogram_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>

#include "core/assert.h"
#include "io/svg.h"

namespace dsc::improve {

using Eigen::Vector2d;
using io::Svg;
using io::SvgAnchor;

namespace {

constexpr std::size_t bins = 90;
constexpr double margin = 12, title_height = 20, bar_height = 100, axis_height = 26;
constexpr double panel_height = title_height + bar_height + axis_height;
constexpr double text_size = 11;

// The highest bar of a mesh without up to four that are more than twice as high as all its others: a mesh made of a few
// shapes has a few angles very often. 0 when there are no others.
double highest_ordinary_share(std::vector<double> values) {
    constexpr std::size_t most_exceptions = 4;
    std::ranges::sort(values, std::greater());
    const double towering = 2 * values[most_exceptions];
    const auto ordinary = std::ranges::find_if(values, [&](double value) { return value <= towering; });
    return towering > 0 ? *ordinary : 0;
}

// The share that a bar of full height stands for.
double share_of_full_height(const std::vector<AngleHistogram>& histograms) {
    double highest = 0, ordinary = 0;
    for (const AngleHistogram& histogram : histograms) {
        const std::vector<double> values = angle_shares(histogram.statistics, bins);
        highest = std::max(highest, std::ranges::max(values));
        ordinary = std::max(ordinary, highest_ordinary_share(values));
    }
    return ordinary > 0 ? ordinary : highest;
}

std::string title(const AngleHistogram& histogram) {
    const MeshStatistics& mesh = histogram.statistics;
    return fmt::format("{}: {:.2f}° to {:.2f}°, {} tetrahedra", histogram.name, mesh.smallest_angle, mesh.largest_angle,
                       mesh.tets);
}

// One histogram, its axis at height `base` of a picture whose unit is a pixel.
class Panel {
public:
    Panel(Svg& picture, double width, double base, double highest)
        : picture_(picture), degree_(width / 180), base_(base), highest_(highest) {}

    void draw(const AngleHistogram& histogram) {
        picture_.label({0, base_ + bar_height + 8}, title(histogram), text_size);
        const std::vector<double> share = angle_shares(histogram.statistics, bins);
        picture_.begin_group(histogram.name, {.stroke = "none", .fill = "#4a7ab5"});
        for (std::size_t i = 0; i < share.size(); ++i) bar(i, share[i]);
        picture_.end_group();
        axis();
    }

private:
    static constexpr double bin_degrees = 180.0 / bins;

    void bar(std::size_t bin, double share) {
        if (share == 0) return;
        const bool is_cut = share > highest_;
        const double left = degree_ * bin_degrees * static_cast<double>(bin),
                     right = left + 0.85 * degree_ * bin_degrees;
        const double top = base_ + bar_height * std::min(share / highest_, 1.0);
        const std::vector<Vector2d> outline{{left, base_}, {right, base_}, {right, top}, {left, top}};
        picture_.polygon(outline, {.fill = is_cut ? "#c62f2f" : ""});
        // Where such bars stand side by side, the first one has the room for its share.
        if (!is_cut || left < label_end_) return;
        picture_.label({right, base_ + bar_height}, fmt::format("{:.0f} %", 100 * share), text_size - 2,
                       SvgAnchor::start, {2, -8});
        label_end_ = right + 30;
    }

    void axis() {
        picture_.begin_group("axis", {.stroke = "#555555", .stroke_width = 1});
        picture_.line(std::vector<Vector2d>{{0, base_}, {180 * degree_, base_}});
        for (int angle = 0; angle <= 180; angle += 30) {
            const double x = degree_ * angle;
            picture_.line(std::vector<Vector2d>{{x, base_}, {x, base_ - 4}});
            const SvgAnchor anchor = angle == 0 ? SvgAnchor::start : angle == 180 ? SvgAnchor::end : SvgAnchor::middle;
            picture_.label({x, base_ - 15}, std::to_string(angle) + "°", text_size - 1, anchor);
        }
        picture_.end_group();
    }

    Svg& picture_;
    double degree_;  // px
    double base_;
    double highest_;  // share of a bar of full height
    double label_end_ = 0;
};

}  // namespace

std::string histogram_picture(const std::vector<AngleHistogram>& histograms, double width) {
    DSC_ASSERT(!histograms.empty());
    const double highest = share_of_full_height(histograms);
    const double inner = width - 2 * margin, height = panel_height * static_cast<double>(histograms.size());
    Svg picture({0, 0}, {inner, height}, inner, margin);
    picture.title("Dihedral angles");
    double top = height;
    for (const AngleHistogram& histogram : histograms) {
        Panel(picture, inner, top - title_height - bar_height, highest).draw(histogram);
        top -= panel_height;
    }
    return picture.text();
}

}  // namespace dsc::improve
