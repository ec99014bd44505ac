// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tet/number_stream.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/errors.h"

namespace dsc::io::tet {

namespace {

constexpr const char* truncated = "the file is truncated or a count is wrong";

class TextNumbers : public NumberStream {
public:
    explicit TextNumbers(TextScanner scanner) : scanner_(std::move(scanner)), most_(scanner_.rest().size() / 2 + 1) {}

    void require_end() override { scanner_.require_end("numbers"); }
    std::uint64_t most() const override { return most_; }
    void fail(const std::string& problem, const std::string& cure) const override { scanner_.fail(problem, cure); }

private:
    // One at a time, so that the scanner stands at the number delivered last.
    void refill(std::vector<double>& numbers) override { numbers.assign(1, scanner_.real("a number")); }

    TextScanner scanner_;
    std::uint64_t most_;
};

template <class T>
void convert(const std::vector<char>& bytes, bool is_swapped, std::vector<double>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        char image[sizeof(T)];
        std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(i * sizeof(T)), sizeof(T), image);
        if (is_swapped) std::reverse(image, image + sizeof(T));
        T value;
        std::memcpy(&value, image, sizeof(T));
        numbers[i] = static_cast<double>(value);
    }
}

class BinaryNumbers : public NumberStream {
public:
    BinaryNumbers(BinaryLayout layout, std::unique_ptr<ByteSource> bytes)
        : layout_(std::move(layout)), bytes_(std::move(bytes)) {}

    void require_end() override {
        if (decoded_ != layout_.count || unread() != 0) {
            fail("there are more numbers than announced", "correct the counts");
        }
    }
    std::uint64_t most() const override { return layout_.count; }
    void fail(const std::string& problem, const std::string& cure) const override {
        throw core::InputError(layout_.source, "number " + std::to_string(decoded_ - unread()) + " of " + layout_.name,
                               problem, cure);
    }

private:
    void refill(std::vector<double>& numbers) override {
        constexpr std::uint64_t chunk = 4096;
        const std::uint64_t count = std::min(chunk, layout_.count - decoded_);
        if (count == 0) fail("there are fewer numbers than announced", truncated);
        image_.resize(count * size_of(layout_.type));
        if (!bytes_->read(image_)) fail("the data ends behind this number or is damaged", "get the file again, whole");
        numbers.resize(count);
        convert(numbers);
        decoded_ += count;
    }

    void convert(std::vector<double>& numbers) const {
        const bool is_swapped = layout_.order != std::endian::native;
        switch (layout_.type) {
            case NumberType::int8: return tet::convert<std::int8_t>(image_, is_swapped, numbers);
            case NumberType::uint8: return tet::convert<std::uint8_t>(image_, is_swapped, numbers);
            case NumberType::int16: return tet::convert<std::int16_t>(image_, is_swapped, numbers);
            case NumberType::uint16: return tet::convert<std::uint16_t>(image_, is_swapped, numbers);
            case NumberType::int32: return tet::convert<std::int32_t>(image_, is_swapped, numbers);
            case NumberType::uint32: return tet::convert<std::uint32_t>(image_, is_swapped, numbers);
            case NumberType::int64: return tet::convert<std::int64_t>(image_, is_swapped, numbers);
            case NumberType::uint64: return tet::convert<std::uint64_t>(image_, is_swapped, numbers);
            case NumberType::float32: return tet::convert<float>(image_, is_swapped, numbers);
            case NumberType::float64: return tet::convert<double>(image_, is_swapped, numbers);
        }
    }

    BinaryLayout layout_;
    std::unique_ptr<ByteSource> bytes_;
    std::vector<char> image_;
    std::uint64_t decoded_ = 0;
};

}  // namespace

std::size_t size_of(NumberType type) {
    switch (type) {
        case NumberType::int8:
        case NumberType::uint8: return 1;
        case NumberType::int16:
        case NumberType::uint16: return 2;
        case NumberType::int32:
        case NumberType::uint32:
        case NumberType::float32: return 4;
        default: return 8;
    }
}

double NumberStream::coordinate() {
    const double value = next();
    if (!std::isfinite(value)) fail("a coordinate is not a finite number", "correct it");
    return value;
}

std::int64_t NumberStream::whole(const char* what) {
    const double value = next();
    // Beyond 2^53 neighbours could not be told apart; nothing that is counted gets there.
    if (!(std::abs(value) <= 0x1p53) || value != std::floor(value)) {
        fail(std::string(what) + " is not a whole number", "correct it");
    }
    return static_cast<std::int64_t>(value);
}

std::unique_ptr<NumberStream> text_numbers(TextScanner scanner) {
    return std::make_unique<TextNumbers>(std::move(scanner));
}

std::unique_ptr<NumberStream> binary_numbers(BinaryLayout layout, std::unique_ptr<ByteSource> bytes) {
    return std::make_unique<BinaryNumbers>(std::move(layout), std::move(bytes));
}

}  // namespace dsc::io::tet
