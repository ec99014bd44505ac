// SPDX-License-Identifier: GPL-3.0-or-later
// The OpenMesh half-edge mesh under the complex, and the conversions between its handles and ours (no cost).
// Source: OpenMesh 9: the array kernel of TriMesh_ArrayKernelT with double coordinates, without the normals and measures
// that TriMeshT adds on top, which don't exist for a flat cover.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "core/handles.h"
#include "geometry/predicates.h"

namespace dsc::dsc2d {

/// A Point2 that OpenMesh may default-construct and copy: Eigen would leave it uninitialized.
struct MeshPoint : geometry::Point2 {
    MeshPoint() : geometry::Point2(0.0, 0.0) {}
    MeshPoint(const geometry::Point2& p) : geometry::Point2(p) {}
};

}  // namespace dsc::dsc2d

// Not by OpenMesh's own EigenVectorT.hh, which also adds free functions cross, dot and norm to namespace Eigen.
template <>
struct OpenMesh::vector_traits<dsc::dsc2d::MeshPoint> {
    using vector_type = dsc::dsc2d::MeshPoint;
    using value_type = double;
    static const std::size_t size_ = 2;
    static std::size_t size() { return size_; }
};

namespace dsc::dsc2d {

struct MeshTraits : OpenMesh::DefaultTraits {
    using Point = MeshPoint;
    using Normal = MeshPoint;
    VertexAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
};
using MeshKernel = OpenMesh::AttribKernelT<OpenMesh::FinalMeshItemsT<MeshTraits, true>, OpenMesh::TriConnectivity>;

inline OpenMesh::VertexHandle to_kernel(core::VertexId v) { return OpenMesh::VertexHandle(static_cast<int>(v.index())); }
inline OpenMesh::HalfedgeHandle to_kernel(core::HalfedgeId h) {
    return OpenMesh::HalfedgeHandle(static_cast<int>(h.index()));
}
inline OpenMesh::EdgeHandle to_kernel(core::EdgeId e) { return OpenMesh::EdgeHandle(static_cast<int>(e.index())); }
inline OpenMesh::FaceHandle to_kernel(core::FaceId f) { return OpenMesh::FaceHandle(static_cast<int>(f.index())); }
// An invalid OpenMesh handle has index -1, which becomes our invalid handle.
inline core::VertexId from_kernel(OpenMesh::VertexHandle v) { return core::VertexId(static_cast<std::uint32_t>(v.idx())); }
inline core::HalfedgeId from_kernel(OpenMesh::HalfedgeHandle h) {
    return core::HalfedgeId(static_cast<std::uint32_t>(h.idx()));
}
inline core::EdgeId from_kernel(OpenMesh::EdgeHandle e) { return core::EdgeId(static_cast<std::uint32_t>(e.idx())); }
inline core::FaceId from_kernel(OpenMesh::FaceHandle f) { return core::FaceId(static_cast<std::uint32_t>(f.idx())); }

}  // namespace dsc::dsc2d
