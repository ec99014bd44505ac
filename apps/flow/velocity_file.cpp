// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/velocity_file.h"

#include <algorithm>
#include <utility>

#include "core/errors.h"
#include "io/vti.h"
#include "motion/grid_field.h"

namespace dsc::flow {

template <int Dimension>
motion::VelocityField<Dimension> velocity_from_file(const std::string& path, const std::string& array) {
    const io::ImageData image = io::read_vti(path);
    const std::vector<double>& values = image.array(array, 3).values;
    if (Dimension == 2 && image.counts[2] != 1)
        throw core::InputError(path, "", "has " + std::to_string(image.counts[2]) + " layers", "the plane needs one");
    motion::VelocityGrid<Dimension> grid{.origin = image.origin.head<Dimension>(),
                                         .spacing = image.spacing.head<Dimension>()};
    std::copy_n(image.counts.begin(), Dimension, grid.counts.begin());
    for (std::size_t i = 0; i < values.size(); i += 3)
        grid.velocities.push_back(Eigen::Map<const motion::Vector<Dimension>>(values.data() + i));
    return motion::grid_field<Dimension>(std::move(grid));
}

template motion::VelocityField<2> velocity_from_file<2>(const std::string& path, const std::string& array);
template motion::VelocityField<3> velocity_from_file<3>(const std::string& path, const std::string& array);

}  // namespace dsc::flow
