#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace infra {
namespace {

/// RADIANCE compares reals of two definitions to within this relative difference.
constexpr double equal_reals = 1e-6;

bool nearly_equal(double a, double b) {
    const double difference = b != 0.0 ? a / b - 1.0 : a;
    return std::abs(difference) <= equal_reals;
}

}  // namespace

std::string_view Scene::keep(std::string_view text) {
    return {text_.store(std::span(text.data(), text.size())), text.size()};
}

Location Scene::location(PrimitiveId id) const {
    const Record& record = records_[id];
    if (record.file == 0) return {};
    return {files_[record.file - 1], record.line, 0};
}

PrimitiveId Scene::find_modifier(std::string_view name) const {
    const auto found = modifiers_.find(name);
    return found == modifiers_.end() ? void_primitive : found->second;
}

PrimitiveId Scene::find_modifier_before(std::string_view wanted, PrimitiveId before) const {
    PrimitiveId id = find_modifier(wanted);
    if (id >= before)  // redefined since: look for the definition that was current then
        do --id;
        while (id >= 0 && (id >= before || !type_info(id).is_modifier() || name(id) != wanted));
    return id;
}

ResolvedModifier Scene::resolve(PrimitiveId id) const {
    ResolvedModifier result;
    bool renamed = false;  // the outermost alias with a modifier of its own decides
    while (id != void_primitive && type(id) == PrimitiveType::alias) {
        if (strings(id).empty()) {
            id = modifier(id);
            continue;
        }
        if (!renamed) result.modifier = modifier(id);
        renamed = true;
        const PrimitiveId target = find_modifier_before(strings(id)[0], id);
        if (target == void_primitive)
            throw error(id, "undefined target \"" + std::string(strings(id)[0]) + "\"");
        id = target;
    }
    result.definition = id;
    if (!renamed && id != void_primitive) result.modifier = modifier(id);
    return result;
}

std::vector<std::string_view> Scene::modifier_names() const {
    std::vector<std::string_view> names;
    names.reserve(modifiers_.size());
    for (const auto& [name, id] : modifiers_) names.push_back(name);
    std::ranges::sort(names);
    return names;
}

Error Scene::error(PrimitiveId id, std::string_view message, std::string_view hint) const {
    std::string what(infra::name(type(id)));
    what.append(" \"").append(name(id)).append("\": ").append(message);
    return Error(location(id), what, hint);
}

std::int32_t Scene::add_file(std::string_view file_name) {
    if (files_.size() == std::size_t(most_files)) throw Error("too many files and commands in the scene");
    files_.emplace_back(file_name);
    return static_cast<std::int32_t>(files_.size() - 1);
}

bool Scene::same_definition(PrimitiveId a, PrimitiveId b) const {
    if (a == b) return true;
    if (a == void_primitive || b == void_primitive) return false;
    if (type(a) != type(b) || modifier(a) != modifier(b)) return false;
    if (!std::ranges::equal(reals(a), reals(b), nearly_equal)) return false;
    // A string may name a modifier, and mean another one by the same name.
    return std::ranges::equal(strings(a), strings(b), [&](std::string_view s, std::string_view t) {
        return s == t && find_modifier_before(s, a) == find_modifier_before(t, b);
    });
}

PrimitiveId Scene::add(PrimitiveType type, PrimitiveId modifier, std::string_view name,
                       std::span<const std::string_view> strings, std::span<const double> reals,
                       SourcePlace place) {
    if (records_.size() >= std::size_t(std::numeric_limits<PrimitiveId>::max()))
        throw Error("too many primitives in the scene");
    if (name.size() > longest_name) throw Error("a name of more than 511 characters");
    const PrimitiveId id = size();
    if (!strings.empty()) {
        std::vector<std::string_view> kept;
        kept.reserve(strings.size());
        for (const std::string_view s : strings) kept.push_back(keep(s));
        strings_.emplace(id, std::span(string_lists_.store(kept), kept.size()));
    }
    const std::string_view kept_name = keep(name);

    Record record;
    record.name = kept_name.data();
    record.name_length = static_cast<std::uint32_t>(name.size()) & longest_name;
    record.reals = (info(type).is_geometry() ? geometry_reals_ : reals_).store(reals);
    record.real_count = static_cast<std::uint32_t>(reals.size());
    record.has_strings = !strings.empty();
    record.modifier = modifier;
    record.line = place.line;
    record.file = static_cast<std::uint32_t>(place.file + 1) & most_files;
    types_.push_back(type);
    records_.push_back(record);

    if (info(type).is_modifier()) {
        const auto [entry, is_new] = modifiers_.try_emplace(kept_name, id);
        if (!is_new && !same_definition(id, entry->second)) entry->second = id;
    }
    return id;
}

void Scene::release_geometry_arguments() {
    for (PrimitiveId id = 0; id < size(); ++id)
        if (type_info(id).is_geometry()) {
            records_[id].reals = nullptr;
            records_[id].real_count = 0;
        }
    geometry_reals_ = {};
}

void check_arguments(const Scene& scene, PrimitiveId id) {
    const PrimitiveInfo& row = scene.type_info(id);
    const std::size_t strings = scene.strings(id).size(), reals = scene.reals(id).size();
    if (row.strings.allows(strings) && row.reals.allows(reals)) return;
    throw scene.error(id, wrong_counts(row, strings, reals), argument_summary(row));
}

}  // namespace infra
