// SPDX-License-Identifier: GPL-3.0-or-later
// Attributes: one array per question ("label of a face", "target of a vertex") that follows its mesh, growing when the
// mesh grows and permuted when the mesh is compacted.
// Guarantee: after every change of the mesh an attribute has exactly one value per handle; an attribute may outlive its
// mesh. Cost: reading is one array access; growth is amortized constant; compaction is linear.
//
//     core::Attribute<core::VertexId, double> angle(complex.vertex_attributes(), 0.0);
//     angle[v] = 0.5;
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/assert.h"

namespace dsc::core {

/// The arrays that follow one kind of handle of one mesh. Held by the mesh, shared with its attributes.
template <class Handle>
class AttributeRegistry {
public:
    /// What the registry sees of an attribute.
    class Follower {
    public:
        virtual ~Follower() = default;
        virtual void resize(std::size_t count) = 0;
        virtual void reset(std::size_t index) = 0;
        virtual void compact(std::span<const std::uint32_t> new_to_old) = 0;
    };

    std::size_t size() const { return size_; }
    void add(Follower* follower) { followers_.push_back(follower); }
    void remove(Follower* follower) { std::erase(followers_, follower); }

    /// Called by the mesh after it added elements.
    void resize(std::size_t count) {
        if (count == size_) return;
        size_ = count;
        for (Follower* follower : followers_) follower->resize(count);
    }
    /// Called by the mesh when a freed element is used again: it is a new one, with the default values.
    void reset(Handle handle) {
        for (Follower* follower : followers_) follower->reset(handle.index());
    }
    /// Called by the mesh after compaction: element i of the new numbering was element new_to_old[i].
    void compact(std::span<const std::uint32_t> new_to_old) {
        size_ = new_to_old.size();
        for (Follower* follower : followers_) follower->compact(new_to_old);
    }

private:
    std::vector<Follower*> followers_;
    std::size_t size_ = 0;
};

/// One value of type T per handle; new elements get the default value given at construction.
template <class Handle, class T>
class Attribute final : private AttributeRegistry<Handle>::Follower {
    static_assert(!std::is_same_v<T, bool>, "std::vector<bool> has no references; use std::uint8_t");

public:
    explicit Attribute(std::shared_ptr<AttributeRegistry<Handle>> registry, T default_value = T())
        : registry_(std::move(registry)), default_(std::move(default_value)), values_(registry_->size(), default_) {
        registry_->add(this);
    }
    Attribute(const Attribute& other) : registry_(other.registry_), default_(other.default_), values_(other.values_) {
        registry_->add(this);
    }
    Attribute& operator=(const Attribute& other) {
        if (this == &other) return *this;
        registry_->remove(this);
        registry_ = other.registry_;
        default_ = other.default_;
        values_ = other.values_;
        registry_->add(this);
        return *this;
    }
    ~Attribute() override { registry_->remove(this); }

    T& operator[](Handle handle) {
        DSC_ASSERT(handle.index() < values_.size());
        return values_[handle.index()];
    }
    const T& operator[](Handle handle) const {
        DSC_ASSERT(handle.index() < values_.size());
        return values_[handle.index()];
    }
    std::size_t size() const { return values_.size(); }
    std::span<const T> values() const { return values_; }
    void fill(const T& value) { std::fill(values_.begin(), values_.end(), value); }

private:
    void resize(std::size_t count) override { values_.resize(count, default_); }
    void reset(std::size_t index) override { values_[index] = default_; }
    void compact(std::span<const std::uint32_t> new_to_old) override {
        std::vector<T> kept;
        kept.reserve(new_to_old.size());
        for (const std::uint32_t old : new_to_old) kept.push_back(std::move(values_[old]));
        values_ = std::move(kept);
    }

    std::shared_ptr<AttributeRegistry<Handle>> registry_;
    T default_;
    std::vector<T> values_;
};

}  // namespace dsc::core
