#include <sys/stat.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "common/text.h"
#include "scene/mesh/line_reader.h"
#include "scene/mesh/model_formats.h"

namespace infra {
namespace {

constexpr std::size_t binary_header = 84;  // 80 of anything, then the number of facets
constexpr std::size_t binary_facet = 50;   // normal and three corners in 12 floats, then 2 bytes for nothing

constexpr std::array<Corner, 3> last_three(std::size_t positions) {
    const auto end = static_cast<std::int32_t>(positions);
    return {Corner{end - 3}, Corner{end - 2}, Corner{end - 1}};
}

/// Hands facets on, with positions of their own: whatever packs them finds which are the same.
class Facets {
  public:
    Facets(const std::string& name, const ModelOptions& options, VertexLists& vertices, FaceSink& sink)
        : name_(name), options_(options), vertices_(vertices), sink_(sink) {}

    void add(const std::array<Vec3, 3>& corners, int line) {
        constexpr std::size_t most_positions = 0x7fffffff - 3;
        auto& positions = vertices_.positions;
        if (options_.forget_vertices) positions.clear();
        if (positions.size() > most_positions) throw Error(Location{name_}, "more than 715827881 facets");
        positions.insert(positions.end(), corners.begin(), corners.end());
        const auto at = last_three(positions.size());
        sink_.face({vertices_, at, names, ++count, name_, line});
    }

    FaceNames names;
    int count = 0;

  private:
    const std::string& name_;
    const ModelOptions& options_;
    VertexLists& vertices_;
    FaceSink& sink_;
};

float little_endian_float(const unsigned char* bytes) {
    const std::uint32_t bits = std::uint32_t(bytes[0]) | std::uint32_t(bytes[1]) << 8 |
                               std::uint32_t(bytes[2]) << 16 | std::uint32_t(bytes[3]) << 24;
    return std::bit_cast<float>(bits);
}

void read_binary(std::FILE* file, const std::string& name, std::uint32_t facets, Facets& out) {
    unsigned char record[binary_facet];
    for (std::uint32_t i = 0; i < facets; ++i) {
        const auto fail = [&](const std::string& what) {
            throw Error(Location{name},
                        what + " in facet " + std::to_string(i + 1) + " of " + std::to_string(facets));
        };
        if (std::fread(record, binary_facet, 1, file) != 1) fail("the file ends");
        std::array<Vec3, 3> corners;
        for (int k = 0; k < 9; ++k) {
            const float value = little_endian_float(record + 12 + 4 * k);
            if (!std::isfinite(value)) fail("a coordinate that is no number");
            corners[k / 3][k % 3] = value;
        }
        out.add(corners, 0);
    }
}

/// solid NAME, then facets ("facet normal x y z", "outer loop", three "vertex x y z", "endloop", "endfacet"),
/// endsolid.
class TextReader {
  public:
    TextReader(std::FILE* file, const std::string& name, Facets& out) : lines_(file, name), out_(out) {}

    int read() {
        while (statement()) {
        }
        if (in_facet_) lines_.fail("the file ends within a facet");
        return lines_.number();
    }

  private:
    bool statement() {
        std::string_view line;
        if (!lines_.next(line)) return false;
        const std::string_view key = take_word(line);
        if (key.empty() || key == "endsolid" || key == "outer" || key == "endloop") return true;
        if (key == "solid") {
            out_.names.object = take_word(line);
            ++out_.names.changes;
        } else if (key == "facet" && !in_facet_) {
            in_facet_ = true;
            corners_ = 0;
        } else if (key == "vertex" && in_facet_) {
            if (corners_ == 3) lines_.fail("a facet with more than three corners");
            Vec3& p = corner_[corners_++];
            if (!take_real(line, p.x) || !take_real(line, p.y) || !take_real(line, p.z))
                lines_.fail("a vertex without three coordinates");
        } else if (key == "endfacet" && in_facet_) {
            if (corners_ < 3) lines_.fail("a facet with fewer than three corners");
            out_.add(corner_, lines_.number());
            in_facet_ = false;
        } else {
            lines_.fail("\"" + std::string(key) + "\" where " + (in_facet_ ? "a vertex" : "a facet") +
                        " should be");
        }
        return true;
    }

    LineReader lines_;
    Facets& out_;
    std::array<Vec3, 3> corner_;
    int corners_ = 0;
    bool in_facet_ = false;
};

}  // namespace

ModelSummary read_stl(std::FILE* file, const std::string& name, const ModelOptions& options,
                      VertexLists& vertices, FaceSink& sink) {
    unsigned char header[binary_header] = {};
    const std::size_t read = std::fread(header, 1, binary_header, file);
    const std::uint32_t facets = std::uint32_t(header[80]) | std::uint32_t(header[81]) << 8 |
                                 std::uint32_t(header[82]) << 16 | std::uint32_t(header[83]) << 24;
    struct stat status {};
    const bool sized = read == binary_header && fstat(fileno(file), &status) == 0 &&
                       std::uint64_t(status.st_size) == binary_header + binary_facet * std::uint64_t(facets);
    // Binary files may begin with "solid" too: only the size tells.
    const bool is_text = !sized && read >= 5 && std::memcmp(header, "solid", 5) == 0;
    Facets out(name, options, vertices, sink);
    ModelSummary summary;
    if (is_text) {
        std::rewind(file);
        summary.lines = TextReader(file, name, out).read();
    } else {
        if (read < binary_header) throw Error(Location{name}, "this is no STL file: shorter than its header");
        read_binary(file, name, facets, out);
    }
    summary.faces = out.count;
    return summary;
}

}  // namespace infra
