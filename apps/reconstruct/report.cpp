// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct/report.h"

#include <fmt/core.h>

#include <algorithm>

namespace dsc::reconstruct {

using io::Json;

namespace {

std::size_t invented_triangles(const Reconstruction& result) {
    return static_cast<std::size_t>(std::count(result.is_invented.begin(), result.is_invented.end(), 1));
}

std::string genus_text(const Reconstruction& result) {
    std::string text;
    for (const std::int64_t genus : result.genus) text += (text.empty() ? "" : ", ") + std::to_string(genus);
    return text;
}

}  // namespace

std::string report_text(const Reconstruction& result) {
    std::string text = fmt::format("points        {} ({} duplicates and {} strays left out)\n", result.points,
                                   result.duplicates, result.strays.size());
    text += fmt::format("spacing       {:.4g}, noise {:.3g}\n", result.spacing, result.noise);
    text += fmt::format("surface       {} triangles, {} component{} of genus {}{}\n", result.surface.triangles.size(),
                        result.genus.size(), result.genus.size() == 1 ? "" : "s", genus_text(result),
                        result.cavities > 0 ? fmt::format(", {} of them cavities", result.cavities) : "");
    text += fmt::format("features      {} vertices on creases, {} corners\n", result.fit.crease_vertices,
                        result.fit.corners);
    text += fmt::format("residuals     mean {:.3g}, root mean square {:.3g}, largest {:.3g}\n", result.residuals.mean,
                        result.residuals.root_mean_square, result.residuals.largest);
    text += fmt::format("volume        {:.6g}, area {:.6g}\n", *result.check.volume, result.check.area);
    if (const std::size_t invented = invented_triangles(result); invented > 0)
        text += fmt::format("invented      {} triangles, where no points are near\n", invented);
    if (!result.tets.tets.empty()) text += fmt::format("tetrahedra    {}\n", result.tets.tets.size());
    double total = 0;
    std::string phases;
    for (const PhaseSeconds& phase : result.phases) {
        total += phase.seconds;
        phases += fmt::format("{}{} {:.2f}", phases.empty() ? "" : ", ", phase.phase, phase.seconds);
    }
    return text + fmt::format("seconds       {:.2f} ({})\n", total, phases);
}

Json report_json(const Reconstruction& result, const Json& given) {
    Json genus = Json::array(), strays = Json::array(), invented = Json::array(), phases = Json::object();
    for (const std::int64_t g : result.genus) genus.push_back(g);
    for (const std::uint32_t i : result.strays) strays.push_back(i);
    for (std::size_t t = 0; t < result.is_invented.size(); ++t)
        if (result.is_invented[t] != 0) invented.push_back(t);
    for (const PhaseSeconds& phase : result.phases) phases[phase.phase] = phase.seconds;
    return Json::object({{"given", given},
                         {"points", result.points},
                         {"duplicates", result.duplicates},
                         {"strays", strays},
                         {"spacing", result.spacing},
                         {"noise", result.noise},
                         {"surface", Json::object({{"vertices", result.surface.vertices.size()},
                                                   {"triangles", result.surface.triangles.size()},
                                                   {"components", result.genus.size()},
                                                   {"genus", genus},
                                                   {"cavities", result.cavities},
                                                   {"volume", *result.check.volume},
                                                   {"area", result.check.area},
                                                   {"crease_vertices", result.fit.crease_vertices},
                                                   {"corners", result.fit.corners},
                                                   {"invented_triangles", invented}})},
                         {"dropped_parts", result.dropped_parts},
                         {"operations", Json::object({{"cuts", result.fit.cuts},
                                                      {"collapses", result.fit.collapses},
                                                      {"decimated", result.fit.decimated},
                                                      {"flips", result.fit.flips}})},
                         {"residuals", Json::object({{"mean", result.residuals.mean},
                                                     {"root_mean_square", result.residuals.root_mean_square},
                                                     {"largest", result.residuals.largest}})},
                         {"tets", result.tets.tets.size()},
                         {"seconds", phases}});
}

}  // namespace dsc::reconstruct
