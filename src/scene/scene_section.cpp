#include "scene/scene_section.h"

#include <algorithm>
#include <array>

#include "scene/rad_parser.h"
#include "scene/surface_geometry.h"

namespace infra {
namespace {

constexpr std::size_t most_types = 127;
constexpr std::size_t longest_type_name = 31;
constexpr std::size_t most_arguments = 32767;
constexpr int end_of_section = -1;

/// The types of a file by its numbers; one that we don't know only matters if a primitive has it.
struct TypeNames {
    std::vector<std::string> names;

    PrimitiveType at(std::int64_t number, const ByteReader& in) const {
        if (number < 0 || number >= std::int64_t(names.size())) in.fail_damaged("a primitive of no type");
        const auto type = find_primitive_type(names[number]);
        if (!type) in.fail("primitive of unknown type \"" + names[number] + "\"");
        return *type;
    }
};

TypeNames read_type_names(ByteReader& in) {
    TypeNames types;
    for (auto name = in.string(longest_type_name); !name.empty(); name = in.string(longest_type_name)) {
        if (types.names.size() == most_types) in.fail_damaged("too many types");
        types.names.push_back(std::move(name));
    }
    return types;
}

}  // namespace

void read_scene_section(ByteReader& in, Scene& scene, int id_size) {
    const TypeNames types = read_type_names(in);
    const SourcePlace place{scene.add_file(in.name()), 0};
    std::vector<std::string> strings;
    std::vector<std::string_view> views;
    std::vector<double> reals;
    for (auto number = in.integer(1); number != end_of_section; number = in.integer(1)) {
        const PrimitiveType type = types.at(number, in);
        const std::int64_t modifier = in.integer(id_size);
        if (modifier < void_primitive || modifier >= scene.size() ||
            (modifier >= 0 && !scene.type_info(PrimitiveId(modifier)).is_modifier()))
            in.fail_damaged("primitive number " + std::to_string(scene.size()) + " has no valid modifier");
        const std::string name = in.string(longest_word);

        const std::int64_t string_count = in.integer(2);
        if (string_count < 0) in.fail_damaged("a negative number of arguments");
        strings.clear();
        for (std::int64_t i = 0; i < string_count; ++i) strings.push_back(in.string(longest_word));
        views.assign(strings.begin(), strings.end());

        const std::int64_t real_count = in.integer(2);
        if (real_count < 0) in.fail_damaged("a negative number of arguments");
        reals.clear();
        for (std::int64_t i = 0; i < real_count; ++i) reals.push_back(in.real());
        scene.add(type, PrimitiveId(modifier), name, views, reals, place);
    }
}

void write_scene_section(ByteWriter& out, const Scene& scene) {
    write_scene_section(out, scene, scene.size());
}

void write_scene_section(ByteWriter& out, const Scene& scene, PrimitiveId count) {
    std::array<int, primitive_type_count> number;  // in this file, by type
    std::array<bool, primitive_type_count> used{};
    for (PrimitiveId id = 0; id < count; ++id) used[static_cast<std::size_t>(scene.type(id))] = true;
    int next = 0;
    for (const PrimitiveInfo& row : primitive_types()) {
        const auto type = static_cast<std::size_t>(row.type);
        if (row.is_ours() && !used[type]) continue;
        number[type] = next++;
        out.string(row.name);
    }
    out.string("");

    StoredSurface stored;
    for (PrimitiveId id = 0; id < count; ++id) {
        const auto strings = scene.strings(id);
        get_stored_surface(scene, id, stored);
        const auto reals = stored.reals;
        if (std::max(strings.size(), reals.size()) > most_arguments)
            throw scene.error(id, "more arguments than a frozen octree can hold (32767)",
                              "leave out -f, or split it");
        out.integer(number[static_cast<std::size_t>(stored.type)], 1);
        out.integer(scene.modifier(id), written_id_size);
        out.string(scene.name(id));
        out.integer(std::int64_t(strings.size()), 2);
        for (const std::string_view s : strings) out.string(s);
        out.integer(std::int64_t(reals.size()), 2);
        for (const double value : reals) out.real(value);
    }
    out.integer(end_of_section, 1);
}

}  // namespace infra
