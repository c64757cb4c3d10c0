#include "rt/photons/photon_map.h"

#include <sys/mman.h>

#include <algorithm>

namespace infra {
namespace {

/// Nodes of the subtree under `node` in a heap of `count` nodes numbered from 1.
std::size_t subtree_size(std::size_t node, std::size_t count) {
    std::size_t size = 0;
    for (std::size_t first = node, width = 1; first <= count; first *= 2, width *= 2)
        size += std::min(width, count - first + 1);
    return size;
}

/// Searches jump about: with pages of 4 KB each jump would look its page up too. To be called before the memory
/// is touched; a system that knows no such pages refuses without harm.
void ask_for_large_pages(const std::vector<float>& memory) {
    constexpr std::uintptr_t page = 4096;
    const auto first = (reinterpret_cast<std::uintptr_t>(memory.data()) + page - 1) & ~(page - 1);
    const auto end = reinterpret_cast<std::uintptr_t>(memory.data() + memory.capacity());
    if (end > first + page) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

}  // namespace

std::string_view name_of(PhotonKind kind) {
    constexpr std::string_view names[photon_kinds] = {"global", "precomputed", "caustic",
                                                      "volume", "direct",      "contribution"};
    return names[static_cast<std::size_t>(kind)];
}

PhotonMap::PhotonMap(PhotonKind kind, std::size_t count, double spread2)
    : kind_(kind), size_(count), spread2_(spread2) {
    const auto levels = static_cast<std::size_t>(std::bit_width(count));
    inner_levels_ = static_cast<int>(levels - std::min(levels, leaf_levels));
    const std::size_t leaves = std::size_t{1} << inner_levels_;
    inner_count_ = static_cast<std::uint32_t>(leaves - 1);
    words_.reserve(words_of_photon * count);
    ask_for_large_pages(words_);
    words_.resize(words_of_photon * count);
    start_.reserve(leaves + 1);
    std::size_t start = inner_count_;
    for (std::size_t leaf = 0; leaf < leaves; ++leaf) {
        start_.push_back(static_cast<std::uint32_t>(start));
        start += subtree_size(leaves + leaf, count);
    }
    start_.push_back(static_cast<std::uint32_t>(start));
}

void PhotonMap::place(std::size_t number, const Photon& photon) {
    const std::size_t node = number + 1;
    std::array<std::int8_t, 4> direction{photon.direction[0], photon.direction[1], photon.direction[2],
                                         std::bit_cast<std::int8_t>(photon.flags)};
    float* position = nullptr;
    float* attributes = nullptr;
    std::size_t stride = 1;
    if (number < inner_count_) {
        position = &words_[words_of_photon * number];
        attributes = position + 3;
    } else {
        const int below = std::bit_width(node) - 1 - inner_levels_;
        const std::size_t root = node >> below;
        const std::size_t leaf = root - inner_count_ - 1;
        const std::size_t within = (std::size_t{1} << below) - 1 + (node - (root << below));
        stride = start_[leaf + 1] - start_[leaf];
        float* const block = &words_[words_of_photon * start_[leaf]];
        position = block + within;
        attributes = block + 3 * stride + 2 * within;
    }
    for (std::size_t i = 0; i < 3; ++i) position[i * stride] = photon.position[i];
    attributes[0] = std::bit_cast<float>(photon.flux);
    attributes[1] = std::bit_cast<float>(direction);
}

}  // namespace infra
