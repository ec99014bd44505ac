// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc2d/generate/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/errors.h"

namespace dsc::dsc2d {

namespace {

using std::numbers::pi;

void require_shape(bool is_valid, const char* shape, const char* range) {
    if (!is_valid) throw core::UsageError(std::string(shape) + ": " + range);
}

void require_length(const char* shape, double edge_length, double size) {
    require_shape(edge_length > 0 && std::isfinite(edge_length), shape, "the edge length has to be positive");
    require_shape(size / edge_length < 1e7, shape, "it would have more than 10000000 sides");
}

// Parts of a line of this length: their length is as near to the edge length as whole parts allow.
int parts(double length, double edge_length) {
    return std::max(1, static_cast<int>(std::lround(length / edge_length)));
}

int corners_of_circle(double radius, double edge_length) { return std::max(8, parts(2 * pi * radius, edge_length)); }

// From an angle up to another one, without the end; clockwise when the end is the lesser one.
void append_arc(std::vector<Point2>& outline, const Point2& centre, double radius, double begin, double end,
                double edge_length) {
    const int count = parts(std::abs(end - begin) * radius, edge_length);
    for (int i = 0; i < count; ++i) {
        const double angle = begin + (end - begin) * i / count;
        outline.push_back(centre + radius * Point2(std::cos(angle), std::sin(angle)));
    }
}

void append_side(std::vector<Point2>& outline, const Point2& begin, const Point2& end, double edge_length) {
    const int count = parts((end - begin).norm(), edge_length);
    for (int i = 0; i < count; ++i) outline.push_back(begin + (end - begin) * (static_cast<double>(i) / count));
}

// Sides that regions share are divided from the same end, so that their points are the same.
void append_shared_side(std::vector<Point2>& outline, const Point2& begin, const Point2& end, double edge_length) {
    const bool is_forward = begin.x() < end.x() || (begin.x() == end.x() && begin.y() < end.y());
    std::vector<Point2> side;
    append_side(side, is_forward ? begin : end, is_forward ? end : begin, edge_length);
    if (!is_forward) {
        side.push_back(begin);
        std::ranges::reverse(side);
        side.pop_back();
    }
    outline.insert(outline.end(), side.begin(), side.end());
}

Region block_part(const std::vector<Point2>& corners, int label, double edge_length) {
    Region region{.label = label};
    for (std::size_t i = 0; i < corners.size(); ++i)
        append_shared_side(region.outline, corners[i], corners[(i + 1) % corners.size()], edge_length);
    return region;
}

}  // namespace

std::vector<Point2> regular_polygon(const Point2& centre, double radius, int corners, bool stands) {
    require_shape(radius > 0, "polygon", "the radius has to be positive");
    require_shape(corners >= 3, "polygon", "there have to be at least three sides");
    std::vector<Point2> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * pi * i / corners + (stands ? pi / 2 : 0);
        points.push_back(centre + radius * Point2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

std::vector<Point2> divided(const std::vector<Point2>& corners, double edge_length) {
    double length = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) length += (corners[(i + 1) % corners.size()] - corners[i]).norm();
    require_length("polygon", edge_length, length);
    std::vector<Point2> points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if ((b - a).norm() > 1.25 * edge_length) {
            append_side(points, a, b, edge_length);
        } else {
            points.push_back(a);
        }
    }
    return points;
}

std::vector<Region> disc(const Point2& centre, double radius, double edge_length) {
    require_length("disc", edge_length, radius);
    return {{regular_polygon(centre, radius, corners_of_circle(radius, edge_length)), 1}};
}

std::vector<Region> two_discs(const Point2& centre, double radius, double gap, double edge_length) {
    require_shape(gap > 0, "two-discs", "the gap has to be positive");
    const Point2 way(radius + gap / 2, 0);
    std::vector<Region> discs = disc(centre - way, radius, edge_length);
    discs.push_back(disc(centre + way, radius, edge_length).front());
    return discs;
}

std::vector<Region> ring(const Point2& centre, double radius, double half_width, double edge_length) {
    require_shape(0 < half_width && half_width < radius, "ring", "half of its width has to be less than its radius");
    std::vector<Region> circles = disc(centre, radius + half_width, edge_length);
    circles.push_back(disc(centre, radius - half_width, edge_length).front());
    circles.back().label = 0;
    return circles;
}

std::vector<Region> rectangle(const Point2& centre, const Point2& size, double edge_length) {
    require_shape(size.minCoeff() > 0, "box", "the sides have to be positive");
    require_length("box", edge_length, size.maxCoeff());
    const Point2 half = size / 2, mirrored(half.x(), -half.y());
    return {block_part({centre - half, centre + mirrored, centre + half, centre - mirrored}, 1, edge_length)};
}

std::vector<Region> dumbbell(const Point2& centre, const DumbbellSize& size, double edge_length) {
    const double d = size.half_distance, r = size.disc_radius, neck = size.neck;
    require_shape(0 < r && r < d, "dumbbell", "the discs have to be apart");
    require_shape(0 < neck && neck < r, "dumbbell", "the neck has to be thinner than the discs");
    require_length("dumbbell", edge_length, d);
    // The arc of the neck around (0, neck + arc) touches the discs: d^2 + (neck + arc)^2 = (r + arc)^2.
    const double arc = (d * d + neck * neck - r * r) / (2 * (r - neck));
    const Point2 right(d, 0), above(0, neck + arc);
    const double open = std::atan2(above.y(), -d);  // direction from the right disc to the centre of the upper arc
    const double below = std::atan2(-above.y(), d);
    Region region{.label = 1};
    append_arc(region.outline, centre + right, r, -open, open, edge_length);
    append_arc(region.outline, centre + above, arc, below, -pi - below, edge_length);
    append_arc(region.outline, centre - right, r, pi - open, pi + open, edge_length);
    append_arc(region.outline, centre - above, arc, pi + below, -below, edge_length);
    return {region};
}

std::vector<Region> slotted_disc(const Point2& centre, double radius, double width, double depth, double edge_length) {
    require_shape(0 < width && width < 2 * radius, "slotted-disc", "the slot has to be narrower than the disc");
    require_shape(0 < depth && depth < 2 * radius, "slotted-disc", "the slot has to end inside the disc");
    require_length("slotted-disc", edge_length, radius);
    const double x = width / 2, low = -std::sqrt(radius * radius - x * x), top = depth - radius;
    require_shape(top > low, "slotted-disc", "the slot has to be deeper");
    require_shape(top * top + x * x < radius * radius, "slotted-disc", "the slot has to end inside the disc");
    const double angle = std::atan2(low, x);
    Region region{.label = 1};
    append_arc(region.outline, centre, radius, angle, pi - angle, edge_length);
    append_side(region.outline, centre + Point2(-x, low), centre + Point2(-x, top), edge_length);
    append_side(region.outline, centre + Point2(-x, top), centre + Point2(x, top), edge_length);
    append_side(region.outline, centre + Point2(x, top), centre + Point2(x, low), edge_length);
    return {region};
}

std::vector<Region> labelled_block(const Point2& centre, const Point2& size, double edge_length) {
    require_shape(size.minCoeff() > 0, "labelled-block", "the sides have to be positive");
    require_length("labelled-block", edge_length, size.maxCoeff());
    const auto place = [&](double x, double y) { return Point2(centre + size.cwiseProduct(Point2(x, y)) / 2); };
    const Point2 low = place(0, -1), high = place(0, 1), right = place(1, 0);
    return {block_part({place(-1, -1), low, centre, high, place(-1, 1)}, 1, edge_length),
            block_part({low, place(1, -1), right, centre}, 2, edge_length),
            block_part({centre, right, place(1, 1), high}, 3, edge_length)};
}

}  // namespace dsc::dsc2d
