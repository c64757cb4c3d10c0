// Memory for large arrays that are read in no order: the system is asked to back it with large pages, so that
// a ray's way through a scene of a hundred megabytes is not one of missing address translations.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <utility>
#include <vector>

namespace infra {

template <class T>
struct LargePageAllocator {
    using value_type = T;

    static constexpr std::size_t page = std::size_t{2} << 20;

    LargePageAllocator() = default;
    template <class Other>
    LargePageAllocator(const LargePageAllocator<Other>&) {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (bytes < page) return static_cast<T*>(::operator new (bytes, std::align_val_t{alignof(T)}));
        void* const memory = std::aligned_alloc(page, (bytes + page - 1) / page * page);
        if (!memory) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
        madvise(memory, bytes, MADV_HUGEPAGE);  // if it is refused, small pages do
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) {
        if (count * sizeof(T) < page)
            ::operator delete (memory, std::align_val_t{alignof(T)});
        else
            std::free(memory);
    }
    /// What vectors do to new elements of no given value: nothing if they are plain, so that no page is
    /// touched.
    template <class U>
    void construct(U* place) {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Arguments>
    void construct(U* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
    }
    bool operator==(const LargePageAllocator&) const { return true; }
};

template <class T>
using LargeVector = std::vector<T, LargePageAllocator<T>>;

}  // namespace infra
