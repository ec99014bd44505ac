// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/deform/region.h"

namespace dsc::dsc3d {

void Region::add_star(RatedMesh& mesh, VertexId v) { add(mesh.walker().star(v)); }

void Region::settle(const Complex& complex) {
    seen_tets_.clear();
    std::erase_if(tets_, [&](TetId t) { return complex.is_deleted(t) || !seen_tets_.add(t); });
}

std::vector<VertexId> Region::vertices(const Complex& complex) {
    seen_vertices_.clear();
    std::vector<VertexId> vertices;
    for (const TetId t : tets_)
        for (const VertexId v : complex.vertices(t))
            if (seen_vertices_.add(v)) vertices.push_back(v);
    return vertices;
}

std::vector<VertexId> Region::interface_vertices(const Complex& complex) {
    std::vector<VertexId> vertices = this->vertices(complex);
    std::erase_if(vertices, [&](VertexId v) { return !complex.is_interface(v); });
    return vertices;
}

std::vector<EdgeId> Region::edges_off_interface(const Complex& complex) {
    seen_edges_.clear();
    std::vector<EdgeId> edges;
    for (const TetId t : tets_)
        for (const EdgeId e : complex.edges(t))
            if (seen_edges_.add(e) && !complex.is_interface(e)) edges.push_back(e);
    return edges;
}

std::vector<EdgeId> Region::interface_edges(const Complex& complex) {
    seen_edges_.clear();
    std::vector<EdgeId> edges;
    for (const TetId t : tets_)
        for (const FaceId f : complex.faces(t)) {
            if (!complex.is_interface(f)) continue;
            for (const EdgeId e : complex.edges(f))
                if (seen_edges_.add(e)) edges.push_back(e);
        }
    return edges;
}

}  // namespace dsc::dsc3d
