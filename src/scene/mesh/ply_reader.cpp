#include <bit>
#include <cmath>
#include <memory>

#include "scene/mesh/line_reader.h"
#include "scene/mesh/model_formats.h"
#include "scene/mesh/ply_header.h"

namespace infra {
namespace {

constexpr std::size_t most_corners = 1 << 20;  // of a face; more is damage

/// Numbers of the elements one after another, from text or binary.
class NumberSource {
  public:
    NumberSource(std::FILE* file, const std::string& name, const PlyHeader& header)
        : file_(file), name_(name), encoding_(header.encoding), header_lines_(header.lines) {
        if (encoding_ == PlyEncoding::text) lines_ = std::make_unique<LineReader>(file, name);
    }

    /// In text each element has a line to itself.
    void begin(const PlyElement& element, std::int64_t index) {
        element_ = &element;
        index_ = index;
        if (!lines_) return;
        do {
            if (!lines_->next(rest_)) fail("the file ends");
        } while (rest_.find_first_not_of(" \t") == std::string_view::npos);
    }

    double number(PlyType type) { return lines_ ? text_number() : binary_number(type); }

    int line() const { return lines_ ? header_lines_ + lines_->number() : 0; }

    [[noreturn]] void fail(const std::string& what) const {
        throw Error(Location{name_, line()}, what + " in " + element_->name + " " + std::to_string(index_) +
                                                 " of " + std::to_string(element_->count));
    }

  private:
    double text_number() {
        double value = 0;
        if (!take_real(rest_, value)) fail("a number is missing");
        return value;
    }

    double binary_number(PlyType type) {
        unsigned char bytes[8];
        if (std::fread(bytes, type.size, 1, file_) != 1) fail("the file ends");
        std::uint64_t bits = 0;
        for (int i = 0; i < type.size; ++i)
            bits = bits << 8 | bytes[encoding_ == PlyEncoding::big_endian ? i : type.size - 1 - i];
        if (type.kind == PlyType::Kind::real) {
            const double value =
                type.size == 8 ? std::bit_cast<double>(bits) : std::bit_cast<float>(std::uint32_t(bits));
            if (!std::isfinite(value)) fail("a value that is no number");
            return value;
        }
        if (type.kind == PlyType::Kind::unsigned_integer) return double(bits);
        const int unused = 64 - 8 * type.size;
        return double(std::int64_t(bits << unused) >> unused);
    }

    std::FILE* file_;
    const std::string& name_;
    PlyEncoding encoding_;
    int header_lines_;
    std::unique_ptr<LineReader> lines_;
    std::string_view rest_;
    const PlyElement* element_ = nullptr;
    std::int64_t index_ = 0;
};

/// What a property of a vertex is for us.
enum class Meaning { nothing, x, y, z, nx, ny, nz, u, v };

Meaning meaning_of(const PlyProperty& property) {
    static constexpr std::pair<std::string_view, Meaning> known[] = {
        {"x", Meaning::x},         {"y", Meaning::y},         {"z", Meaning::z},
        {"nx", Meaning::nx},       {"ny", Meaning::ny},       {"nz", Meaning::nz},
        {"u", Meaning::u},         {"v", Meaning::v},         {"s", Meaning::u},
        {"t", Meaning::v},         {"texture_u", Meaning::u}, {"texture_v", Meaning::v},
        {"texture_s", Meaning::u}, {"texture_t", Meaning::v},
    };
    for (const auto& [name, meaning] : known)
        if (!property.is_list && property.name == name) return meaning;
    return Meaning::nothing;
}

class PlyReader {
  public:
    PlyReader(std::FILE* file, const std::string& name, const PlyHeader& header, VertexLists& vertices,
              FaceSink& sink)
        : name_(name), header_(header), numbers_(file, name, header), vertices_(vertices), sink_(sink) {}

    ModelSummary read();

  private:
    void read_vertices(const PlyElement& element);
    void read_faces(const PlyElement& element);
    void skip(const PlyElement& element);
    std::size_t list_length(const PlyProperty& property);
    void skip(const PlyProperty& property);

    const std::string& name_;
    const PlyHeader& header_;
    NumberSource numbers_;
    VertexLists& vertices_;
    FaceSink& sink_;
    bool has_normals_ = false, has_uv_ = false;
    FaceNames names_;
    ModelSummary summary_;
    std::vector<Corner> corners_;
};

std::size_t PlyReader::list_length(const PlyProperty& property) {
    const double length = numbers_.number(property.count_type);
    if (!(length >= 0 && length <= double(most_corners)) || length != std::floor(length))
        numbers_.fail("a list of senseless length");
    return std::size_t(length);
}

void PlyReader::skip(const PlyProperty& property) {
    for (std::size_t left = property.is_list ? list_length(property) : 1; left > 0; --left)
        numbers_.number(property.type);
}

void PlyReader::skip(const PlyElement& element) {
    for (std::int64_t i = 0; i < element.count; ++i) {
        numbers_.begin(element, i);
        for (const PlyProperty& property : element.properties) skip(property);
    }
}

void PlyReader::read_vertices(const PlyElement& element) {
    std::vector<Meaning> meanings;
    unsigned found = 0;
    for (const PlyProperty& property : element.properties) {
        meanings.push_back(meaning_of(property));
        found |= 1u << int(meanings.back());
    }
    const auto has = [&](Meaning m) { return (found >> int(m) & 1) != 0; };
    if (!has(Meaning::x) || !has(Meaning::y) || !has(Meaning::z))
        throw Error(Location{name_}, "its vertices have no x, y and z");
    has_normals_ = has(Meaning::nx) && has(Meaning::ny) && has(Meaning::nz);
    has_uv_ = has(Meaning::u) && has(Meaning::v);
    for (std::int64_t i = 0; i < element.count; ++i) {
        numbers_.begin(element, i);
        double value[int(Meaning::v) + 1] = {};
        for (std::size_t k = 0; k < meanings.size(); ++k) {
            if (meanings[k] == Meaning::nothing)
                skip(element.properties[k]);
            else
                value[int(meanings[k])] = numbers_.number(element.properties[k].type);
        }
        const auto at = [&](Meaning m) { return value[int(m)]; };
        vertices_.positions.emplace_back(at(Meaning::x), at(Meaning::y), at(Meaning::z));
        if (has_normals_) {
            const Vec3 normal(at(Meaning::nx), at(Meaning::ny), at(Meaning::nz));
            const double size = length(normal);
            summary_.zero_normals += size == 0;
            vertices_.normals.push_back(size > 0 ? normal / size : Vec3(0));
        }
        if (has_uv_) vertices_.uv.push_back({at(Meaning::u), at(Meaning::v)});
    }
}

void PlyReader::read_faces(const PlyElement& element) {
    for (std::int64_t i = 0; i < element.count; ++i) {
        numbers_.begin(element, i);
        corners_.clear();
        for (const PlyProperty& property : element.properties) {
            const bool indices =
                property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
            if (!indices) {
                skip(property);
                continue;
            }
            for (std::size_t left = list_length(property); left > 0; --left) {
                const double index = numbers_.number(property.type);
                if (!(index >= 0 && index < double(vertices_.positions.size())) || index != std::floor(index))
                    numbers_.fail("a vertex that does not exist");
                const auto at = std::int32_t(index);
                corners_.push_back(
                    {at, has_uv_ ? at : Corner::no_index, has_normals_ ? at : Corner::no_index});
            }
        }
        if (corners_.size() < 3) numbers_.fail("fewer than three corners");
        sink_.face({vertices_, corners_, names_, ++summary_.faces, name_, numbers_.line()});
    }
}

ModelSummary PlyReader::read() {
    bool any_faces = false;
    for (const PlyElement& element : header_.elements) {
        if (element.name == "vertex") {
            if (any_faces) throw Error(Location{name_}, "faces before their vertices");
            read_vertices(element);
        } else if (element.name == "face") {
            any_faces = true;
            read_faces(element);
        } else {
            skip(element);
        }
    }
    if (!any_faces)
        throw Error(Location{name_}, "no faces", "clouds of points and strips of triangles are not read");
    summary_.lines = numbers_.line();
    return summary_;
}

}  // namespace

ModelSummary read_ply(std::FILE* file, const std::string& name, const ModelOptions&, VertexLists& vertices,
                      FaceSink& sink) {
    const PlyHeader header = read_ply_header(file, name);
    return PlyReader(file, name, header, vertices, sink).read();
}

}  // namespace infra
