// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/complex/validate.h"

#include <algorithm>
#include <span>
#include <utility>

namespace dsc::dsc3d {

namespace {

template <std::size_t N>
using Key = std::array<VertexId, N>;  ///< of a simplex: its vertices in ascending order

template <std::size_t N>
std::string text(const std::array<VertexId, N>& vertices) {
    std::string result;
    for (const VertexId v : vertices) result += (result.empty() ? "" : " ") + std::to_string(v.index());
    return "[" + result + "]";
}

// Ascending order of `v`, and the sign of the permutation that gives it.
template <std::size_t N>
std::pair<Key<N>, int> ascending(std::array<VertexId, N> v) {
    int sign = 1;
    for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t j = i + 1; j < N; ++j) {
            if (v[j] < v[i]) std::swap(v[i], v[j]), sign = -sign;
        }
    }
    return {v, sign};
}

FaceVertices without(const TetVertices& v, std::size_t place) {
    FaceVertices corners;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
        if (i != place) corners[count++] = v[i];
    return corners;
}

// What is known of simplices by their vertices, to be found by them: a list in the order of the keys, in which one key
// may occur many times.
template <std::size_t N, class Value>
class SortedIndex {
public:
    using Entry = std::pair<Key<N>, Value>;

    void add(const Key<N>& key, const Value& value) { entries_.emplace_back(key, value); }
    void sort() { std::sort(entries_.begin(), entries_.end()); }
    std::span<const Entry> find(const Key<N>& key) const {
        const auto [begin, end] = std::equal_range(entries_.begin(), entries_.end(), Entry(key, Value()),
                                                   [](const Entry& a, const Entry& b) { return a.first < b.first; });
        return {begin, end};
    }
    template <class Use>
    void for_each_key(Use&& use) const {
        for (std::size_t begin = 0, end = 0; begin < entries_.size(); begin = end) {
            while (end < entries_.size() && entries_[end].first == entries_[begin].first) ++end;
            use(std::span<const Entry>(entries_).subspan(begin, end - begin));
        }
    }
    std::size_t key_count() const {
        std::size_t count = 0;
        for_each_key([&](std::span<const Entry>) { ++count; });
        return count;
    }

private:
    std::vector<Entry> entries_;
};

// A tetrahedron at a face: which one, the place of the face in it, and whether its induced orientation is that of the
// ascending order.
struct Side {
    TetId tet;
    std::uint8_t place = 0;
    std::int8_t sign = 0;
    auto operator<=>(const Side&) const = default;
};

// What the tetrahedra alone say.
struct Reconstruction {
    SortedIndex<3, Side> faces;
    SortedIndex<2, TetId> edges;
    SortedIndex<1, TetId> vertices;
    SortedIndex<2, bool> surface_at_edge;  ///< one entry per surface face: whether it is one of the boundary
    SortedIndex<1, bool> surface_at_vertex;
    std::vector<int> link_euler;                   ///< Euler's number of the link of each vertex
    std::vector<std::array<TetId, 4>> neighbours;  ///< of each tetrahedron, across its faces

    explicit Reconstruction(const Complex& complex)
        : link_euler(complex.vertex_capacity(), 0), neighbours(complex.tet_capacity()) {}

    void add(TetId t, const TetVertices& v) {
        int sign = 1;
        for (std::size_t k = 0; k < 4; ++k, sign = -sign) {
            const auto [key, parity] = ascending(without(v, k));
            faces.add(key, {t, static_cast<std::uint8_t>(k), static_cast<std::int8_t>(sign * parity)});
            vertices.add({v[k]}, t);
            ++link_euler[v[k].index()];
            for (std::size_t j = k + 1; j < 4; ++j) edges.add(ascending(EdgeVertices{v[k], v[j]}).first, t);
        }
    }

    void finish(const Complex& complex) {
        faces.sort(), edges.sort(), vertices.sort();
        faces.for_each_key([&](auto sides) {
            const Key<3>& key = sides[0].first;
            for (const VertexId v : key) --link_euler[v.index()];
            for (std::size_t i = 0; i < sides.size() && sides.size() > 1; ++i)
                neighbours[sides[i].second.tet.index()][sides[i].second.place] =
                    sides[(i + 1) % sides.size()].second.tet;
            const bool is_boundary = sides.size() == 1;
            if (!is_boundary && complex.label(sides[0].second.tet) == complex.label(sides[1].second.tet)) return;
            for (std::size_t i = 0; i < 3; ++i) {
                surface_at_vertex.add({key[i]}, is_boundary);
                surface_at_edge.add(i == 0   ? Key<2>{key[1], key[2]}
                                    : i == 1 ? Key<2>{key[0], key[2]}
                                             : Key<2>{key[0], key[1]},
                                    is_boundary);
            }
        });
        edges.for_each_key([&](auto tets) {
            for (const VertexId v : tets[0].first) ++link_euler[v.index()];
        });
        surface_at_edge.sort(), surface_at_vertex.sort();
    }
};

class Check {
public:
    Check(const Complex& complex, std::size_t limit) : complex_(complex), limit_(limit), reconstruction_(complex) {}

    std::vector<std::string> run() {
        check_tets();
        reconstruction_.finish(complex_);
        check_faces();
        check_edges();
        check_vertices();
        check_counts();
        return std::move(problems_);
    }

private:
    // `problem` makes the text, which nobody needs when all is well.
    template <class Problem>
    void require(bool condition, Problem&& problem) {
        if (!condition && problems_.size() < limit_) problems_.push_back(problem());
    }

    void check_tets() {
        for (std::uint32_t i = 0; i < complex_.tet_capacity(); ++i) {
            const TetId t(i);
            if (complex_.is_deleted(t)) continue;
            ++tets_;
            const TetVertices& v = complex_.vertices(t);
            const auto name = [&] { return "tetrahedron " + std::to_string(i) + " " + text(v); };
            const TetVertices sorted = ascending(v).first;
            require(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end(),
                    [&] { return name() + " repeats a vertex"; });
            for (std::size_t k = 0; k < 4; ++k) {
                const FaceId f = complex_.faces(t)[k];
                require(
                    f.is_valid() && f.index() < complex_.face_capacity() && !complex_.is_deleted(f) &&
                        ascending(complex_.vertices(f)).first == ascending(without(v, k)).first,
                    [&] { return name() + ": its face " + std::to_string(k) + " is not the one opposite its vertex"; });
            }
            reconstruction_.add(t, v);
        }
    }

    void check_faces() {
        std::vector<Key<3>> seen;
        for (std::uint32_t i = 0; i < complex_.face_capacity(); ++i) {
            const FaceId f(i);
            if (complex_.is_deleted(f)) continue;
            ++faces_;
            const FaceVertices corners = complex_.vertices(f);
            const Key<3> key = ascending(corners).first;
            const auto name = [&] { return "face " + std::to_string(i) + " " + text(corners); };
            seen.push_back(key);
            for (std::size_t k = 0; k < 3; ++k) {
                const EdgeId e = complex_.edges(f)[k];
                require(
                    !complex_.is_deleted(e) &&
                        ascending(complex_.vertices(e)).first ==
                            ascending(EdgeVertices{corners[(k + 1) % 3], corners[(k + 2) % 3]}).first,
                    [&] { return name() + ": its edge " + std::to_string(k) + " is not the one opposite its vertex"; });
            }
            const auto sides = reconstruction_.faces.find(key);
            require(!sides.empty(), [&] { return name() + " belongs to no tetrahedron"; });
            require(sides.size() <= 2, [&] { return name() + " has more than two tetrahedra"; });
            if (sides.empty() || sides.size() > 2) continue;
            require(sides.size() != 2 || sides[0].second.sign != sides[1].second.sign,
                    [&] { return name() + " has both tetrahedra on one side"; });
            std::array<TetId, 2> stored = complex_.tets(f);
            std::sort(stored.begin(), stored.end());  // an invalid handle is the last
            require(
                stored[0] == sides[0].second.tet && stored[1] == (sides.size() == 2 ? sides[1].second.tet : TetId()),
                [&] { return name() + " does not know its tetrahedra"; });
        }
        require_each_once(seen, reconstruction_.faces.key_count(), "face");
    }

    template <std::size_t N>
    void require_each_once(std::vector<Key<N>>& seen, std::size_t expected, const std::string& kind) {
        std::sort(seen.begin(), seen.end());
        const auto twice = std::adjacent_find(seen.begin(), seen.end());
        require(twice == seen.end(), [&] { return kind + " " + text(*twice) + " occurs twice"; });
        require(seen.size() >= expected, [&] { return "a " + kind + " of a tetrahedron is missing"; });
    }

    // Numbers of boundary and interface faces at a simplex.
    template <class Surface, std::size_t N>
    static std::pair<std::uint32_t, std::uint32_t> surface_faces(const Surface& surface, const Key<N>& key) {
        std::pair<std::uint32_t, std::uint32_t> count;
        for (const auto& [simplex, is_boundary] : surface.find(key)) ++(is_boundary ? count.first : count.second);
        return count;
    }

    // Whether the tetrahedra at a simplex, in ascending order, are connected through faces that contain it.
    template <std::size_t N>
    bool is_connected(const Key<N>& simplex, std::span<const std::pair<Key<N>, TetId>> tets) {
        is_reached_.assign(tets.size(), 0);
        front_ = {0};
        is_reached_[0] = 1;
        std::size_t reached = 1;
        while (!front_.empty()) {
            const TetId t = tets[front_.back()].second;
            front_.pop_back();
            const TetVertices& v = complex_.vertices(t);
            for (std::size_t k = 0; k < 4; ++k) {
                if (std::find(simplex.begin(), simplex.end(), v[k]) != simplex.end()) continue;
                const TetId next = reconstruction_.neighbours[t.index()][k];
                if (!next.is_valid()) continue;
                const auto found = std::lower_bound(tets.begin(), tets.end(), next,
                                                    [](const auto& entry, TetId u) { return entry.second < u; });
                const auto place = static_cast<std::size_t>(found - tets.begin());
                if (is_reached_[place] != 0) continue;
                is_reached_[place] = 1;
                ++reached;
                front_.push_back(place);
            }
        }
        return reached == tets.size();
    }

    void check_edges() {
        std::vector<Key<2>> seen;
        for (std::uint32_t i = 0; i < complex_.edge_capacity(); ++i) {
            const EdgeId e(i);
            if (complex_.is_deleted(e)) continue;
            ++edges_;
            const Key<2> key = ascending(complex_.vertices(e)).first;
            const auto name = [&] { return "edge " + std::to_string(i) + " " + text(key); };
            seen.push_back(key);
            const auto tets = reconstruction_.edges.find(key);
            require(!tets.empty(), [&] { return name() + " belongs to no tetrahedron"; });
            if (tets.empty()) continue;
            const FaceId f = complex_.face(e);
            require(!complex_.is_deleted(f) &&
                        std::find(complex_.edges(f).begin(), complex_.edges(f).end(), e) != complex_.edges(f).end(),
                    [&] { return name() + ": its face does not contain it"; });
            const auto [boundary, interface] = surface_faces(reconstruction_.surface_at_edge, key);
            require((boundary != 0) == complex_.is_boundary(e) && (interface != 0) == complex_.is_interface(e) &&
                        complex_.surface_degree(e) == boundary + interface,
                    [&] { return name() + ": its flags are wrong"; });
            require(boundary == 0 || boundary == 2,
                    [&, faces = boundary] { return name() + " has " + std::to_string(faces) + " boundary faces"; });
            require(is_connected(key, tets), [&] { return name() + ": its star falls apart"; });
        }
        require_each_once(seen, reconstruction_.edges.key_count(), "edge");
    }

    void check_vertices() {
        for (std::uint32_t i = 0; i < complex_.vertex_capacity(); ++i) {
            const VertexId v(i);
            if (complex_.is_deleted(v)) continue;
            ++vertices_;
            const auto name = [&] { return "vertex " + std::to_string(i); };
            const Key<1> key = {v};
            const auto tets = reconstruction_.vertices.find(key);
            require(!tets.empty(), [&] { return name() + " belongs to no tetrahedron"; });
            if (tets.empty()) continue;
            const EdgeId e = complex_.edge(v);
            require(!complex_.is_deleted(e) && (complex_.vertices(e)[0] == v || complex_.vertices(e)[1] == v),
                    [&] { return name() + ": its edge does not contain it"; });
            const auto [boundary, interface] = surface_faces(reconstruction_.surface_at_vertex, key);
            require((boundary != 0) == complex_.is_boundary(v) && (interface != 0) == complex_.is_interface(v),
                    [&] { return name() + ": its flags are wrong"; });
            require(is_connected(key, tets), [&] { return name() + ": its star falls apart"; });
            require(reconstruction_.link_euler[i] == (boundary != 0 ? 1 : 2),
                    [&] { return name() + ": its link is neither a sphere nor a disc"; });
        }
        require(vertices_ == reconstruction_.vertices.key_count(),
                [] { return std::string("a vertex of a tetrahedron is missing"); });
    }

    void check_counts() {
        const auto require_count = [&](std::size_t found, std::size_t count, const std::string& kind) {
            require(found == count, [&] { return "the number of " + kind + " is wrong"; });
        };
        require_count(tets_, complex_.tet_count(), "tetrahedra");
        require_count(faces_, complex_.face_count(), "faces");
        require_count(edges_, complex_.edge_count(), "edges");
        require_count(vertices_, complex_.vertex_count(), "vertices");
    }

    const Complex& complex_;
    std::size_t limit_;
    Reconstruction reconstruction_;
    std::vector<std::string> problems_;
    std::vector<std::uint8_t> is_reached_;
    std::vector<std::size_t> front_;
    std::size_t tets_ = 0, faces_ = 0, edges_ = 0, vertices_ = 0;
};

}  // namespace

std::vector<std::string> validate(const Complex& complex, std::size_t limit) { return Check(complex, limit).run(); }

}  // namespace dsc::dsc3d
