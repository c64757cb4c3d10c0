#include "rt/compile/part_compiler.h"

#include <unordered_map>
#include <unordered_set>

#include "rt/compile/modifier_table.h"

namespace infra {
namespace {

// Modifiers of one part.
class ModifierCompiler {
  public:
    ModifierCompiler(CompileContext& context, const ScenePart& part)
        : context_(context), part_(part), scene_(part.text) {}

    // Every modifier stands after those it refers to: walking backwards finds all that are used, walking
    // forwards makes each when its parts are there.
    void run(SurfaceRange range) {
        PrimitiveId count = scene_.size();  // up to the last modifier
        while (count > 0 && !scene_.type_info(count - 1).is_modifier()) --count;
        std::vector<char> used(static_cast<std::size_t>(count));
        const auto mark = [&](PrimitiveId id) {
            if (id != void_primitive) used[static_cast<std::size_t>(id)] = 1;
        };
        for (int i = range.begin; i < range.end; ++i)
            mark(scene_.modifier(context_.surfaces[i].primitive - part_.first));
        for (PrimitiveId id = count - 1; id >= 0; --id) {
            if (!used[static_cast<std::size_t>(id)]) continue;
            const ResolvedModifier resolved = scene_.resolve(id);
            mark(resolved.modifier);
            if (resolved.definition == void_primitive) continue;
            for (const std::string_view name : referenced_modifiers(scene_, resolved.definition))
                mark(scene_.find_modifier_before(name, resolved.definition));
        }
        made_.assign(static_cast<std::size_t>(count), nullptr);
        for (PrimitiveId id = 0; id < count; ++id)
            if (used[static_cast<std::size_t>(id)] && scene_.type_info(id).is_modifier())
                made_[static_cast<std::size_t>(id)] = compile(id);
    }

    const Modifier* made(PrimitiveId id) const {
        return id == void_primitive ? nullptr : made_[static_cast<std::size_t>(id)];
    }

  private:
    // An alias is what it stands for, under its own modifier.
    const Modifier* compile(PrimitiveId id) {
        const ResolvedModifier resolved = scene_.resolve(id);
        const Modifier* next = made(resolved.modifier);
        const PrimitiveId what = resolved.definition;
        if (what == void_primitive) return next;
        check_arguments(scene_, what);
        const ModifierRow* row = find_modifier_row(scene_.type(what));
        if (!row)
            throw scene_.error(what,
                               "type \"" + std::string(name(scene_.type(what))) + "\" is not supported yet",
                               "the renderer knows its arguments but not its shading");
        ModifierContext modifier{scene_,
                                 what,
                                 part_.first,
                                 next,
                                 context_.channels,
                                 context_.settings,
                                 context_.functions,
                                 context_.tables,
                                 context_.data,
                                 made_,
                                 context_.warnings};
        context_.modifiers.push_back(row->make(modifier));
        const Modifier* made = context_.modifiers.back().get();
        check_patterns(what, made);
        return made;
    }

    // What modifies a material may only be patterns and textures.
    void check_patterns(PrimitiveId id, const Modifier* modifier) const {
        if (!modifier->traits() || modifier->traits()->is_mixture) return;
        if (const Modifier* other = Modifier::material_of(modifier->next()))
            throw scene_.error(id,
                               "conflicting material \"" + std::string(other->name()) + "\" as its modifier",
                               "a material is modified by patterns and textures only");
    }

    CompileContext& context_;
    const ScenePart& part_;
    const Scene& scene_;
    std::vector<const Modifier*> made_;
};

}  // namespace

SurfaceRange add_surfaces(CompileContext& context, const ScenePart& part) {
    const Scene& scene = part.text;
    std::vector<Surface>& surfaces = context.surfaces.surfaces;
    SurfaceRange range;
    range.begin = static_cast<int>(surfaces.size());
    std::size_t count = 0;
    for (PrimitiveId id = 0; id < scene.size(); ++id) count += scene.type_info(id).is_geometry();
    if (surfaces.empty()) surfaces.reserve(count);
    for (PrimitiveId id = 0; id < scene.size(); ++id)
        if (scene.type_info(id).is_geometry()) surfaces.push_back({.primitive = part.number(id)});
    range.end = static_cast<int>(surfaces.size());
    return range;
}

void finish_surfaces(CompileContext& context, const ScenePart& part, SurfaceRange range) {
    ModifierCompiler modifiers(context, part);
    modifiers.run(range);
    const NameFilter& filter = context.settings.ambient_filter;
    const std::unordered_set<std::string_view> names(filter.names.begin(), filter.names.end());
    std::vector<Finish>& finishes = context.surfaces.finishes;
    std::unordered_map<PrimitiveId, std::int32_t> finish_of;
    PrimitiveId latest = void_primitive;
    std::int32_t latest_finish = -1;
    for (int i = range.begin; i < range.end; ++i) {
        Surface& surface = context.surfaces.surfaces[static_cast<std::size_t>(i)];
        const PrimitiveId modifier = part.text.modifier(surface.primitive - part.first);
        if (modifier == latest && latest_finish >= 0) {
            surface.finish = latest_finish;
            continue;
        }
        const auto [known, is_new] =
            finish_of.try_emplace(modifier, static_cast<std::int32_t>(finishes.size()));
        surface.finish = latest_finish = known->second;
        latest = modifier;
        if (!is_new) continue;
        Finish finish{.primitive = part.number(modifier), .modifier = modifiers.made(modifier)};
        if (const Modifier* material = Modifier::material_of(finish.modifier))
            finish.material = material->traits();
        if (filter.mode != NameFilter::Mode::none) {
            const bool named = modifier != void_primitive && names.contains(part.text.name(modifier));
            finish.in_ambient = named == (filter.mode == NameFilter::Mode::include);
        }
        finishes.push_back(finish);
    }
}

void add_shapes(const CompileContext& context, const ScenePart& part, SurfaceRange range,
                Geometry& geometry) {
    const Scene& scene = part.text;
    const auto primitive = [&](int surface) { return context.surfaces[surface].primitive - part.first; };
    std::size_t triangles = 0;
    for (int i = range.begin; i < range.end; ++i)
        triangles += scene.type(primitive(i)) == PrimitiveType::polygon;  // or fewer
    geometry.reserve(static_cast<std::size_t>(range.end - range.begin), triangles);
    for (int i = range.begin; i < range.end; ++i) {
        check_arguments(scene, primitive(i));
        switch (scene.type(primitive(i))) {
            case PrimitiveType::source:
            case PrimitiveType::instance:
            case PrimitiveType::mesh:
                break;
            default:
                geometry.add(scene, primitive(i), i);
        }
    }
}

}  // namespace infra
