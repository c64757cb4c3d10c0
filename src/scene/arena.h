// Append-only storage whose elements never move: what is stored stays valid as long as the arena, also when
// it is moved.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace infra {

template <class T>
class Arena {
  public:
    /// Copies `values` in; the copy is contiguous.
    /// shape: n values -> pointer to n values (nullptr for none)
    const T* store(std::span<const T> values) {
        if (values.empty()) return nullptr;
        if (values.size() > capacity_ - used_) grow(values.size());
        T* const place = blocks_.back().get() + used_;
        std::copy(values.begin(), values.end(), place);
        used_ += values.size();
        return place;
    }

  private:
    static constexpr std::size_t block_size = 16384;

    void grow(std::size_t needed) {
        capacity_ = std::max(block_size, needed);
        blocks_.push_back(std::make_unique<T[]>(capacity_));
        used_ = 0;
        total_ += capacity_;
    }

    std::vector<std::unique_ptr<T[]>> blocks_;
    std::size_t used_ = 0;
    std::size_t capacity_ = 0;
    std::size_t total_ = 0;
};

}  // namespace infra
