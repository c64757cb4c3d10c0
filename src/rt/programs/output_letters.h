// The letters of rtrace's -o option: what each writes about a ray. One table; -o, -defaults and -help come
// from it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rt/compile/compiled_scene.h"
#include "rt/programs/value_writer.h"
#include "rt/ray.h"

namespace infra {

/// Numbers written: this many, or as many as the output makes of a spectrum.
inline constexpr int per_value = -1;

struct OutputLetter {
    char letter;
    const char* name;     ///< as -defaults puts it
    int components;       ///< numbers, names count as one; per_value
    bool needs_radiance;  ///< otherwise finding what the ray meets is enough
    void (*write)(const CompiledScene& scene, const Interaction& at, ValueWriter& out);
};

std::span<const OutputLetter> output_letters();

/// Text after -o, understood.
struct OutputSpec {
    std::vector<const OutputLetter*> primary;  ///< of every input ray
    std::vector<const OutputLetter*> tree;     ///< after 't' or 'T': of every ray of its tree
    bool trace_sources = false;                ///< 'T': also of rays towards light sources

    bool has_tree() const { return !tree.empty(); }
    bool needs_radiance() const;
    bool has_any(std::string_view letters) const;  ///< among the primary ones
    /// Numbers a ray as NCOMP= tells them, `numbers` of each spectrum; 0 when there is no such figure.
    int components(int numbers) const;
};

/// throws Error for an unknown letter or an empty text.
OutputSpec parse_output(std::string_view letters);

/// " origin direction": the names for -defaults.
std::string output_names(std::string_view letters);

}  // namespace infra
