#include "rt/compile/content_loader.h"

#include <limits>

#include "common/raypath.h"
#include "rt/materials/light_material.h"
#include "scene/mesh/mesh.h"
#include "scene/octree_file.h"
#include "scene/transform.h"

namespace infra {
namespace {

constexpr int deepest_nesting = 100;  // a ray's way through it takes a few kilobytes of stack a level

const char* kind_of(PrimitiveType type) { return type == PrimitiveType::mesh ? "mesh" : "octree"; }

/// What `load` returns. A file that it cannot take is an error of the primitive that names it; one in the
/// text that the file leads to keeps its place.
template <class Load>
auto read(const Scene& scene, PrimitiveId id, const Load& load) {
    try {
        return load();
    } catch (const Error& error) {
        if (error.where().line > 0) throw;
        throw scene.error(id, error.what(),
                          "an instance is an octree made by oconv, a mesh one made by obj2mesh");
    }
}

}  // namespace

void ContentLoader::place(const ScenePart& part, SurfaceRange range, Geometry& geometry) {
    for (int i = range.begin; i < range.end; ++i) {
        const PrimitiveId id = context_.surfaces[i].primitive - part.first;
        const PrimitiveType type = part.text.type(id);
        if (type == PrimitiveType::instance || type == PrimitiveType::mesh) place(part, id, i, geometry);
    }
}

void ContentLoader::place(const ScenePart& part, PrimitiveId id, int surface, Geometry& geometry) {
    const Scene& scene = part.text;
    const auto words = scene.strings(id).subspan(1);
    Transform to_outside;
    if (parse_transform(words, to_outside) != words.size())
        throw scene.error(id, "bad transform", "options such as -t x y z, -rx angle, -s factor, -mx");
    const bool covers = scene.modifier(id) != void_primitive;
    geometry.add_instance(content(scene, id), Placement(to_outside), surface, covers);
}

const Geometry& ContentLoader::content(const Scene& scene, PrimitiveId id) {
    const PrimitiveType type = scene.type(id);
    const std::string name(scene.strings(id)[0]);
    const auto path = find_library_file(name);
    if (!path) throw scene.error(id, std::string("cannot find ") + kind_of(type) + " file \"" + name + "\"");
    const auto [entry, is_new] = loaded_.try_emplace(kind_of(type) + std::string(" ") + *path, nullptr);
    if (!is_new) {
        if (entry->second) return *entry->second;
        throw scene.error(id, "octree \"" + name + "\" contains an instance of itself");
    }
    if (depth_ == deepest_nesting) throw scene.error(id, "octrees within octrees are nested too deep");
    ++depth_;
    auto made = std::make_unique<Geometry>(context_.surfaces, Geometry::Role::content);
    if (type == PrimitiveType::mesh) {
        compile_mesh(read(scene, id, [&] { return load_mesh(name, warnings()); }), name, *made);
        made->build();
    } else {
        compile_octree(read(scene, id, [&] { return load_octree(*path, warnings()).scene; }), *path, *made);
    }
    --depth_;
    entry->second = made.get();
    context_.contents.push_back(std::move(made));
    return *entry->second;
}

void ContentLoader::compile_octree(Scene scene, const std::string& path, Geometry& geometry) {
    ScenePart& part = add_part(std::move(scene));
    const SurfaceRange range = add_surfaces(context_, part);
    finish_surfaces(context_, part, range);
    add_shapes(context_, part, range, geometry);
    warn_of_sources(path, part, range);
    place(part, range, geometry);
    geometry.build();
    part.text.release_geometry_arguments();
}

// A mesh has no surfaces by name. RADIANCE calls them all "M-Tri"; there is one for each material.
void ContentLoader::compile_mesh(Mesh mesh, const std::string& name, Geometry& geometry) {
    mesh.materials.push_back(void_primitive);
    for (const PrimitiveId material : mesh.materials)
        mesh.scene.add(PrimitiveType::polygon, material, "M-Tri", {}, {});
    const ScenePart& part = add_part(std::move(mesh.scene));
    const SurfaceRange range = add_surfaces(context_, part);
    finish_surfaces(context_, part, range);
    std::vector<int> surface_of;
    for (int i = range.begin; i < range.end; ++i) surface_of.push_back(i);
    warn_of_sources(name, part, range);
    geometry.set_facets(Facets(mesh, surface_of), surface_of.back());
}

// As in RADIANCE, only the surfaces of the scene itself are light sources.
void ContentLoader::warn_of_sources(const std::string& path, const ScenePart& part, SurfaceRange range) {
    bool lights = false, distant = false;
    for (int i = range.begin; i < range.end; ++i) {
        distant =
            distant || part.text.type(context_.surfaces[i].primitive - part.first) == PrimitiveType::source;
        const Finish& finish = context_.surfaces.finish(i);
        const Modifier* material = finish.material ? Modifier::material_of(finish.modifier) : nullptr;
        const Emitter* emitter = material && finish.material->is_light ? material->emitter() : nullptr;
        lights = lights || (emitter && emitter->kind() != Emitter::Kind::illum &&
                            emitter->radiance().maximum() > same_place &&
                            (emitter->kind() != Emitter::Kind::glow || emitter->reach() > same_place));
    }
    if (lights)
        context_.warnings.push_back(path +
                                    ": light sources within an instance or mesh are seen but give no light "
                                    "(they have to stand in the scene itself)");
    if (distant)
        context_.warnings.push_back(path +
                                    ": distant sources within an instance are not there "
                                    "(they have to stand in the scene itself)");
}

WarningSink ContentLoader::warnings() {
    return [this](std::string_view text) { context_.warnings.emplace_back(text); };
}

ScenePart& ContentLoader::add_part(Scene scene) {
    const ScenePart& last = context_.parts.back();
    const PrimitiveId first = last.first + last.text.size();
    if (scene.size() > std::numeric_limits<PrimitiveId>::max() - first)
        throw Error("too many primitives in the scene and its instances");
    context_.parts.push_back({std::move(scene), first});
    return context_.parts.back();
}

}  // namespace infra
