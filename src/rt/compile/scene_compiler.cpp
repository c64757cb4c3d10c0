// From primitives to surfaces, modifiers and light sources. Only what surfaces use is compiled, so that a
// library of materials costs nothing and its unused parts may be incomplete, as in RADIANCE.
#include <unordered_map>
#include <unordered_set>

#include "cal/ray_library.h"
#include "common/raypath.h"
#include "rt/compile/compiled_scene.h"
#include "rt/compile/data_cache.h"
#include "rt/compile/modifier_table.h"
#include "rt/compile/table_cache.h"
#include "rt/materials/ward_material.h"
#include "rt/sources/source_setup.h"

namespace infra {

class SceneCompiler {
  public:
    SceneCompiler(CompiledScene& target, const RenderSettings& settings)
        : out_(target),
          scene_(target.text_),
          surfaces_(target.surfaces_.surfaces),
          settings_(settings),
          functions_(cal::make_ray_library()) {}

    void run(const std::vector<FunctionDefinition>& definitions) {
        for (const FunctionDefinition& definition : definitions) {
            if (definition.is_file)
                functions_.load_file(definition.text);
            else
                functions_.define(definition.text, Location{"-e option", 1, 1});
        }
        find_surfaces();
        compile_modifiers();
        make_finishes();
        add_shapes();
        make_sources();
        out_.text_.release_geometry_arguments();
        out_.geometry_.build();
        out_.program_ = std::make_unique<cal::Program>(functions_.link());
        WardParameters white{Spectrum(out_.channel_count(), 3.14159265358979f)};
        if (!settings_.air_path.empty())
            out_.air_ =
                AirPath::read(require_library_file(settings_.air_path, "air path file"), out_.channels_);
        out_.band_ = tables_.thermal_bands.common();
        for (std::string& warning : tables_.thermal_bands.warnings(out_.channels_, out_.air()))
            out_.warnings_.push_back(std::move(warning));
        const float* ambient = settings_.ambient_value;
        out_.ambient_value_ = out_.channels_.from_rgb(ambient[0], ambient[1], ambient[2]);
        out_.irradiance_material_ = std::make_unique<WardMaterial>("Lambertian", nullptr, white, false);
    }

  private:
    using Flags = std::vector<char>;

    void find_surfaces() {
        std::size_t count = 0;
        for (PrimitiveId id = 0; id < scene_.size(); ++id) count += scene_.type_info(id).is_geometry();
        surfaces_.reserve(count);
        for (PrimitiveId id = 0; id < scene_.size(); ++id)
            if (scene_.type_info(id).is_geometry()) {
                check_arguments(scene_, id);
                surfaces_.push_back({.primitive = id});
            }
    }

    // Every modifier stands after those it refers to: walking backwards finds all that are used, walking
    // forwards makes each when its parts are there.
    void compile_modifiers() {
        Flags used(static_cast<std::size_t>(scene_.size()));
        const auto mark = [&](PrimitiveId id) {
            if (id != void_primitive) used[static_cast<std::size_t>(id)] = 1;
        };
        for (const Surface& surface : surfaces_) mark(scene_.modifier(surface.primitive));
        for (PrimitiveId id = scene_.size() - 1; id >= 0; --id) {
            if (!used[static_cast<std::size_t>(id)]) continue;
            const ResolvedModifier resolved = scene_.resolve(id);
            mark(resolved.modifier);
            if (resolved.definition == void_primitive) continue;
            for (const std::string_view name : referenced_modifiers(scene_, resolved.definition))
                mark(scene_.find_modifier_before(name, resolved.definition));
        }
        made_.assign(static_cast<std::size_t>(scene_.size()), nullptr);
        for (PrimitiveId id = 0; id < scene_.size(); ++id)
            if (used[static_cast<std::size_t>(id)] && scene_.type_info(id).is_modifier())
                made_[static_cast<std::size_t>(id)] = compile(id);
    }

    const Modifier* made(PrimitiveId id) const {
        return id == void_primitive ? nullptr : made_[static_cast<std::size_t>(id)];
    }

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
        ModifierContext context{scene_,     what,    next,  out_.channels_, settings_,
                                functions_, tables_, data_, made_,          out_.warnings_};
        out_.modifiers_.push_back(row->make(context));
        const Modifier* made = out_.modifiers_.back().get();
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

    void make_finishes() {
        const std::unordered_set<std::string_view> names(settings_.ambient_filter.names.begin(),
                                                         settings_.ambient_filter.names.end());
        std::unordered_map<PrimitiveId, std::int32_t> finish_of;
        for (Surface& surface : surfaces_) {
            const PrimitiveId modifier = scene_.modifier(surface.primitive);
            const auto [known, is_new] =
                finish_of.try_emplace(modifier, static_cast<std::int32_t>(out_.surfaces_.finishes.size()));
            surface.finish = known->second;
            if (!is_new) continue;
            Finish finish{.primitive = modifier, .modifier = made(modifier)};
            if (const Modifier* material = Modifier::material_of(finish.modifier))
                finish.material = material->traits();
            if (settings_.ambient_filter.mode != NameFilter::Mode::none) {
                const bool named = modifier != void_primitive && names.contains(scene_.name(modifier));
                finish.in_ambient = named == (settings_.ambient_filter.mode == NameFilter::Mode::include);
            }
            out_.surfaces_.finishes.push_back(finish);
        }
    }

    void add_shapes() {
        std::size_t triangles = 0;
        for (const Surface& surface : surfaces_)
            triangles += scene_.type(surface.primitive) == PrimitiveType::polygon &&
                         scene_.reals(surface.primitive).size() == 9;
        out_.geometry_.reserve(surfaces_.size(), triangles);
        for (std::size_t i = 0; i < surfaces_.size(); ++i)
            if (scene_.type(surfaces_[i].primitive) != PrimitiveType::source)
                out_.geometry_.add(scene_, surfaces_[i].primitive, static_cast<int>(i));
    }

    void make_sources() {
        bool indirect = false;
        for (std::size_t i = 0; i < surfaces_.size(); ++i) {
            Surface& surface = surfaces_[i];
            const Finish& finish = out_.finish(static_cast<int>(i));
            const Modifier* material = finish.material ? Modifier::material_of(finish.modifier) : nullptr;
            const Emitter* emitter = material ? material->emitter() : nullptr;
            if (!emitter) continue;
            // What emits besides reflecting is worth seeing without any light.
            indirect = indirect || !material->traits()->is_light;
            if (emitter->radiance().maximum() <= same_place) continue;
            const bool distant = scene_.type(surface.primitive) == PrimitiveType::source;
            if (emitter->kind() == Emitter::Kind::glow && !distant && emitter->reach() <= same_place) {
                indirect = indirect || settings_.ambient_bounces > 0;
                continue;
            }
            LightSource source = make_light_source(scene_, surface.primitive, *emitter, out_.warnings_);
            source.surface = static_cast<int>(i);
            source.modifier = finish.modifier;
            if (!distant) check_center(source);
            indirect = indirect || (source.skip && settings_.ambient_bounces > 0);
            surface.source = static_cast<int>(out_.sources_.size());
            if (distant) out_.distant_.push_back(surface.source);
            if (!source.skip) out_.sampled_.push_back(surface.source);
            out_.sources_.push_back(source);
        }
        if (out_.sampled_.empty() && !indirect && !surfaces_.empty())
            out_.warnings_.push_back("no light sources found");
    }

    // Samples are aimed at the centre: it has to be part of a flat source.
    void check_center(const LightSource& source) const {
        if (source.extent != LightSource::Extent::flat) return;
        HitState state;
        const ShapeRef shape = out_.geometry_.shape_of(source.surface);
        if (shape == Geometry::no_shape ||
            !out_.geometry_.intersect_one(shape, source.center + source.normal, -source.normal, state))
            throw scene_.error(out_.surface(source.surface).primitive,
                               "light source does not contain its own centre",
                               "divide it into convex polygons");
    }

    CompiledScene& out_;
    const Scene& scene_;
    std::vector<Surface>& surfaces_;
    const RenderSettings& settings_;
    cal::Library functions_;
    TableCache tables_;
    DataCache data_;
    std::vector<const Modifier*> made_;
};

std::shared_ptr<const CompiledScene> CompiledScene::compile(
    Scene scene, const RenderSettings& settings, const Channels& channels,
    const std::vector<FunctionDefinition>& definitions) {
    if (settings.max_reflections <= 0 && settings.min_weight <= 0)
        throw Error("-lr below 1 needs a -lw above 0", "Russian roulette ends rays lighter than -lw");
    const std::shared_ptr<CompiledScene> compiled(new CompiledScene);
    compiled->channels_ = channels;
    compiled->text_ = std::move(scene);
    SceneCompiler(*compiled, settings).run(definitions);
    return compiled;
}

std::string_view CompiledScene::surface_name(int surface_index) const {
    return text_.name(surface(surface_index).primitive);
}

std::string_view CompiledScene::modifier_name(int surface_index) const {
    const PrimitiveId modifier = text_.modifier(surface(surface_index).primitive);
    return modifier == void_primitive ? "void" : text_.name(modifier);
}

std::string_view CompiledScene::material_name(int surface_index) const {
    const MaterialTraits* material = finish(surface_index).material;
    return material ? material->name : "void";
}

}  // namespace infra
