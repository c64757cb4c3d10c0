#include "scene/octree.h"

#include <algorithm>

namespace infra {
namespace {

constexpr std::size_t remembered_leaves = 4096;

std::size_t set_of(OctreeNode leaf) { return static_cast<std::size_t>(-2 - leaf); }

/// FNV-1a over the members, then mixed so that the low bits serve as a table index.
std::uint64_t hash_of(std::span<const PrimitiveId> set) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const PrimitiveId id : set) hash = (hash ^ static_cast<std::uint32_t>(id)) * 1099511628211ULL;
    return hash ^ (hash >> 29);
}

}  // namespace

bool Octree::same_leaf(OctreeNode a, OctreeNode b) const {
    return a == b || (is_leaf(a) && is_leaf(b) && std::ranges::equal(set(a), set(b)));
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

OctreeNode Octree::add_leaf(std::span<const PrimitiveId> wanted) {
    if (wanted.empty()) return empty_node;
    if (lately_.empty()) lately_.resize(remembered_leaves);
    const std::uint64_t hash = hash_of(wanted);
    Remembered& known = lately_[hash % remembered_leaves];
    if (known.leaf == empty_node || known.hash != hash || !std::ranges::equal(set(known.leaf), wanted)) {
        members_.insert(members_.end(), wanted.begin(), wanted.end());
        set_begin_.push_back(static_cast<std::uint32_t>(members_.size()));
        known = {hash, -2 - static_cast<OctreeNode>(set_begin_.size() - 2)};
    }
    return known.leaf;
}

}  // namespace infra
