// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/manifold_interface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "dsc3d/complex/traversal.h"

namespace dsc::dsc3d {

namespace {

class Pieces {
public:
    explicit Pieces(Mesh& mesh) : mesh_(mesh), complex_(mesh.complex()), walker_(complex_) {}

    // The smaller pieces of either label at v, when there is more than one of one of them. Two pieces of a star hang
    // together across faces at v.
    bool find_at(VertexId v) {
        found_.clear();
        const std::span<const TetId> star = walker_.star(v);
        star_.assign(star.begin(), star.end());
        std::sort(star_.begin(), star_.end());
        piece_.assign(star_.size(), -1);
        volumes_.clear();
        labels_.clear();
        for (std::size_t first = 0; first < star_.size(); ++first)
            if (piece_[first] < 0) flood(v, first);
        std::size_t smallest = volumes_.size();
        for (std::size_t p = 0; p < volumes_.size(); ++p) {
            const auto rivals = std::count(labels_.begin(), labels_.end(), labels_[p]);
            if (rivals > 1 && (smallest == volumes_.size() || volumes_[p] < volumes_[smallest])) smallest = p;
        }
        if (smallest == volumes_.size()) return false;
        for (std::size_t i = 0; i < star_.size(); ++i)
            if (piece_[i] == static_cast<int>(smallest)) found_.push_back(star_[i]);
        return true;
    }

    // The smallest sector of tetrahedra of one label around e, when there are more than two sectors.
    bool find_at(EdgeId e) {
        found_.clear();
        if (complex_.is_boundary(e) || complex_.surface_degree(e) <= 2) return false;
        gather_ring(complex_, e, ring_);
        const std::size_t n = ring_.tets.size();
        const auto label = [&](std::size_t i) { return complex_.label(ring_.tets[i % n]); };
        std::size_t begin = 0, end = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < n; ++i) {
            if (label(i) == label(i + n - 1)) continue;
            std::size_t k = i;
            double volume = 0;
            for (; label(k) == label(i); ++k) volume += volume_of(ring_.tets[k % n]);
            if (volume >= least) continue;
            least = volume, begin = i, end = k;
        }
        for (std::size_t i = begin; i < end; ++i) found_.push_back(ring_.tets[i % n]);
        return true;
    }

    std::span<const TetId> found() const { return found_; }

private:
    void flood(VertexId v, std::size_t first) {
        const int piece = static_cast<int>(volumes_.size());
        const int label = complex_.label(star_[first]);
        volumes_.push_back(0);
        labels_.push_back(label);
        piece_[first] = piece;
        front_.assign(1, first);
        while (!front_.empty()) {
            const std::size_t here = front_.back();
            front_.pop_back();
            volumes_.back() += volume_of(star_[here]);
            for (int k = 0; k < 4; ++k) {
                if (complex_.vertices(star_[here])[static_cast<std::size_t>(k)] == v) continue;
                const TetId next = complex_.neighbour(star_[here], k);
                if (!next.is_valid() || complex_.label(next) != label) continue;
                const auto at =
                    static_cast<std::size_t>(std::lower_bound(star_.begin(), star_.end(), next) - star_.begin());
                if (piece_[at] >= 0) continue;
                piece_[at] = piece;
                front_.push_back(at);
            }
        }
    }

    double volume_of(TetId t) const {
        const TetVertices& v = complex_.vertices(t);
        const Point3& a = mesh_.position(v[0]);
        return (mesh_.position(v[1]) - a).dot((mesh_.position(v[2]) - a).cross(mesh_.position(v[3]) - a)) / 6;
    }

    Mesh& mesh_;
    Complex& complex_;
    StarWalker walker_;
    EdgeRing ring_;
    std::vector<TetId> star_;
    std::vector<int> piece_;  ///< of each in star_
    std::vector<double> volumes_;
    std::vector<int> labels_;
    std::vector<std::size_t> front_;
    std::vector<TetId> found_;
};

}  // namespace

ManifoldInterfaceReport make_interface_manifold(Mesh& mesh, int inside, int outside, int most_rounds) {
    Complex& complex = mesh.complex();
    Pieces pieces(mesh);
    ManifoldInterfaceReport report;
    const auto turn = [&](std::span<const TetId> tets) {
        for (const TetId t : tets) complex.set_label(t, complex.label(t) == inside ? outside : inside);
        report.relabelled += tets.size();
    };
    for (int round = 0; round <= most_rounds; ++round) {
        report.pinches = 0;
        const bool is_last = round == most_rounds;
        for (std::uint32_t i = 0; i < complex.edge_capacity(); ++i) {
            if (complex.is_deleted(EdgeId(i)) || !pieces.find_at(EdgeId(i))) continue;
            ++report.pinches;
            if (!is_last) turn(pieces.found());
        }
        for (std::uint32_t i = 0; i < complex.vertex_capacity(); ++i) {
            const VertexId v(i);
            if (complex.is_deleted(v) || !complex.is_interface(v) || complex.is_boundary(v)) continue;
            if (!pieces.find_at(v)) continue;
            ++report.pinches;
            if (!is_last) turn(pieces.found());
        }
        if (report.pinches == 0) break;
    }
    return report;
}

}  // namespace dsc::dsc3d
