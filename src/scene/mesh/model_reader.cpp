#include "scene/mesh/model_reader.h"

#include <sys/stat.h>

#include <cctype>

#include "common/error.h"
#include "scene/mesh/model_formats.h"
#include "scene/octree_section.h"

namespace infra {
namespace {

bool has_extension(const std::string& path, std::string_view extension) {
    if (path.size() < extension.size()) return false;
    for (std::size_t i = 0; i < extension.size(); ++i)
        if (std::tolower(static_cast<unsigned char>(path[path.size() - extension.size() + i])) !=
            extension[i])
            return false;
    return true;
}

}  // namespace

ModelSummary read_model(const std::string& path, const ModelOptions& options, VertexLists& vertices,
                        FaceSink& sink) {
    if (path.empty()) return read_obj(stdin, "standard input", options, vertices, sink);
    const FileHandle file = open_scene_file(path, "model");
    struct stat status {};
    if (fstat(fileno(file.get()), &status) == 0 && S_ISDIR(status.st_mode))
        throw Error("cannot read \"" + path + "\": it is a folder");
    if (has_extension(path, ".stl")) return read_stl(file.get(), path, options, vertices, sink);
    if (has_extension(path, ".ply")) return read_ply(file.get(), path, options, vertices, sink);
    return read_obj(file.get(), path, options, vertices, sink);
}

}  // namespace infra
