#include "scene/octree.h"

#include <algorithm>

namespace infra {
namespace {

constexpr std::int32_t free_slot = -1;

OctreeNode leaf_of(std::size_t set) { return -2 - static_cast<OctreeNode>(set); }
std::size_t set_of(OctreeNode leaf) { return static_cast<std::size_t>(-2 - leaf); }

/// FNV-1a over the members, then mixed so that the low bits serve as a table index.
std::size_t hash_of(std::span<const PrimitiveId> set) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const PrimitiveId id : set) hash = (hash ^ static_cast<std::uint32_t>(id)) * 1099511628211ULL;
    return hash ^ (hash >> 29);
}

}  // namespace

bool Octree::same_leaf(OctreeNode a, OctreeNode b) const {
    return a == b ||
           (sets_ == Sets::separate && is_leaf(a) && is_leaf(b) && std::ranges::equal(set(a), set(b)));
}

OctreeNode Octree::add_inner(std::span<const OctreeNode, 8> children) {
    const OctreeNode first = children[0];
    const bool uniform =
        !is_inner(first) && std::ranges::all_of(children, [&](OctreeNode c) { return same_leaf(c, first); });
    if (uniform) return first;
    children_.insert(children_.end(), children.begin(), children.end());
    return static_cast<OctreeNode>(children_.size() / 8 - 1);
}

std::span<const PrimitiveId> Octree::set(OctreeNode leaf) const {
    const std::size_t i = set_of(leaf);
    return std::span(members_).subspan(set_begin_[i], set_begin_[i + 1] - set_begin_[i]);
}

std::size_t Octree::slot_of(std::span<const PrimitiveId> wanted) const {
    const std::size_t mask = table_.size() - 1;
    std::size_t slot = hash_of(wanted) & mask;
    while (table_[slot] != free_slot && !std::ranges::equal(set(leaf_of(table_[slot])), wanted))
        slot = (slot + 1) & mask;
    return slot;
}

void Octree::grow_table() {
    table_.assign(std::max<std::size_t>(1024, 2 * table_.size()), free_slot);
    for (std::size_t i = 0; i + 1 < set_begin_.size(); ++i)
        table_[slot_of(set(leaf_of(i)))] = static_cast<std::int32_t>(i);
}

OctreeNode Octree::append_leaf(std::span<const PrimitiveId> set) {
    members_.insert(members_.end(), set.begin(), set.end());
    set_begin_.push_back(static_cast<std::uint32_t>(members_.size()));
    return leaf_of(set_begin_.size() - 2);
}

OctreeNode Octree::add_leaf(std::span<const PrimitiveId> wanted) {
    if (wanted.empty()) return empty_node;
    if (sets_ == Sets::separate) return append_leaf(wanted);
    if (2 * set_begin_.size() > table_.size()) grow_table();
    const std::size_t slot = slot_of(wanted);
    if (table_[slot] == free_slot) table_[slot] = static_cast<std::int32_t>(set_of(append_leaf(wanted)));
    return leaf_of(static_cast<std::size_t>(table_[slot]));
}

}  // namespace infra
