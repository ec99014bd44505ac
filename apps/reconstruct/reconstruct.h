// SPDX-License-Identifier: GPL-3.0-or-later
// A point cloud to a closed surface and the tetrahedra inside it.
// Source: thesis 4.4.3, on the 3D deformable simplicial complex. The steps: the cloud is cleaned and measured
// (cloud.h), normals are estimated (normals.h) and oriented all at once (orientation.h), noise is taken out
// (denoising.h), the cells of a complex as fine as the cloud are labelled (front.h), and its interface is fitted to
// patches, creases and corners (surface_fit.h); where there are no points it is bent as little as possible (bridge.h).
// Guarantee: the surface is the interface of one complex, all of whose tetrahedra are positive by exact predicate:
// closed, manifold, oriented outwards, nowhere meeting itself; the same bits for the same input on any number of
// threads. Cost: some 0.4 ms and 10 kB per point, the most of both for the cells.
//
//     const geometry::PointData cloud = io::read_points("scan.xyz");
//     const Reconstruction result = reconstruct(cloud, {}, "scan.xyz", observer);
//     io::write_surface_mesh("scan.obj", result.surface);
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/reconstruct/bridge.h"
#include "apps/reconstruct/cloud.h"
#include "apps/reconstruct/denoising.h"
#include "apps/reconstruct/front.h"
#include "apps/reconstruct/normals.h"
#include "apps/reconstruct/orientation.h"
#include "apps/reconstruct/surface_fit.h"
#include "apps/reconstruct/surface_model.h"
#include "core/observer.h"
#include "geometry/point_data.h"
#include "geometry/surface_check.h"
#include "geometry/surface_data.h"
#include "geometry/tet_data.h"

namespace dsc::reconstruct {

struct ReconstructParameters {
    std::optional<double> detail;  ///< wanted edge length instead of one from the spacing [units of the input]; > 0
    double least_detail = 0.25;    ///< that `detail` may be [spacing]: finer edges show nothing, and take long; > 0
    double most_detail = 0.1;      ///< ... [diagonal of the cloud]: with longer ones there is hardly a surface; > 0
    std::optional<double> noise;   ///< standard deviation instead of an estimate [units of the input]; >= 0
    bool keeps_genus_zero =
        false;                     ///< one surface of genus 0, as a front that shrinks from around everything leaves it
    bool makes_tets = false;       ///< improve and return the tetrahedra inside, too
    double min_angle = 12;         ///< that their dihedral angles should have [degree]; (0, 40]
    double invented_distance = 3;  ///< triangles farther from all points are invented [spacing]; > 0
    /// Neighbours that normals are judged by reach this far, in standard deviations of the noise, ...
    double noise_reach = 9;    ///< > 0
    int most_neighbours = 60;  ///< ... but are no more than this; at least cloud.neighbours
    int threads = 0;           ///< 0: all
    CloudParameters cloud = {};
    NormalParameters normals = {};
    OrientationParameters orientation = {};
    DenoisingParameters denoising = {};
    FrontParameters front = {};
    SurfaceModelParameters model = {};
    SurfaceFitParameters fit = {};
    BridgeParameters bridge = {};

    /// Throws core::UsageError naming the field.
    void validate() const;
};

struct Residuals {
    double mean = 0, root_mean_square = 0, largest = 0;  ///< of points that are not strays [units of the input]
};

struct PhaseSeconds {
    std::string phase;
    double seconds;
};

struct Reconstruction {
    geometry::SurfaceData surface;
    std::vector<int> is_invented;         ///< of each triangle, 1 where no points are near
    std::vector<double> vertex_distance;  ///< from the nearest point, of each vertex
    geometry::TetData tets;               ///< inside the surface, when wanted
    geometry::SurfaceCheck check;
    std::vector<std::int64_t> genus;  ///< of each component of the surface, descending
    std::size_t points = 0, duplicates = 0;
    std::vector<std::uint32_t> strays;  ///< points left out, counted from 0
    double spacing = 0, noise = 0;      ///< [units of the input]
    std::size_t cavities = 0, dropped_parts = 0;
    SurfaceFitCounts fit;
    Residuals residuals;
    std::vector<PhaseSeconds> phases;
};

/// The interface at the end of a stage, in the units of the input.
using StageWatcher = std::function<void(const std::string& stage, const geometry::SurfaceData& surface)>;

/// Throws core::InputError naming `source` for a cloud that encloses nothing, core::RunError when no surface was found
/// or it lost its properties to the rounding of coordinates far from the origin, core::Cancelled.
Reconstruction reconstruct(const geometry::PointData& data, const ReconstructParameters& parameters,
                           const std::string& source, core::Observer& observer, const StageWatcher& watcher = nullptr);

}  // namespace dsc::reconstruct
