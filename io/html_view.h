// SPDX-License-Identifier: GPL-3.0-or-later
// A result as one HTML page that can be turned, zoomed and clicked: no server, no network, nothing beside the file.
// The page holds three.js (MIT licence, from Debian's libjs-three, its notice kept), the scene as JSON and a viewer.
// Guarantee: the page loads nothing from anywhere (its content security policy forbids it); any text may occur in names
// and labels. A picture needs no more than the 7 digits coordinates are written with.
//
//     io::HtmlView surface{.name = "surface"};
//     surface.surfaces.push_back({.name = "torus", .vertices = vertices, .triangles = triangles});
//     surface.lines.push_back({.name = "cut locus", .lines = arcs, .colour = "#c00000"});
//     io::write_html_page("locus.html", {.title = "Cut locus", .views = {surface}});
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dsc::io {

/// A point with a coordinate that is not a number interrupts the line.
using ViewLine = std::vector<Eigen::Vector3d>;

struct ViewSurface {
    std::string name;
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Eigen::Vector3d> colours;  ///< red, green, blue in [0, 1] per vertex; empty: `colour` everywhere
    std::string colour = "#c9d4de";        ///< CSS
    double opacity = 1;                    ///< at first; the reader can change it
    bool shows_edges = false;              ///< the triangles' edges, at first
};

/// Solid cells, each in the colour of its value, from red for `worst` to blue for `best`. The reader cuts them open
/// with a plane, leaves out those of high value, and clicks a cell to see its value.
struct ViewTets {
    std::string name;
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 4>> tets;  ///< positive: det[b - a, c - a, d - a] > 0
    std::vector<double> values;                      ///< one per tetrahedron
    std::string value_name = "value";
    double worst = 0;
    double best = 1;
    bool shows_edges = true;
};

struct ViewLines {
    std::string name;
    std::vector<ViewLine> lines;
    std::string colour = "#1f4e9c";
    double width = 2;  ///< px
    bool is_visible = true;
};

struct ViewPoints {
    std::string name;
    std::vector<Eigen::Vector3d> positions;
    std::vector<std::string> labels;  ///< shown when a point is clicked; empty, or one per point
    std::string colour = "#202020";
    double size = 8;  ///< px
    bool is_visible = true;
};

/// Lines that change with time: at time t the last frame not later than t is seen. All series of a view share a slider.
struct ViewSeries {
    std::string name;
    std::vector<double> times;  ///< ascending, one per frame
    std::vector<std::vector<ViewLine>> frames;
    std::string colour = "#e07b00";
    double width = 2;  ///< px
    bool is_visible = true;
};

/// A surface at one time.
struct ViewSurfaceFrame {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A surface that changes with time, as ViewSeries does; its triangles are shaded flat.
struct ViewSurfaceSeries {
    std::string name;
    std::vector<double> times;  ///< ascending, one per frame
    std::vector<ViewSurfaceFrame> frames;
    std::string colour = "#c9d4de";  ///< CSS
    double opacity = 1;              ///< at first
    bool shows_edges = true;         ///< at first
    bool is_visible = true;
};

/// Rays from one point (geodesics). A click on the view picks the sample nearest to it, shows its ray up to there and
/// prints the ray's label and the sample's value.
struct ViewFan {
    std::string name;
    std::vector<ViewLine> rays;
    std::vector<std::vector<double>> values;  ///< one per sample: the length so far, say
    std::vector<std::string> labels;          ///< one per ray
    std::string value_name = "distance";
    std::string colour = "#0a8f4d";
    double width = 3;  ///< px
};

/// What is seen at one time; the page has a button for each view.
struct HtmlView {
    std::string name;
    bool is_flat = false;  ///< a chart: seen from above, moved and zoomed but not turned
    std::vector<ViewSurface> surfaces;
    std::optional<ViewTets> tets;
    std::vector<ViewLines> lines;
    std::vector<ViewPoints> points;
    std::vector<ViewSeries> series;
    std::vector<ViewSurfaceSeries> surface_series;
    std::optional<ViewFan> fan;
};

struct HtmlPage {
    std::string title;
    std::vector<std::pair<std::string, std::string>> facts;  ///< name and value, a table beside the picture
    std::string figure;              ///< a picture below the table, as SVG (io/svg.h); may be empty
    std::vector<HtmlView> views;     ///< the first is shown at first
    bool shares_camera = false;      ///< the views show the same thing: turning one turns all
    std::string time_name = "time";  ///< what the slider says
    std::string script;  ///< JavaScript run after the viewer, which it finds as window.dscView; may be empty
};

std::string html_page(const HtmlPage& page);
void write_html_page(const std::filesystem::path& path, const HtmlPage& page);

}  // namespace dsc::io
