// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/polygon_file.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/errors.h"
#include "geometry/polygon_check.h"
#include "io/atomic_file.h"
#include "io/csv.h"
#include "io/json.h"
#include "io/svg_paths.h"

namespace dsc::flow::planar {

using dsc2d::Point2;

namespace {

struct Polygon {
    std::string name;  ///< for messages
    std::vector<Point2> points;
    std::optional<int> label;
};

/// Between them, squares of areas are normal doubles.
constexpr double largest_coordinate = 1e60, smallest_size = 1e-60;
/// More edges are taken for a mistake in the edge length.
constexpr double most_edges = 1e6;

std::string place_text(const Point2& p) { return fmt::format("({:.6g}, {:.6g})", p.x(), p.y()); }

int parsed_label(const std::string& path, const std::string& place, double number) {
    if (number != std::floor(number) || std::abs(number) > 1e9)
        throw core::InputError(path, place, fmt::format("the label {:.17g} is no whole number up to 1e9", number),
                               "use small whole numbers");
    return static_cast<int>(number);
}

std::vector<Polygon> from_csv(const std::string& path) {
    const io::CsvTable table = io::read_csv(path);
    std::map<double, std::size_t> number;
    std::vector<Polygon> polygons;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const std::vector<double>& row = table.rows[i];
        const std::string place = "line " + std::to_string(table.lines[i]);
        if (row.size() < 2 || row.size() > 4)
            throw core::InputError(path, place, "has " + std::to_string(row.size()) + " columns",
                                   "give x,y or x,y,polygon or x,y,polygon,label");
        const auto [at, is_new] = number.try_emplace(row.size() > 2 ? row[2] : 0, polygons.size());
        if (is_new) polygons.push_back({.name = "polygon " + std::to_string(polygons.size() + 1)});
        Polygon& polygon = polygons[at->second];
        polygon.points.emplace_back(row[0], row[1]);
        if (row.size() < 4) continue;
        const int label = parsed_label(path, place, row[3]);
        if (polygon.label && *polygon.label != label)
            throw core::InputError(path, place,
                                   fmt::format("{} gets the label {} after {}", polygon.name, label, *polygon.label),
                                   "give all points of a polygon the same label");
        polygon.label = label;
    }
    return polygons;
}

std::vector<Polygon> from_json(const std::string& path) {
    const io::Json json = io::Json::parse(io::read_file(path), path);
    std::vector<Polygon> polygons;
    try {
        for (const io::Json& entry : json.elements()) {
            Polygon& polygon = polygons.emplace_back();
            polygon.name = "polygon " + std::to_string(polygons.size());
            const bool has_label = entry.is_object() && entry.has("label");
            if (has_label)
                polygon.label = parsed_label(path, polygon.name, static_cast<double>(entry["label"].integer()));
            for (const io::Json& point : (entry.is_object() ? entry["points"] : entry).elements()) {
                if (point.size() != 2) throw core::InputError("JSON", "", "a point has not two coordinates", "");
                polygon.points.emplace_back(point[std::size_t{0}].number(), point[std::size_t{1}].number());
            }
        }
    } catch (const core::InputError& error) {
        if (error.source() == path) throw;
        const std::string place = polygons.empty() ? "" : polygons.back().name;
        throw core::InputError(path, place, error.what(), "give [[[x, y], ...], ...]");
    }
    return polygons;
}

std::vector<Polygon> from_svg(const std::string& path, std::optional<double> edge_length) {
    std::vector<Polygon> polygons;
    for (io::SvgPath& found : io::read_svg_paths(path, edge_length)) {
        if (!found.is_closed)
            throw core::InputError(path, found.name,
                                   "is open: it begins at " + place_text(found.points.front()) + " and ends at " +
                                       place_text(found.points.back()),
                                   "close it with Z");
        polygons.push_back({.name = found.name, .points = std::move(found.points)});
    }
    return polygons;
}

void require_scale(const std::string& path, const std::vector<Polygon>& polygons, std::optional<double> edge_length) {
    Eigen::AlignedBox2d box;
    double edges = 0;
    for (const Polygon& polygon : polygons) {
        for (std::size_t i = 0; i < polygon.points.size(); ++i) {
            const Point2 &p = polygon.points[i], &q = polygon.points[(i + 1) % polygon.points.size()];
            if (p.cwiseAbs().maxCoeff() > largest_coordinate)
                throw core::InputError(path, polygon.name,
                                       fmt::format("its point {} is beyond {:g}", place_text(p), largest_coordinate),
                                       "scale the coordinates down");
            box.extend(p);
            if (edge_length) edges += (q - p).norm() / *edge_length;
        }
    }
    const double size = box.sizes().maxCoeff();
    if (0 < size && size < smallest_size)
        throw core::InputError(path, "", fmt::format("the polygons are smaller than {:g}", smallest_size),
                               "scale the coordinates up");
    if (edges > most_edges)
        throw core::InputError(path, "", fmt::format("the sides have {:.3g} times the edge length", edges),
                               "give a greater --edge-length");
}

void require_simple(const std::string& path, const std::vector<Polygon>& polygons) {
    std::vector<std::vector<Point2>> outlines;
    for (const Polygon& polygon : polygons) {
        if (polygon.points.size() < 3)
            throw core::InputError(path, polygon.name, "has fewer than three different points", "give closed polygons");
        outlines.push_back(polygon.points);
    }
    const std::optional<geometry::SideMeeting> meeting = geometry::first_meeting(outlines);
    if (!meeting) return;
    const auto& [first, second, place] = *meeting;
    const std::string whose = first.polygon == second.polygon ? "" : " of " + polygons[second.polygon].name;
    throw core::InputError(
        path, polygons[first.polygon].name,
        fmt::format("side {} meets side {}{} at {}", first.side + 1, second.side + 1, whose, place_text(place)),
        "give simple polygons that keep apart");
}

// Polygons around others come first; as they are apart, they have the greater area.
std::vector<dsc2d::Region> nested(std::vector<Polygon> polygons) {
    std::ranges::stable_sort(polygons, std::greater<>{},
                             [](const Polygon& p) { return std::abs(geometry::signed_area(p.points)); });
    std::vector<dsc2d::Region> regions;
    for (const Polygon& polygon : polygons) {
        int depth = 0;
        for (const dsc2d::Region& outer : regions)
            depth += geometry::contains(outer.outline, polygon.points.front()) ? 1 : 0;
        regions.push_back({polygon.points, polygon.label.value_or(depth % 2 == 0 ? 1 : 0)});
    }
    return regions;
}

void require_interface(const std::string& path, const std::vector<dsc2d::Region>& regions) {
    if (std::ranges::any_of(regions, [](const dsc2d::Region& region) { return region.label != 0; })) return;
    throw core::InputError(path, "", "all polygons have the label 0, that of the outside, so there is nothing to move",
                           "give each region a label of its own");
}

}  // namespace

std::vector<dsc2d::Region> read_polygons(const std::string& path, std::optional<double> edge_length) {
    const std::string extension = std::filesystem::path(path).extension().string();
    std::vector<Polygon> polygons;
    if (extension == ".svg") {
        polygons = from_svg(path, edge_length);
    } else if (extension == ".csv") {
        polygons = from_csv(path);
    } else if (extension == ".json") {
        polygons = from_json(path);
    } else {
        throw core::InputError(path, "", "no shape of the plane can be read from \"" + extension + "\"",
                               "give .svg, .csv, .json or .mesh");
    }
    if (polygons.empty()) throw core::InputError(path, "", "there is no polygon", "give closed polygons");
    for (Polygon& polygon : polygons) {
        if (polygon.points.size() > 1 && polygon.points.front() == polygon.points.back()) polygon.points.pop_back();
    }
    require_scale(path, polygons, edge_length);
    require_simple(path, polygons);
    std::vector<dsc2d::Region> regions = nested(std::move(polygons));
    require_interface(path, regions);
    return regions;
}

}  // namespace dsc::flow::planar
