// Append-only storage whose elements never move: what is stored stays valid as long as the arena, also when
// it is moved.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "common/large_pages.h"

namespace infra {

template <class T>
class Arena {
  public:
    /// Copies `values` in; the copy is contiguous.
    /// shape: n values -> pointer to n values (nullptr for none)
    const T* store(std::span<const T> values) {
        if (values.empty()) return nullptr;
        if (values.size() > capacity_ - used_) grow(values.size());
        T* const place = blocks_.back().data() + used_;
        std::copy(values.begin(), values.end(), place);
        used_ += values.size();
        return place;
    }

  private:
    static constexpr std::size_t least_size = (std::size_t{1} << 14) / sizeof(T);
    static constexpr std::size_t usual_size = LargePageAllocator<T>::page / sizeof(T);

    /// Blocks as large as all before them, up to one large page.
    void grow(std::size_t needed) {
        capacity_ = std::max(std::clamp(total_, least_size, usual_size), needed);
        blocks_.emplace_back(capacity_);
        used_ = 0;
        total_ += capacity_;
    }

    std::vector<LargeVector<T>> blocks_;
    std::size_t used_ = 0;
    std::size_t capacity_ = 0;
    std::size_t total_ = 0;
};

}  // namespace infra
