// The scene as its text says it: primitives in order of definition with their arguments.
// Built by the readers (rad_reader.h, octree_file.h), then compiled by the ray tracer.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "common/error.h"
#include "common/large_pages.h"
#include "scene/arena.h"
#include "scene/primitive_types.h"

namespace infra {

/// Index of a primitive in its scene.
using PrimitiveId = std::int32_t;
inline constexpr PrimitiveId void_primitive = -1;

/// Where a primitive began, 8 bytes. File -1: unknown (a frozen octree keeps no places).
struct SourcePlace {
    std::int32_t file = -1;
    std::int32_t line = 0;
};

/// A modifier with the aliases on the way to it followed.
struct ResolvedModifier {
    PrimitiveId definition = void_primitive;  ///< its type and arguments; never an alias
    PrimitiveId modifier = void_primitive;    ///< what modifies it: its own modifier, or the alias's
};

class Scene {
  public:
    Scene() = default;
    Scene(Scene&&) = default;
    Scene& operator=(Scene&&) = default;

    PrimitiveId size() const { return static_cast<PrimitiveId>(records_.size()); }

    PrimitiveType type(PrimitiveId id) const { return types_[id]; }
    const PrimitiveInfo& type_info(PrimitiveId id) const { return info(type(id)); }
    /// Identifier. Views and spans of a scene live as long as the scene.
    std::string_view name(PrimitiveId id) const { return {records_[id].name, records_[id].name_length}; }
    /// Modifier as written (an alias is a primitive of its own); void_primitive for "void".
    PrimitiveId modifier(PrimitiveId id) const { return records_[id].modifier; }
    std::span<const double> reals(PrimitiveId id) const {
        return {records_[id].reals, records_[id].real_count};
    }
    std::span<const std::string_view> strings(PrimitiveId id) const {
        return records_[id].has_strings ? strings_.at(id) : std::span<const std::string_view>();
    }
    /// File and line of the primitive's first word; empty when unknown.
    Location location(PrimitiveId id) const;

    /// Latest modifier (material, pattern, texture, mixture, alias) of this name, or void_primitive.
    PrimitiveId find_modifier(std::string_view name) const;
    /// Latest modifier of this name defined before `before`: what that primitive means by a name in its
    /// arguments.
    PrimitiveId find_modifier_before(std::string_view name, PrimitiveId before) const;
    /// Follows aliases from `id` (which may be void_primitive) to a real definition.
    ///   throws  Error when an alias's target is not defined
    ResolvedModifier resolve(PrimitiveId id) const;
    /// Names of all modifiers, for "did you mean".
    std::vector<std::string_view> modifier_names() const;

    /// An error about this primitive: "file:line: type "identifier": message (hint)".
    Error error(PrimitiveId id, std::string_view message, std::string_view hint = {}) const;

    /// Source files and commands ("!xform ..") as they were named, those that SourcePlace numbers.
    const std::vector<std::string>& files() const { return files_; }

    /// Makes room for as many primitives.
    void reserve(std::size_t primitives) {
        types_.reserve(primitives);
        records_.reserve(primitives);
    }
    /// Number of a source file, for SourcePlace.
    std::int32_t add_file(std::string_view file_name);
    /// Adds a primitive. A modifier is found by its name from now on, unless an earlier one of that name
    /// is the same in every respect, which then keeps the name (as in RADIANCE).
    PrimitiveId add(PrimitiveType type, PrimitiveId modifier, std::string_view name,
                    std::span<const std::string_view> strings, std::span<const double> reals,
                    SourcePlace place = {});

    /// Forgets the real arguments of surfaces, most of a large scene, once they have been made use of.
    void release_geometry_arguments();

  private:
    struct Record {  // there may be millions of them
        const char* name;
        const double* reals;
        std::uint32_t real_count;
        PrimitiveId modifier;
        std::int32_t line;
        std::uint32_t file : 22;  ///< counted from 1; 0: unknown
        std::uint32_t name_length : 9;
        std::uint32_t has_strings : 1;
    };
    static constexpr std::int32_t most_files = (1 << 22) - 1;
    static constexpr std::size_t longest_name = (1 << 9) - 1;

    std::string_view keep(std::string_view text);
    bool same_definition(PrimitiveId a, PrimitiveId b) const;

    std::vector<PrimitiveType> types_;  // apart from all else: what is asked of every primitive mostly
    LargeVector<Record> records_;
    Arena<double> reals_;           ///< of modifiers
    Arena<double> geometry_reals_;  ///< of surfaces and volumes
    Arena<std::string_view> string_lists_;
    std::unordered_map<PrimitiveId, std::span<const std::string_view>> strings_;  ///< of those that have any
    Arena<char> text_;
    std::vector<std::string> files_;
    std::unordered_map<std::string_view, PrimitiveId> modifiers_;
};

/// Throws Error (with file and line) if a primitive has a wrong number of arguments for its type.
/// oconv calls it for surfaces, the renderer also for the modifiers in use.
void check_arguments(const Scene& scene, PrimitiveId id);

}  // namespace infra
