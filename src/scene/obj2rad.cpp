// obj2rad: a model (OBJ, STL or PLY) in, polygons of RADIANCE's scene language out.
#include <iostream>
#include <optional>
#include <set>

#include "common/error.h"
#include "common/format.h"
#include "common/options.h"
#include "scene/mesh/model_reader.h"
#include "scene/mesh/rad_output.h"

namespace infra {
namespace {

struct Settings {
    RadSettings output;
    std::string rules;
    bool names_only = false;
};

OptionTable make_options(Settings& settings) {
    OptionTable options("obj2rad", "[model.obj|.stl|.ply]");
    options.describe("Writes a model as polygons. Without a file: OBJ from standard input.");
    options.text("-o", &settings.output.object, "name of the polygons where the file has none").named("name");
    options.text("-m", &settings.rules, "file of rules: which faces get which material").named("rules");
    options.custom(
        "-n", "", [&](const OptionValues&) { settings.names_only = true; },
        "list the names that rules may ask for, and no polygons");
    options.custom(
        "-f", "", [&](const OptionValues&) { settings.output.flat = true; },
        "flat: ignore the normals of vertices");
    return options;
}

/// Names that have faces.
class NameList : public FaceSink {
  public:
    void face(const Face& face) override {
        faces_ = face.number;
        if (face.names.changes == names_known_) return;
        names_known_ = face.names.changes;
        add("Material", face.names.material);
        add("Map", face.names.map);
        for (const std::string& group : face.names.groups) add("Group", group);
        add("Object", face.names.object);
    }

    void print(std::ostream& out, const std::string& file) const {
        out << "filename \"" << file << "\"\n";
        for (const char* const qualifier : {"Material", "Map", "Group", "Object"}) {
            bool any = false;
            for (const auto& [kind, name] : names_) {
                if (kind != qualifier) continue;
                if (!any) out << "qualifier " << qualifier << " begin\n";
                any = true;
                out << '"' << name << "\"\n";
            }
            if (any) out << "end\n";
        }
        out << "qualifier Face begin\n[1:" << faces_ << "]\nend\n";
    }

  private:
    void add(const char* kind, const std::string& name) {
        if (!name.empty()) names_.emplace(kind, name);
    }

    std::set<std::pair<std::string, std::string>> names_;
    int names_known_ = -1;
    int faces_ = 0;
};

int obj2rad(int argc, char** argv) {
    Settings settings;
    OptionTable options = make_options(settings);
    const auto files = options.parse(argc, argv);
    if (!files) return 0;
    if (files->size() > 1) throw Error("too many files", "one model");
    const std::string path = files->empty() ? "" : files->front();
    const std::string name = path.empty() ? "standard input" : path;
    std::ios::sync_with_stdio(false);

    constexpr ModelOptions stream = {.forget_vertices = true, .refuse_zero_normals = false};
    VertexLists vertices;
    if (settings.names_only) {
        NameList names;
        read_model(path, stream, vertices, names);
        names.print(std::cout, name);
        return 0;
    }
    std::optional<MaterialRules> rules;
    if (!settings.rules.empty()) settings.output.rules = &rules.emplace(settings.rules);
    std::vector<std::string> words(argv, argv + argc);
    words[0] = options.program();
    std::cout << "# " << join_command(words) << '\n';
    RadOutput output(std::cout, settings.output);
    const ModelSummary summary = read_model(path, stream, vertices, output);
    std::cout << "\n# " << name << ": " << summary.faces << " faces";
    if (summary.statements > 0)
        std::cout << "; " << summary.unrecognized << " of " << summary.statements
                  << " statements unrecognized";
    if (output.without_area() > 0) std::cout << "; left out without area: " << output.without_area();
    if (summary.zero_normals > 0) std::cout << "; normals of length zero: " << summary.zero_normals;
    std::cout << '\n';
    return 0;
}

}  // namespace
}  // namespace infra

int main(int argc, char** argv) { return infra::run_program("obj2rad", infra::obj2rad, argc, argv); }
