#include <charconv>
#include <limits>

#include "common/text.h"
#include "scene/mesh/line_reader.h"
#include "scene/mesh/model_formats.h"

namespace infra {
namespace {

class ObjReader {
  public:
    ObjReader(std::FILE* file, const std::string& name, const ModelOptions& options, VertexLists& vertices,
              FaceSink& sink)
        : lines_(file, name), options_(options), vertices_(vertices), sink_(sink) {}

    ModelSummary read();

  private:
    /// The statement of this key; false if it is none of ours.
    bool statement(std::string_view key, std::string_view rest);
    void position(std::string_view rest);
    void normal(std::string_view rest);
    bool texture_coordinate(std::string_view rest);
    void face(std::string_view rest);
    Corner corner(std::string_view word) const;
    /// The index at the beginning of `text`, which loses it and one '/'; from 0, or no_index for none.
    std::int32_t index(std::string_view word, std::string_view& text, std::size_t count,
                       const char* what) const;

    LineReader lines_;
    const ModelOptions& options_;
    VertexLists& vertices_;
    FaceSink& sink_;
    FaceNames names_;
    ModelSummary summary_;
    std::vector<Corner> corners_;
};

void ObjReader::position(std::string_view rest) {
    Vec3 p;
    if (!take_real(rest, p.x) || !take_real(rest, p.y) || !take_real(rest, p.z))
        lines_.fail("a vertex without three coordinates");
    vertices_.positions.push_back(p);
}

void ObjReader::normal(std::string_view rest) {
    Vec3 n;
    if (!take_real(rest, n.x) || !take_real(rest, n.y) || !take_real(rest, n.z))
        lines_.fail("a normal without three components");
    const double size = length(n);
    if (size == 0) {
        ++summary_.zero_normals;
        if (options_.refuse_zero_normals) lines_.fail("a normal of length zero");
    }
    vertices_.normals.push_back(size > 0 ? n / size : Vec3(0));
}

bool ObjReader::texture_coordinate(std::string_view rest) {
    Uv uv;
    if (!take_real(rest, uv[0]) || !take_real(rest, uv[1])) return false;
    vertices_.uv.push_back(uv);
    return true;
}

std::int32_t ObjReader::index(std::string_view word, std::string_view& text, std::size_t count,
                              const char* what) const {
    if (text.empty() || text.front() == '/') {
        if (!text.empty()) text.remove_prefix(1);
        return Corner::no_index;
    }
    long long number = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
    text.remove_prefix(std::size_t(end - text.data()));
    if (problem != std::errc() || (!text.empty() && text.front() != '/'))
        lines_.fail("\"" + std::string(word) + "\" is no corner of a face");
    if (!text.empty()) text.remove_prefix(1);
    if (number == 0) return Corner::no_index;
    const long long from_zero = number > 0 ? number - 1 : number + (long long)(count);
    if (from_zero < 0 || from_zero >= (long long)(count))
        lines_.fail("a face with " + std::string(what) + " " + std::to_string(number) + " where there are " +
                    std::to_string(count));
    return std::int32_t(from_zero);
}

Corner ObjReader::corner(std::string_view word) const {
    std::string_view text = word;
    Corner corner;
    corner.position = index(word, text, vertices_.positions.size(), "vertex");
    if (corner.position == Corner::no_index)
        lines_.fail("\"" + std::string(word) + "\" is a corner without a vertex", "they are numbered from 1");
    corner.uv = index(word, text, vertices_.uv.size(), "texture coordinate");
    corner.normal = index(word, text, vertices_.normals.size(), "normal");
    return corner;
}

void ObjReader::face(std::string_view rest) {
    corners_.clear();
    for (auto word = take_word(rest); !word.empty(); word = take_word(rest)) corners_.push_back(corner(word));
    if (corners_.size() < 3) lines_.fail("a face with fewer than three corners");
    sink_.face({vertices_, corners_, names_, ++summary_.faces, lines_.name(), lines_.number()});
}

bool ObjReader::statement(std::string_view key, std::string_view rest) {
    if (key == "v") {
        position(rest);
    } else if (key == "vn") {
        normal(rest);
    } else if (key == "vt") {
        return texture_coordinate(rest);
    } else if (key == "f") {
        face(rest);
    } else if (key == "usemtl") {
        names_.material = take_word(rest);
        ++names_.changes;
    } else if (key == "usemap") {
        const std::string_view map = take_word(rest);
        names_.map = map == "off" ? "" : map;
        ++names_.changes;
    } else if (key == "o") {
        names_.object = take_word(rest);
        ++names_.changes;
    } else if (key == "g") {
        names_.groups.clear();
        for (auto word = take_word(rest); !word.empty(); word = take_word(rest))
            names_.groups.emplace_back(word);
        ++names_.changes;
    } else {
        return false;
    }
    return true;
}

ModelSummary ObjReader::read() {
    constexpr std::size_t most = std::size_t(std::numeric_limits<std::int32_t>::max());
    for (std::string_view line; lines_.next(line);) {
        std::string_view rest = line;
        const std::string_view key = take_word(rest);
        if (key.empty()) continue;
        ++summary_.statements;
        if (key.front() == '#')
            sink_.comment(line);
        else if (!statement(key, rest))
            ++summary_.unrecognized;
        if (vertices_.positions.size() > most || vertices_.normals.size() > most ||
            vertices_.uv.size() > most)
            lines_.fail("more than 2147483647 vertices");
    }
    summary_.lines = lines_.number();
    return summary_;
}

}  // namespace

ModelSummary read_obj(std::FILE* file, const std::string& name, const ModelOptions& options,
                      VertexLists& vertices, FaceSink& sink) {
    return ObjReader(file, name, options, vertices, sink).read();
}

}  // namespace infra
