// SPDX-License-Identifier: GPL-3.0-or-later
// Where the surface is that oriented points were taken from: near smooth pieces the quadratic patch of least squares,
// near sharp edges one patch for each side and their intersection, at corners that of three.
// Source: thesis 4.4.3 (points of a face share a plane, vertices go to where planes meet), with patches instead of
// planes and sides told apart by the points' normals; moving least squares: Levin (2004). Guarantee: the same bits for
// the same question. Cost: some 10 us for a smooth place, 50 us next to an edge.
#pragma once

#include <array>
#include <optional>

#include "apps/reconstruct/cloud.h"

namespace dsc::reconstruct {

struct SurfaceModelParameters {
    int points = 24;                   ///< that creases and corners are judged by; >= 6
    int patch_points = 16;             ///< the nearest of these, that a smooth piece is judged by; in [6, points]
    double most_standard_error = 1.2;  ///< of a patch, in those of its points; beyond it becomes a plane; > 0
    double side_angle = 35;            ///< normals of one side differ by less [degree]; (0, 90)
    double crease_angle = 28;          ///< sides that meet at a smaller angle are one smooth piece [degree]; (0, 90)
    int least_side_points = 3;         ///< of a side; >= 3

    /// Throws core::UsageError naming the field.
    void validate() const;
};

/// A place on the surface, with the normals of the sides that meet there: one on a smooth piece, two on a crease, three
/// at a corner.
struct SurfacePlace {
    Point3 point = Point3::Zero();
    std::array<Vector3, 3> normals = {Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
    int sides = 0;  ///< 0: not known

    bool is_smooth() const { return sides == 1; }
};

class SurfaceModel {
public:
    /// All arguments have to outlive the model; `normals` are unit and outwards.
    SurfaceModel(const Cloud& cloud, const KdTree& tree, std::span<const Vector3> normals, double noise,
                 const SurfaceModelParameters& parameters);

    /// The place of the surface nearest to x, about; on a corner or crease when there is one within reach.
    SurfacePlace place(const Point3& x, double corner_reach, double crease_reach) const;
    /// The same on the smooth piece whose normal is nearest to `normal`; none when no points have such a one.
    std::optional<SurfacePlace> smooth_place(const Point3& x, const Vector3& normal) const;
    int threads() const { return cloud_.threads; }
    const SurfaceModelParameters& parameters() const { return parameters_; }

private:
    struct Sample {
        Point3 point;
        Vector3 normal;
        int points = 0;
    };
    using Near = std::span<const KdTree::Neighbour>;

    Sample fitted(Near near, const Point3& x, const Vector3& normal) const;
    std::vector<Vector3> side_normals(Near near) const;
    std::optional<SurfacePlace> meeting(Near near, const Point3& x, std::span<const Vector3> normals) const;

    const Cloud& cloud_;
    const KdTree& tree_;
    std::span<const Vector3> normals_;
    double noise_;
    SurfaceModelParameters parameters_;
    double side_cosine_;
};

}  // namespace dsc::reconstruct
