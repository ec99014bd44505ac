// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/checkpoint_fields.h"

namespace dsc::motion {

void FieldWriter::write(CheckpointWriter& out, const std::string& name) const {
    out.add_array<std::int64_t>(name + " integers", integers_);
    out.add_array<double>(name + " reals", reals_);
    out.add_text(name + " text", text_);
}

FieldReader::FieldReader(CheckpointReader& in, const std::string& name)
    : in_(in),
      name_(name),
      integers_(in.array<std::int64_t>(name + " integers")),
      reals_(in.array<double>(name + " reals")),
      text_(in.text(name + " text")) {}

void FieldReader::require_end() const {
    if (next_integer_ != integers_.size() || next_real_ != reals_.size() || next_character_ != text_.size())
        fail("has more values than expected");
}

void FieldReader::real(double& value) {
    if (next_real_ == reals_.size()) fail("has fewer values than expected");
    value = reals_[next_real_++];
}

void FieldReader::text(std::string& value) {
    const std::size_t size = next_size();
    if (size > text_.size() - next_character_) fail("has less text than it announces");
    value = text_.substr(next_character_, size);
    next_character_ += size;
}

std::int64_t FieldReader::next() {
    if (next_integer_ == integers_.size()) fail("has fewer values than expected");
    return integers_[next_integer_++];
}

// Of a list: each of its members takes one value at least.
std::size_t FieldReader::next_size() {
    const std::int64_t size = next();
    const std::size_t left =
        integers_.size() - next_integer_ + reals_.size() - next_real_ + text_.size() - next_character_;
    if (size < 0 || static_cast<std::uint64_t>(size) > left) fail("has fewer values than it announces");
    return static_cast<std::size_t>(size);
}

void FieldReader::fail(const char* problem) const { in_.fail("entry '" + name_ + "'", problem); }

}  // namespace dsc::motion
