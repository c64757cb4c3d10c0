// Photons as a program for forward tracing has left them, in a kd-tree that is quick to search. Immutable
// once filled, and shared by all threads.
//
// The file's tree is kept, but not its order: the upper levels stay a heap, and each of the small trees below
// becomes a leaf whose photons lie together, coordinate by coordinate. 20 bytes a photon.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "common/pictures/rgbe.h"

namespace infra {

/// What the photons of a map stand for; the order of their formats' names in photon_file.cpp.
enum class PhotonKind {
    global,        ///< all light that has been scattered by a surface at least once
    precomputed,   ///< at some of these places radiance, irradiance over pi, in place of flux
    caustic,       ///< light from specular surfaces on diffuse ones
    volume,        ///< collisions in media; the direction is the photon's
    direct,        ///< light straight from sources
    contribution,  ///< as global, in equal numbers for all sources; caustic ones are marked
};
inline constexpr int photon_kinds = 6;

std::string_view name_of(PhotonKind kind);

/// One record of a file.
struct Photon {
    std::array<float, 3> position;
    Rgbe flux;                             ///< [W], or radiance [W m^-2 sr^-1] where precomputed
    std::array<std::int8_t, 3> direction;  ///< normal of the surface or way of the photon, 127 times
    std::uint8_t flags;                    ///< axis of its node in bits 0 and 1, caustic in bit 2

    int axis() const { return flags & 3; }
    bool is_caustic() const { return (flags & 4) != 0; }
};

class PhotonMap {
  public:
    static constexpr std::size_t most_photons = std::size_t{1} << 29;

    /// An empty map for `count` photons, 1 to most_photons.
    ///   spread2  mean square distance of the photons from their mean place
    PhotonMap(PhotonKind kind, std::size_t count, double spread2);

    /// Puts photon `number` of the file's heap, from 0, in its place. To be called for each once.
    void place(std::size_t number, const Photon& photon);

    PhotonKind kind() const { return kind_; }
    std::size_t size() const { return size_; }
    double spread2() const { return spread2_; }

    // For searches
    // -------------------------------------------------------------------------------------------------

    static constexpr std::size_t leaf_levels = 5;
    static constexpr std::size_t largest_leaf = (std::size_t{1} << leaf_levels) - 1;

    /// Nodes of the heap are numbered from 1; those above this are leaves.
    std::uint32_t inner_count() const { return inner_count_; }
    /// Five words of an inner node's photon: x, y, z, then attributes.
    const float* inner(std::uint32_t node) const { return &words_[words_of_photon * (node - 1)]; }
    struct Leaf {
        const float* x;  ///< all x, then all y, all z, and pairs of attributes
        std::uint32_t count;
    };
    Leaf leaf(std::uint32_t node) const {
        const std::uint32_t* const start = &start_[node - inner_count_ - 1];
        return {&words_[words_of_photon * start[0]], start[1] - start[0]};
    }
    std::uint32_t word_number(const float* word) const {
        return static_cast<std::uint32_t>(word - words_.data());
    }

    /// What a photon carries besides its position: two words, the first of which names it.
    class Attributes {
      public:
        Attributes(float flux, float direction)
            : flux_(std::bit_cast<Rgbe>(flux)),
              direction_(std::bit_cast<std::array<std::int8_t, 4>>(direction)) {}
        const Rgbe& flux() const { return flux_; }
        int direction(int i) const { return direction_[static_cast<std::size_t>(i)]; }
        int axis() const { return direction_[3] & 3; }
        bool is_caustic() const { return (direction_[3] & 4) != 0; }

      private:
        Rgbe flux_;
        std::array<std::int8_t, 4> direction_;
    };
    Attributes attributes(std::uint32_t word) const { return {words_[word], words_[word + 1]}; }

  private:
    static constexpr std::size_t words_of_photon = 5;

    PhotonKind kind_;
    std::size_t size_;
    double spread2_;
    int inner_levels_;
    std::uint32_t inner_count_;
    std::vector<float> words_;          // positions, and attributes as bits
    std::vector<std::uint32_t> start_;  // of leaves, in photons; one more than there are leaves
};

}  // namespace infra
