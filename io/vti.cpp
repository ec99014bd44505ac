// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vti.h"

#include <cmath>
#include <limits>

#include "core/errors.h"
#include "io/tet/vtk_xml.h"

namespace dsc::io {

namespace {

class VtiReader {
public:
    explicit VtiReader(const std::filesystem::path& path)
        : source_(path.string()), xml_(path, "ImageData", "save it again as .vti (ParaView: Save Data)") {}

    ImageData read() {
        const pugi::xml_node piece = xml_.only_piece("has several pieces", "save it as a single piece");
        ImageData image{.source = source_};
        const auto extent = numbers<6>(piece, "Extent", nullptr);
        const auto origin = numbers<3>(xml_.grid(), "Origin", "0 0 0");
        const auto spacing = numbers<3>(xml_.grid(), "Spacing", "1 1 1");
        require_axes();
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = static_cast<Eigen::Index>(k);
            if (!(spacing[k] > 0)) xml_.fail("element ImageData", "Spacing is not positive");
            image.spacing[i] = spacing[k];
            image.origin[i] = origin[k] + extent[2 * k] * spacing[k];
            image.counts[k] = count(extent[2 * k], extent[2 * k + 1]);
        }
        read_arrays(piece.child("PointData"), image);
        return image;
    }

private:
    /// The numbers of an attribute; of `missing` when there is none.
    template <std::size_t Count>
    std::array<double, Count> numbers(pugi::xml_node node, const char* name, const char* missing) const {
        const pugi::xml_attribute attribute = node.attribute(name);
        if (!attribute && missing == nullptr) {
            xml_.fail("element " + std::string(node.name()), "has no attribute " + std::string(name));
        }
        TextScanner scanner(source_, attribute ? attribute.value() : missing,
                            {.within = "the attribute " + std::string(name)});
        std::array<double, Count> values{};
        for (double& value : values) value = scanner.real("a number");
        scanner.require_end("numbers");
        return values;
    }

    void require_axes() const {
        const auto direction = numbers<9>(xml_.grid(), "Direction", "1 0 0 0 1 0 0 0 1");
        for (std::size_t k = 0; k < 9; ++k) {
            if (direction[k] != (k % 4 == 0 ? 1 : 0)) {
                xml_.fail("element ImageData", "the grid is not parallel to the axes",
                          "resample it (ParaView: filter Resample To Image)");
            }
        }
    }

    std::size_t count(double first, double last) const {
        constexpr double most = std::numeric_limits<std::int32_t>::max();
        if (std::floor(first) != first || std::floor(last) != last || !(first <= last) || !(last - first < most)) {
            xml_.fail("element Piece", "Extent is no range of whole numbers");
        }
        return static_cast<std::size_t>(last - first) + 1;
    }

    void read_arrays(pugi::xml_node parent, ImageData& image) const {
        // As doubles, which do not overflow; an array that is not so long is refused before memory is reserved for it.
        const double points = static_cast<double>(image.counts[0]) * static_cast<double>(image.counts[1]) *
                              static_cast<double>(image.counts[2]);
        for (const pugi::xml_node array : parent.children("DataArray")) {
            VtkData data{.name = array.attribute("Name").value(),
                         .components = array.attribute("NumberOfComponents").as_int(1)};
            const std::string place = "array " + in_quotes(data.name);
            if (data.components < 1) xml_.fail(place, "has no components");
            const double size = points * data.components;
            if (size > 0x1p53) xml_.fail("element Piece", "Extent is too large");
            const auto values = static_cast<std::uint64_t>(size);
            const std::unique_ptr<tet::NumberStream> stream = xml_.open(array, values);
            data.values.reserve(values);
            for (std::uint64_t i = 0; i < values; ++i) data.values.push_back(stream->next());
            stream->require_end();
            image.point_data.push_back(std::move(data));
        }
    }

    std::string source_;
    tet::VtkXml xml_;
};

}  // namespace

const VtkData& ImageData::array(const std::string& name, int components) const {
    const VtkData* found = nullptr;
    int fitting = 0;
    std::string names;
    for (const VtkData& data : point_data) {
        names += (names.empty() ? "" : ", ") + data.name + " (" + std::to_string(data.components) + ")";
        if (data.components != components || (!name.empty() && data.name != name)) continue;
        ++fitting;
        found = &data;
    }
    if (fitting == 1) return *found;
    const std::string wanted = "with " + std::to_string(components) + " components at its points";
    const std::string there = names.empty() ? "there are none" : "there are " + names;
    if (fitting > 1) throw core::InputError(source, "", "has several arrays " + wanted, "name one: " + there);
    throw core::InputError(source, "", "has no array " + (name.empty() ? "" : in_quotes(name) + " ") + wanted, there);
}

ImageData read_vti(const std::filesystem::path& path) { return VtiReader(path).read(); }

}  // namespace dsc::io
