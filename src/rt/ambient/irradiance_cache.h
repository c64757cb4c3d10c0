// The cache of diffuse interreflection: irradiance is computed in few places and interpolated between them.
//
// One cache serves all threads. Values are only ever added, and each is complete before a pointer to it is
// published: readers follow atomic pointers and take no lock, writers take turns.
// source: Ward, Rubinstein & Clear, "A Ray Tracing Solution for Diffuse Interreflection" (1988); weights and
// tests of values as RADIANCE 6.1.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "rt/ambient/ambient_file.h"
#include "rt/ambient/cache_limits.h"
#include "rt/ambient/irradiance_value.h"
#include "scene/octree.h"

namespace infra {

class IrradianceCache {
  public:
    ///   cube      of the scene; places outside it are cached too
    ///   accuracy  above 0
    IrradianceCache(const Cube& cube, int channels, double accuracy, int resolution);
    IrradianceCache(const IrradianceCache&) = delete;
    IrradianceCache& operator=(const IrradianceCache&) = delete;
    ~IrradianceCache();

    /// Takes in what the file holds, and hands it all values that are added from now on. To be called before
    /// any other function, once.
    void share_with(std::unique_ptr<AmbientFile> file);
    /// Writes what the file does not have yet. throws Error when it cannot be written.
    void flush();

    const CacheLimits& limits() const { return limits_; }

    /// Adds to `sum` the weighted mean radiances that cached values give for a place. Thread-safe.
    ///   walls    asked about values near which something rises
    ///   returns  the sum of weights, 0 if there is no value to be used
    double interpolate(const IrradiancePlace& place, WallTest& walls, Spectrum& sum) const;

    /// Makes a value known to all threads, and to other programs that share the file. Thread-safe.
    void add(const IrradianceValue& value);

    std::size_t size() const { return size_.load(std::memory_order_relaxed); }
    /// Logarithmic mean of the brightness of all values (-aw); over those that are not black.
    double mean_log() const { return mean_log_.load(std::memory_order_relaxed); }
    std::size_t lit_values() const { return lit_.load(std::memory_order_relaxed); }

    /// Memory of one value, bytes.
    static std::size_t value_bytes(int channels);

  private:
    struct Entry;
    struct Chunk;
    struct Node;
    struct Region;
    struct Query;
    struct Block;

    double sum_entries(const Node& node, const Query& query) const;
    double add_entry(const Entry& entry, const Query& query) const;
    // writer_ is held:
    void store(const IrradianceValue& value);
    void list(const Entry& entry, const Region& region, Node& node, const Cube& cube, int depth);
    void append(const Entry& entry, Node& node);
    std::byte* allocate(std::size_t bytes, std::size_t alignment);

    const Cube cube_;
    const int channels_;
    const CacheLimits limits_;
    std::unique_ptr<Node> root_;    // a value stands in every cell that it may be of use in
    std::unique_ptr<Node> around_;  // and here if that may be outside the scene's cube

    std::mutex writer_;
    std::unique_ptr<AmbientFile> file_;
    std::vector<std::unique_ptr<Block>> blocks_;  // values and cells, never moved
    std::size_t block_used_ = 0;
    double log_sum_ = 0;
    std::atomic<std::size_t> size_ = 0;
    std::atomic<std::size_t> lit_ = 0;
    std::atomic<double> mean_log_ = 0;
};

/// Mean radiance that a value gives for a place near it: moved along its gradients, within limits. False when
/// these make it too dark to be trusted.
bool extrapolate(const IrradianceValue& value, const IrradiancePlace& place, Spectrum& radiance);

}  // namespace infra
