// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a VTK data array one after the other, whatever type they have and however they are stored.
// As doubles, which hold every index and label exactly.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/tet/byte_source.h"
#include "io/text_scanner.h"

namespace dsc::io::tet {

enum class NumberType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

std::size_t size_of(NumberType type);

class NumberStream {
public:
    virtual ~NumberStream() = default;

    /// The next number; throws core::InputError when there is none.
    double next() {
        if (next_ == numbers_.size()) {
            refill(numbers_);
            next_ = 0;
        }
        return numbers_[next_++];
    }
    /// Finite.
    double coordinate();
    /// Whole; `what` it is, for a message.
    std::int64_t whole(const char* what);
    void skip(std::uint64_t count) {
        for (std::uint64_t i = 0; i < count; ++i) next();
    }
    /// Throws when numbers are left.
    virtual void require_end() = 0;
    /// An upper bound for how many numbers there are in all, to reserve memory by.
    virtual std::uint64_t most() const = 0;
    /// What is wrong with the number delivered last.
    [[noreturn]] virtual void fail(const std::string& problem, const std::string& cure) const = 0;

protected:
    std::size_t unread() const { return numbers_.size() - next_; }

private:
    /// Replaces `numbers` by at least one more.
    virtual void refill(std::vector<double>& numbers) = 0;

    std::vector<double> numbers_;
    std::size_t next_ = 0;
};

/// Numbers written as text.
std::unique_ptr<NumberStream> text_numbers(TextScanner scanner);

/// `count` numbers in binary; `source` is the file and `name` the array, for messages.
struct BinaryLayout {
    std::string source;
    std::string name;
    NumberType type = NumberType::float64;
    std::endian order = std::endian::little;
    std::uint64_t count = 0;
};
std::unique_ptr<NumberStream> binary_numbers(BinaryLayout layout, std::unique_ptr<ByteSource> bytes);

}  // namespace dsc::io::tet
