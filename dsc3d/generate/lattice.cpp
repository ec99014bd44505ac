// SPDX-License-Identifier: GPL-3.0-or-later
#include "dsc3d/generate/lattice.h"

#include <cmath>

#include "core/errors.h"

namespace dsc::dsc3d {

namespace {

using Index = std::array<std::uint32_t, 3>;

class Lattice {
public:
    Lattice(const Eigen::AlignedBox3d& box, const Index& cells) : box_(box), cells_(cells) {}

    geometry::TetData build() {
        place_vertices();
        for (std::size_t axis = 0; axis < 3; ++axis) add_tets_across(axis);
        return std::move(data_);
    }

private:
    std::uint32_t corner(const Index& i) const { return (i[2] * (cells_[1] + 1) + i[1]) * (cells_[0] + 1) + i[0]; }
    std::uint32_t centre(const Index& i) const { return corner_count() + (i[2] * cells_[1] + i[1]) * cells_[0] + i[0]; }
    std::uint32_t corner_count() const { return (cells_[0] + 1) * (cells_[1] + 1) * (cells_[2] + 1); }

    template <class Use>
    void for_each(const Index& count, Use&& use) {
        for (std::uint32_t z = 0; z < count[2]; ++z)
            for (std::uint32_t y = 0; y < count[1]; ++y)
                for (std::uint32_t x = 0; x < count[0]; ++x) use(Index{x, y, z});
    }

    // The sides of the box get its very coordinates.
    Eigen::Vector3d place(const Index& i, double offset) const {
        Eigen::Vector3d p;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const double share = (i[k] + offset) / cells_[k];
            p[axis] = share == 1 ? box_.max()[axis] : box_.min()[axis] + share * box_.sizes()[axis];
        }
        return p;
    }

    void place_vertices() {
        for_each({cells_[0] + 1, cells_[1] + 1, cells_[2] + 1},
                 [&](const Index& i) { data_.vertices.push_back(place(i, 0)); });
        for_each(cells_, [&](const Index& i) { data_.vertices.push_back(place(i, 0.5)); });
    }

    // Around each square orthogonal to the axis: four tetrahedra between the centres on either side of it, or half a
    // pyramid each side of its diagonal on a side of the box.
    void add_tets_across(std::size_t axis) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        Index squares = cells_;
        ++squares[axis];
        for_each(squares, [&](const Index& i) {
            std::array<std::uint32_t, 4> around;  // counterclockwise seen from above the square
            Index at = i;
            around[0] = corner(at), ++at[u];
            around[1] = corner(at), ++at[v];
            around[2] = corner(at), --at[u];
            around[3] = corner(at);
            Index below = i;
            --below[axis];
            if (i[axis] == 0) {
                add_pyramid({around[0], around[1], around[2], around[3]}, centre(i));
            } else if (i[axis] == cells_[axis]) {
                add_pyramid({around[3], around[2], around[1], around[0]}, centre(below));
            } else {
                for (std::size_t k = 0; k < 4; ++k)
                    data_.tets.push_back({centre(below), centre(i), around[k], around[(k + 1) % 4]});
            }
        });
    }

    // The base is counterclockwise seen from the apex.
    void add_pyramid(const std::array<std::uint32_t, 4>& base, std::uint32_t apex) {
        data_.tets.push_back({base[0], base[1], base[2], apex});
        data_.tets.push_back({base[0], base[2], base[3], apex});
    }

    Eigen::AlignedBox3d box_;
    Index cells_;
    geometry::TetData data_;
};

}  // namespace

geometry::TetData lattice(const Eigen::AlignedBox3d& box, double spacing) {
    if (!(box.sizes().minCoeff() > 0) || !box.sizes().allFinite())
        throw core::UsageError("lattice: the box has to have a positive size in every direction");
    if (!(spacing > 0)) throw core::UsageError("lattice: the spacing has to be positive");
    const Eigen::Vector3d cells = (box.sizes() / spacing).array().round().max(1);
    if (2 * cells.prod() > 0x1p30) throw core::UsageError("lattice: the spacing is too small for the box");
    return Lattice(box, {static_cast<std::uint32_t>(cells.x()), static_cast<std::uint32_t>(cells.y()),
                         static_cast<std::uint32_t>(cells.z())})
        .build();
}

}  // namespace dsc::dsc3d
