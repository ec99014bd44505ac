// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/complex/validate.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace dsc::dsc3d {

namespace {

struct FaceRecord {
    std::vector<TetId> tets;
    int parity_sum = 0;  ///< of the induced orientations against the ascending order
};

// What the tetrahedra alone say.
struct Reconstruction {
    std::map<FaceVertices, FaceRecord> faces;
    std::map<EdgeVertices, std::vector<TetId>> edges;
    std::map<VertexId, std::vector<TetId>> vertices;
};

template <std::size_t N>
std::string text(const std::array<VertexId, N>& vertices) {
    std::string result;
    for (const VertexId v : vertices) result += (result.empty() ? "" : " ") + std::to_string(v.index());
    return "[" + result + "]";
}

// Ascending order of `v`, and the sign of the permutation that gives it.
template <std::size_t N>
std::pair<std::array<VertexId, N>, int> ascending(std::array<VertexId, N> v) {
    int sign = 1;
    for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t j = i + 1; j < N; ++j) {
            if (v[j] < v[i]) std::swap(v[i], v[j]), sign = -sign;
        }
    }
    return {v, sign};
}

class Check {
public:
    Check(const Complex& complex, std::size_t limit) : complex_(complex), limit_(limit) {}

    std::vector<std::string> run() {
        reconstruct();
        check_faces();
        check_edges();
        check_vertices();
        check_counts();
        return std::move(problems_);
    }

private:
    void require(bool condition, const std::string& problem) {
        if (!condition && problems_.size() < limit_) problems_.push_back(problem);
    }

    void reconstruct() {
        for (std::uint32_t i = 0; i < complex_.tet_capacity(); ++i) {
            const TetId t(i);
            if (complex_.is_deleted(t)) continue;
            ++tets_;
            const TetVertices& v = complex_.vertices(t);
            const std::string name = "tetrahedron " + std::to_string(i) + " " + text(v);
            require(std::set<VertexId>(v.begin(), v.end()).size() == 4, name + " repeats a vertex");
            int sign = 1;
            for (std::size_t k = 0; k < 4; ++k, sign = -sign) {
                FaceVertices corners;
                std::copy_if(v.begin(), v.end(), corners.begin(), [&](VertexId u) { return u != v[k]; });
                const auto [key, parity] = ascending(corners);
                FaceRecord& record = reconstruction_.faces[key];
                record.tets.push_back(t);
                record.parity_sum += sign * parity;
                const FaceId f = complex_.faces(t)[k];
                require(f.is_valid() && f.index() < complex_.face_capacity() && !complex_.is_deleted(f) &&
                            ascending(complex_.vertices(f)).first == key,
                        name + ": its face " + std::to_string(k) + " is not the one opposite its vertex");
                reconstruction_.vertices[v[k]].push_back(t);
                for (std::size_t j = k + 1; j < 4; ++j)
                    reconstruction_.edges[ascending(EdgeVertices{v[k], v[j]}).first].push_back(t);
            }
        }
    }

    void check_faces() {
        std::set<FaceVertices> seen;
        for (std::uint32_t i = 0; i < complex_.face_capacity(); ++i) {
            const FaceId f(i);
            if (complex_.is_deleted(f)) continue;
            ++faces_;
            const FaceVertices corners = complex_.vertices(f);
            const FaceVertices key = ascending(corners).first;
            const std::string name = "face " + std::to_string(i) + " " + text(corners);
            require(seen.insert(key).second, name + " occurs twice");
            for (std::size_t k = 0; k < 3; ++k) {
                const EdgeId e = complex_.edges(f)[k];
                require(!complex_.is_deleted(e) &&
                            ascending(complex_.vertices(e)).first ==
                                ascending(EdgeVertices{corners[(k + 1) % 3], corners[(k + 2) % 3]}).first,
                        name + ": its edge " + std::to_string(k) + " is not the one opposite its vertex");
            }
            const auto found = reconstruction_.faces.find(key);
            if (found == reconstruction_.faces.end()) {
                require(false, name + " belongs to no tetrahedron");
                continue;
            }
            const FaceRecord& record = found->second;
            require(record.tets.size() <= 2, name + " has more than two tetrahedra");
            require(record.tets.size() != 2 || record.parity_sum == 0, name + " has both tetrahedra on one side");
            std::vector<TetId> stored;
            for (const TetId t : complex_.tets(f))
                if (t.is_valid()) stored.push_back(t);
            require(std::is_permutation(stored.begin(), stored.end(), record.tets.begin(), record.tets.end()),
                    name + " does not know its tetrahedra");
        }
        require(seen.size() == reconstruction_.faces.size(), "a face of a tetrahedron is missing");
    }

    bool is_surface(const FaceVertices& key, bool wants_boundary) const {
        const std::vector<TetId>& tets = reconstruction_.faces.at(key).tets;
        if (wants_boundary) return tets.size() == 1;
        return tets.size() == 2 && complex_.label(tets[0]) != complex_.label(tets[1]);
    }

    // Numbers of boundary and interface faces among the faces of `tets` that contain all of `simplex`.
    template <std::size_t N>
    std::pair<int, int> surface_faces(const std::array<VertexId, N>& simplex, const std::vector<TetId>& tets) const {
        std::set<FaceVertices> around;
        for (const TetId t : tets) {
            for (int k = 0; k < 4; ++k) {
                const FaceVertices key = ascending(complex_.oriented_face(t, k)).first;
                const bool contains = std::all_of(simplex.begin(), simplex.end(), [&](VertexId v) {
                    return std::find(key.begin(), key.end(), v) != key.end();
                });
                if (contains) around.insert(key);
            }
        }
        std::pair<int, int> count;
        for (const FaceVertices& key : around) {
            count.first += is_surface(key, true) ? 1 : 0;
            count.second += is_surface(key, false) ? 1 : 0;
        }
        return count;
    }

    // Whether the tetrahedra are connected through faces that contain all of `simplex`.
    template <std::size_t N>
    bool is_connected(const std::array<VertexId, N>& simplex, const std::vector<TetId>& tets) const {
        std::set<TetId> open(tets.begin(), tets.end());
        std::vector<TetId> front = {tets.front()};
        open.erase(tets.front());
        while (!front.empty()) {
            const TetVertices v = complex_.vertices(front.back());
            front.pop_back();
            for (const VertexId left_out : v) {
                if (std::find(simplex.begin(), simplex.end(), left_out) != simplex.end()) continue;
                FaceVertices corners;
                std::copy_if(v.begin(), v.end(), corners.begin(), [&](VertexId u) { return u != left_out; });
                for (const TetId next : reconstruction_.faces.at(ascending(corners).first).tets)
                    if (open.erase(next) != 0) front.push_back(next);
            }
        }
        return open.empty();
    }

    void check_edges() {
        std::set<EdgeVertices> seen;
        for (std::uint32_t i = 0; i < complex_.edge_capacity(); ++i) {
            const EdgeId e(i);
            if (complex_.is_deleted(e)) continue;
            ++edges_;
            const EdgeVertices key = ascending(complex_.vertices(e)).first;
            const std::string name = "edge " + std::to_string(i) + " " + text(key);
            require(seen.insert(key).second, name + " occurs twice");
            const auto found = reconstruction_.edges.find(key);
            if (found == reconstruction_.edges.end()) {
                require(false, name + " belongs to no tetrahedron");
                continue;
            }
            const FaceId f = complex_.face(e);
            require(!complex_.is_deleted(f) &&
                        std::find(complex_.edges(f).begin(), complex_.edges(f).end(), e) != complex_.edges(f).end(),
                    name + ": its face does not contain it");
            const auto [boundary, interface] = surface_faces(key, found->second);
            require((boundary != 0) == complex_.is_boundary(e) && (interface != 0) == complex_.is_interface(e) &&
                        complex_.surface_degree(e) == static_cast<std::uint32_t>(boundary + interface),
                    name + ": its flags are wrong");
            require(boundary == 0 || boundary == 2, name + " has " + std::to_string(boundary) + " boundary faces");
            require(is_connected(key, found->second), name + ": its star falls apart");
        }
        require(seen.size() == reconstruction_.edges.size(), "an edge of a tetrahedron is missing");
    }

    void check_vertices() {
        for (std::uint32_t i = 0; i < complex_.vertex_capacity(); ++i) {
            const VertexId v(i);
            if (complex_.is_deleted(v)) continue;
            ++vertices_;
            const std::string name = "vertex " + std::to_string(i);
            const auto found = reconstruction_.vertices.find(v);
            if (found == reconstruction_.vertices.end()) {
                require(false, name + " belongs to no tetrahedron");
                continue;
            }
            const EdgeId e = complex_.edge(v);
            require(!complex_.is_deleted(e) && (complex_.vertices(e)[0] == v || complex_.vertices(e)[1] == v),
                    name + ": its edge does not contain it");
            const auto [boundary, interface] = surface_faces(std::array{v}, found->second);
            require((boundary != 0) == complex_.is_boundary(v) && (interface != 0) == complex_.is_interface(v),
                    name + ": its flags are wrong");
            require(is_connected(std::array{v}, found->second), name + ": its star falls apart");
            require(link_euler(v, found->second) == (boundary != 0 ? 1 : 2),
                    name + ": its link is neither a sphere nor a disc");
        }
        require(vertices_ == reconstruction_.vertices.size(), "a vertex of a tetrahedron is missing");
    }

    int link_euler(VertexId v, const std::vector<TetId>& tets) const {
        std::set<VertexId> points;
        std::set<EdgeVertices> lines;
        for (const TetId t : tets) {
            for (const VertexId a : complex_.vertices(t)) {
                if (a == v) continue;
                points.insert(a);
                for (const VertexId b : complex_.vertices(t))
                    if (b != v && a < b) lines.insert({a, b});
            }
        }
        return static_cast<int>(points.size()) - static_cast<int>(lines.size()) + static_cast<int>(tets.size());
    }

    void check_counts() {
        require(tets_ == complex_.tet_count(), "the number of tetrahedra is wrong");
        require(faces_ == complex_.face_count(), "the number of faces is wrong");
        require(edges_ == complex_.edge_count(), "the number of edges is wrong");
        require(vertices_ == complex_.vertex_count(), "the number of vertices is wrong");
    }

    const Complex& complex_;
    std::size_t limit_;
    Reconstruction reconstruction_;
    std::vector<std::string> problems_;
    std::size_t tets_ = 0, faces_ = 0, edges_ = 0, vertices_ = 0;
};

}  // namespace

std::vector<std::string> validate(const Complex& complex, std::size_t limit) { return Check(complex, limit).run(); }

}  // namespace dsc::dsc3d
