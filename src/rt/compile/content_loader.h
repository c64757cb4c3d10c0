// Octrees and meshes that a scene places: each file is read and compiled once.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "rt/compile/part_compiler.h"
#include "scene/warnings.h"

namespace infra {

struct Mesh;

class ContentLoader {
  public:
    explicit ContentLoader(CompileContext& context) : context_(context) {}

    /// Adds the instances and meshes of a part to its geometry, and what stands in them to the contents.
    ///   throws  Error for files that are missing or something else, bad transforms, octrees that contain
    ///           themselves
    void place(const ScenePart& part, SurfaceRange range, Geometry& geometry);

  private:
    void place(const ScenePart& part, PrimitiveId id, int surface, Geometry& geometry);
    const Geometry& content(const Scene& scene, PrimitiveId id);
    void compile_octree(Scene scene, const std::string& path, Geometry& geometry);
    void compile_mesh(Mesh mesh, const std::string& name, Geometry& geometry);
    void warn_of_sources(const std::string& path, const ScenePart& part, SurfaceRange range);
    WarningSink warnings();
    ScenePart& add_part(Scene scene);

    CompileContext& context_;
    std::map<std::string, const Geometry*, std::less<>> loaded_;  // by path; nullptr while it is under way
    int depth_ = 0;                                               // of octrees within octrees
};

}  // namespace infra
