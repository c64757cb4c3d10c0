// From primitives to all that is traced: surfaces, modifiers and shapes of the scene's parts
// (part_compiler.h, content_loader.h), then what belongs to the scene as a whole, such as its light sources.
#include <algorithm>

#include "cal/ray_library.h"
#include "common/raypath.h"
#include "rt/compile/compiled_scene.h"
#include "rt/compile/content_loader.h"
#include "rt/materials/ward_material.h"
#include "rt/photons/photon_maps.h"
#include "rt/sources/source_setup.h"
#include "rt/sources/virtual_sources.h"
#include "rt/split/split.h"
#include "rt/volume/antimatter.h"
#include "rt/volume/mist.h"
#include "scene/surface_geometry.h"

namespace infra {

void add_definition(cal::Library& functions, const FunctionDefinition& definition) {
    if (definition.is_file)
        functions.load_file(definition.text, {}, definition.context);
    else
        functions.define(definition.text, Location{"-e option", 1, 1}, definition.context);
}

class SceneCompiler {
  public:
    SceneCompiler(CompiledScene& target, const RenderSettings& settings)
        : out_(target),
          scene_(target.parts_.front().text),
          settings_(settings),
          context_{settings,
                   target.channels_,
                   target.parts_,
                   target.surfaces_,
                   target.modifiers_,
                   target.contents_,
                   target.warnings_,
                   cal::make_ray_library(),
                   {},
                   {}} {}

    void run(const std::vector<FunctionDefinition>& definitions) {
        for (const FunctionDefinition& definition : definitions)
            add_definition(context_.functions, definition);
        const ScenePart& part = out_.parts_.front();
        const SurfaceRange surfaces = add_surfaces(context_, part);
        finish_surfaces(context_, part, surfaces);
        add_shapes(context_, part, surfaces, out_.geometry_);
        make_sources();  // before the contents of instances come, which add none
        const std::vector<RelaySurface> relays = find_relays(scene_, out_.surfaces_, out_.warnings_);
        ContentLoader(context_).place(part, surfaces, out_.geometry_);
        mark_cut_finishes();
        out_.geometry_.build();
        out_.parts_.front().text.release_geometry_arguments();
        for (const LightSource& source : out_.sources_) check_center(source);
        out_.program_ = std::make_unique<cal::Program>(context_.functions.link());
        WardParameters white{Spectrum(out_.channel_count(), 3.14159265358979f)};
        if (!settings_.air_path.empty())
            out_.air_ =
                AirPath::read(require_library_file(settings_.air_path, "air path file"), out_.channels_);
        out_.band_ = context_.tables.thermal_bands.common();
        for (std::string& warning : context_.tables.thermal_bands.warnings(out_.channels_, out_.air()))
            out_.warnings_.push_back(std::move(warning));
        const float* ambient = settings_.ambient_value;
        out_.ambient_value_ = out_.channels_.in_component(
            Split::assumed, out_.channels_.from_rgb(ambient[0], ambient[1], ambient[2]));
        out_.irradiance_material_ = std::make_unique<WardMaterial>("Lambertian", nullptr, white, false);
        out_.surroundings_ = global_medium(settings_, out_.channels_);
        read_photons();
        if (!out_.photons_ || !out_.photons_->cover_surfaces()) add_images(relays);
        for (const auto& modifier : out_.modifiers_)
            if (auto* mist = dynamic_cast<Mist*>(modifier.get())) mist->find_sources(out_, out_.warnings_);
        if (settings_.split) out_.split_ = std::make_shared<const Split>(out_, *settings_.split);
        if (settings_.guided_samples > 0) out_.guide_ = Guide::build(out_, settings_);
    }

  private:
    void mark_cut_finishes() {
        for (const auto& modifier : out_.modifiers_) {
            const auto* antimatter = dynamic_cast<const Antimatter*>(modifier.get());
            if (!antimatter) continue;
            for (const PrimitiveId cut : antimatter->modifiers())
                for (Finish& finish : out_.surfaces_.finishes)
                    if (finish.primitive == cut) finish.may_be_cut = true;
        }
    }

    void read_photons() {
        if (settings_.photon_maps.empty()) return;
        if (settings_.split)
            throw Error("photon maps do not tell where their light comes from", "leave -split out");
        if (out_.channel_count() != 3 || !out_.channels_.shows_colors())
            throw Error("photon maps hold red, green and blue, not spectra", "leave -cs and -cw out");
        out_.photons_ = std::make_shared<const PhotonMaps>(settings_, out_.warnings_);
    }

    void make_sources() {
        bool indirect = false;
        InstanceBoxes boxes(scene_);
        std::vector<Surface>& surfaces = out_.surfaces_.surfaces;
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            Surface& surface = surfaces[i];
            const PrimitiveType type = scene_.type(surface.primitive);
            if (type == PrimitiveType::instance || type == PrimitiveType::mesh) continue;
            const Finish& finish = out_.finish(static_cast<int>(i));
            const Modifier* material = finish.material ? Modifier::material_of(finish.modifier) : nullptr;
            if (settings_.guided_samples > 0) note_emission(static_cast<int>(i), type, boxes);
            const Emitter* emitter = material ? material->emitter() : nullptr;
            if (!emitter) continue;
            // What emits besides reflecting is worth seeing without any light.
            indirect = indirect || !material->traits()->is_light;
            if (emitter->radiance().maximum() <= same_place) continue;
            const bool distant = type == PrimitiveType::source;
            if (emitter->kind() == Emitter::Kind::glow && !distant && emitter->reach() <= same_place) {
                indirect = indirect || settings_.ambient_bounces > 0;
                continue;
            }
            LightSource source = make_light_source(scene_, surface.primitive, *emitter, out_.warnings_);
            source.surface = static_cast<int>(i);
            source.modifier = finish.modifier;
            if (material == finish.modifier && !material->next() && material->traits()->is_light &&
                (emitter->kind() == Emitter::Kind::light || emitter->kind() == Emitter::Kind::glow))
                source.even_radiance = &emitter->radiance();
            indirect = indirect || (source.skip && settings_.ambient_bounces > 0);
            surface.source = static_cast<int>(out_.sources_.size());
            if (distant) out_.distant_.push_back(surface.source);
            if (!source.skip) out_.sampled_.push_back(surface.source);
            out_.sources_.push_back(source);
        }
        std::erase_if(out_.emitting_, [&](const CompiledScene::EmittingSurface& emitting) {
            return out_.surface(emitting.surface).source >= 0;
        });
        if (out_.sampled_.empty() && !indirect && !surfaces.empty())
            out_.warnings_.push_back("no light sources found");
    }

    void note_emission(int number, PrimitiveType type, InstanceBoxes& boxes) {
        const Finish& finish = out_.finish(number);
        if (!finish.material || !finish.material->emits || type == PrimitiveType::source) return;
        const Box box = surface_box(scene_, out_.surface(number).primitive, boxes);
        const double radius = box.empty() ? 0.0 : 0.5 * length(box.high - box.low);
        if (radius > same_place) out_.emitting_.push_back({number, (box.low + box.high) * 0.5, radius});
    }

    // Traces rays, so that all else must be in its place.
    void add_images(const std::vector<RelaySurface>& relays) {
        const int real = static_cast<int>(out_.sources_.size());
        add_virtual_sources(out_, settings_, relays, out_.sources_);
        for (int i = real; i < static_cast<int>(out_.sources_.size()); ++i) out_.sampled_.push_back(i);
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
    const RenderSettings& settings_;
    CompileContext context_;
};

std::shared_ptr<const CompiledScene> CompiledScene::compile(
    Scene scene, const RenderSettings& settings, const Channels& channels,
    const std::vector<FunctionDefinition>& definitions) {
    if (settings.max_reflections <= 0 && settings.min_weight <= 0)
        throw Error("-lr below 1 needs a -lw above 0", "Russian roulette ends rays lighter than -lw");
    const std::shared_ptr<CompiledScene> compiled(new CompiledScene);
    compiled->channels_ = channels;
    compiled->parts_.push_back({std::move(scene), 0});
    SceneCompiler(*compiled, settings).run(definitions);
    return compiled;
}

int CompiledScene::shining_surface(int number) const {
    while (source(number).is_virtual()) number = source(number).parent;
    return source(number).surface;
}

const ScenePart& CompiledScene::part_of(PrimitiveId number) const {
    const auto after = [](PrimitiveId wanted, const ScenePart& part) { return wanted < part.first; };
    return *(std::upper_bound(parts_.begin(), parts_.end(), number, after) - 1);
}

std::string_view CompiledScene::surface_name(int surface_index) const {
    const PrimitiveId number = surface(surface_index).primitive;
    const ScenePart& part = part_of(number);
    return part.text.name(number - part.first);
}

std::string_view CompiledScene::modifier_name(int surface_index) const {
    const PrimitiveId number = surface(surface_index).primitive;
    const ScenePart& part = part_of(number);
    const PrimitiveId modifier = part.text.modifier(number - part.first);
    return modifier == void_primitive ? "void" : part.text.name(modifier);
}

Error CompiledScene::error(PrimitiveId number, std::string_view message, std::string_view hint) const {
    const ScenePart& part = part_of(number);
    return part.text.error(number - part.first, message, hint);
}

std::string_view CompiledScene::material_name(int surface_index) const {
    const MaterialTraits* material = finish(surface_index).material;
    return material ? material->name : "void";
}

}  // namespace infra
