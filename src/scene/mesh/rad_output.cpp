#include "scene/mesh/rad_output.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <ostream>

#include "common/error.h"
#include "common/format.h"
#include "scene/mesh/triangle_normals.h"

namespace infra {
namespace {

constexpr const char* texture_name = "Phong";
constexpr const char* default_material = "white";
constexpr const char* default_object = "unnamed";
constexpr double plane_cosine = 1 - 1e-6;  // of a face's parts, RADIANCE's

/// A name as scene files take it: they give quotes a meaning.
std::string as_identifier(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return c == '"' || c == '\''; }, '^');
    return name;
}

Vec3 normal_or_zero(const Vec3& v) {
    const double size = length(v);
    return size > 0 ? v / size : Vec3(0);
}

/// All triangles from the first corner have one normal, or its opposite where the face is concave.
bool is_plane(std::span<const Vec3> corners) {
    Vec3 normal(0);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const Vec3 here = normal_or_zero(cross(corners[i - 1] - corners[0], corners[i] - corners[0]));
        if (here == Vec3(0)) continue;
        if (normal == Vec3(0)) normal = here;
        if (std::abs(dot(normal, here)) < plane_cosine) return false;
    }
    return true;
}

bool has_area(std::span<const Vec3> corners) {
    Vec3 sum(0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return sum != Vec3(0);
}

}  // namespace

void RadOutput::comment(std::string_view text) { out_ << text << '\n'; }

/// As " %18.12g" thrice, which takes most of the time that a large model takes.
void RadOutput::point(const Vec3& p) {
    constexpr std::ptrdiff_t width = 18;
    char line[128];
    char* end = line;
    for (int i = 0; i < 3; ++i) {
        char digits[32];
        const auto last = std::to_chars(digits, std::end(digits), p[i], std::chars_format::general, 12).ptr;
        *end++ = ' ';
        end = std::fill_n(end, std::max<std::ptrdiff_t>(0, width - (last - digits)), ' ');
        end = std::copy(digits, last, end);
    }
    *end++ = '\n';
    out_.write(line, end - line);
}

std::string RadOutput::material_of(const Face& face) const {
    if (settings_.rules) return as_identifier(settings_.rules->material(face).value_or(""));
    if (!face.names.material.empty()) return as_identifier(face.names.material);
    return as_identifier(face.names.groups.empty() ? default_material : face.names.groups.front());
}

std::string RadOutput::name_of(const Face& face) const {
    if (!face.names.object.empty()) return as_identifier(face.names.object);
    if (!settings_.object.empty()) return as_identifier(settings_.object);
    std::string name;
    for (const std::string& group : face.names.groups) name += (name.empty() ? "" : ".") + group;
    return as_identifier(name.empty() ? default_object : name);
}

void RadOutput::begin_polygon(const Face& face, std::string_view modifier, std::size_t corners) {
    out_ << '\n'
         << modifier << " polygon " << name_ << '.' << face.number << "\n0\n0\n"
         << 3 * corners << '\n';
}

void RadOutput::face(const Face& face) {
    if (settings_.rules || face.names.changes != names_known_) material_ = material_of(face);
    if (face.names.changes != names_known_) name_ = name_of(face);
    names_known_ = face.names.changes;
    if (material_.empty()) return;  // by a rule that says void, or by none
    if (!out_) throw Error("cannot write the output: is the device full?", "", Severity::system);

    outline_.clear();
    for (const Corner& corner : face.corners) outline_.push_back(face.vertices.positions[corner.position]);
    if (face.corners.size() == 3) return triangle(face, {face.corners[0], face.corners[1], face.corners[2]});
    const bool smooth = !settings_.flat && face.corners[0].normal != Corner::no_index;
    if (smooth || !is_plane(outline_)) return split(face);
    if (!has_area(outline_)) {
        ++without_area_;
        return;
    }
    begin_polygon(face, material_, outline_.size());
    for (const Vec3& p : outline_) point(p);
}

void RadOutput::split(const Face& face) {
    const Triangulation result = triangulate_(outline_, [&](std::array<int, 3> i) {
        triangle(face, {face.corners[i[0]], face.corners[i[1]], face.corners[i[2]]});
    });
    if (result == Triangulation::degenerate) ++without_area_;
}

void RadOutput::triangle(const Face& face, std::array<Corner, 3> corners) {
    const auto& points = face.vertices.positions;
    const Vec3 own = normal_or_zero(cross(points[corners[1].position] - points[corners[0].position],
                                          points[corners[2].position] - points[corners[1].position]));
    if (own == Vec3(0)) {
        ++without_area_;
        return;
    }
    TriangleNormals normals;
    const auto known = [&](const Corner& corner) {
        return corner.normal != Corner::no_index && face.vertices.normals[corner.normal] != Vec3(0);
    };
    if (std::ranges::all_of(corners, known)) {
        const auto at = [&](int i) { return face.vertices.normals[corners[i].normal]; };
        normals = compare_normals(own, {at(0), at(1), at(2)});
    }
    const bool textured = normals.smooth && !settings_.flat;
    if (textured) texture(face, corners);
    if (normals.turned) std::swap(corners[0], corners[2]);
    begin_polygon(face, textured ? std::string_view(texture_name) : material_, 3);
    for (const Corner& corner : corners) point(points[corner.position]);
}

/// Weights of the corners are linear in the two coordinates that remain when the triangle is looked at along
/// `axis`; so is each component of the normal: k0 bu + k1 bv + k2.
void RadOutput::texture(const Face& face, const std::array<Corner, 3>& corners) {
    const auto position = [&](int i) { return face.vertices.positions[corners[i].position]; };
    const auto normal = [&](int i) { return face.vertices.normals[corners[i].normal]; };
    const Vec3 area = cross(position(1) - position(0), position(2) - position(0));
    int axis = std::abs(area.y) > std::abs(area.x) ? 1 : 0;
    if (std::abs(area.z) > std::abs(area[axis])) axis = 2;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;

    const Vec3 last = position(2), a = position(0) - last, b = position(1) - last;
    const double determinant = a[u] * b[v] - a[v] * b[u];
    const double weight_a[] = {b[v] / determinant, -b[u] / determinant};
    const double weight_b[] = {-a[v] / determinant, a[u] / determinant};

    out_ << '\n' << material_ << " texfunc " << texture_name << "\n4 dx dy dz tmesh.cal\n0\n";
    out_ << formatted("10\t%d\n", axis);
    for (int i = 0; i < 3; ++i) {
        const double from_a = normal(0)[i] - normal(2)[i], from_b = normal(1)[i] - normal(2)[i];
        const double along_u = weight_a[0] * from_a + weight_b[0] * from_b;
        const double along_v = weight_a[1] * from_a + weight_b[1] * from_b;
        const double constant = normal(2)[i] - along_u * last[u] - along_v * last[v];
        out_ << formatted("%16.10g %16.10g %16.10g\n", along_u, along_v, constant);
    }
}

}  // namespace infra
