#include "scene/transform.h"

#include <numbers>
#include <vector>

#include "common/parse_number.h"

namespace infra {
namespace {

Transform translation(double x, double y, double z) {
    Transform t;
    t.matrix[3] = {x, y, z, 1};
    return t;
}

/// Rotation about axis 0, 1 or 2, counter-clockwise when looking down the axis.
Transform rotation(int axis, double degrees) {
    const double angle = degrees * (std::numbers::pi / 180);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Transform t;
    t.matrix[u][u] = t.matrix[v][v] = std::cos(angle);
    t.matrix[u][v] = std::sin(angle);
    t.matrix[v][u] = -t.matrix[u][v];
    return t;
}

Transform scaling(double factor) {
    Transform t;
    for (int i = 0; i < 3; ++i) t.matrix[i][i] = factor;
    t.scale = factor;
    return t;
}

Transform mirroring(int axis) {
    Transform t;
    t.matrix[axis][axis] = -1;
    t.scale = -1;
    return t;
}

/// `start`, then `step` count times; none for count <= 0. One after the other, as RADIANCE does, so that
/// coordinates agree to the last digit; by repeated squaring where that would take long.
Transform then_repeated(const Transform& start, Transform step, int count) {
    constexpr int many = 10000;
    Transform result = start;
    if (count < many) {
        for (int i = 0; i < count; ++i) result = result * step;
        return result;
    }
    for (; count > 0; count /= 2) {
        if (count % 2) result = result * step;
        step = step * step;
    }
    return result;
}

/// One option with its numbers at the beginning of `words`.
struct Step {
    std::size_t words = 0;  ///< 0: not a complete option
    Transform transform;
    bool iterates = false;
    int count = 1;
};

Step read_step(std::span<const std::string_view> words) {
    Step step;
    const std::string_view option = words[0];
    if (!is_transform_option(option)) return step;
    double x = 0, y = 0, z = 0;
    const auto real = [&](std::size_t i, double& value) {
        return i < words.size() && parse_real(words[i], value);
    };
    switch (option[1]) {
        case 't':
            if (real(1, x) && real(2, y) && real(3, z)) return {4, translation(x, y, z)};
            break;
        case 's':
            if (real(1, x) && x != 0.0) return {2, scaling(x)};
            break;
        case 'r':
            if (real(1, x)) return {2, rotation(option[2] - 'x', x)};
            break;
        case 'm':
            return {1, mirroring(option[2] - 'x')};
        case 'i':
            step.iterates = words.size() > 1 && parse_int(words[1], step.count);
            step.words = step.iterates ? 2 : 0;
            break;
    }
    return step;
}

}  // namespace

Matrix4 multiply(const Matrix4& a, const Matrix4& b) {
    Matrix4 product{};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            product[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] + a[i][3] * b[3][j];
    return product;
}

Transform operator*(const Transform& a, const Transform& b) {
    return {multiply(a.matrix, b.matrix), a.scale * b.scale};
}

/// The linear part is an orthogonal matrix times the scale, so its inverse is its transpose over the scale
/// squared.
Transform Transform::inverse() const {
    Transform inverse;
    const double factor = 1 / (scale * scale);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) inverse.matrix[i][j] = factor * matrix[j][i];
    for (int j = 0; j < 3; ++j) {
        double moved = 0;
        for (int k = 0; k < 3; ++k) moved -= matrix[3][k] * inverse.matrix[k][j];
        inverse.matrix[3][j] = moved;
    }
    inverse.scale = 1 / scale;
    return inverse;
}

bool is_transform_option(std::string_view word) {
    if (word.size() < 2 || word[0] != '-') return false;
    if (word.size() == 2) return word[1] == 't' || word[1] == 's' || word[1] == 'i';
    return word.size() == 3 && (word[1] == 'r' || word[1] == 'm') && word[2] >= 'x' && word[2] <= 'z';
}

std::size_t parse_transform(std::span<const std::string_view> words, Transform& transform) {
    Transform total, part;  // part: what follows the last -i, to be repeated `count` times
    int count = 1;
    std::size_t read = 0;
    while (read < words.size()) {
        const Step step = read_step(words.subspan(read));
        if (step.words == 0) break;
        if (step.iterates) {
            total = then_repeated(total, part, count);
            part = Transform{};
            count = step.count;
        } else {
            part = part * step.transform;
        }
        read += step.words;
    }
    transform = then_repeated(total, part, count);
    return read;
}

std::size_t parse_transform(std::span<const std::string> words, Transform& transform) {
    const std::vector<std::string_view> views(words.begin(), words.end());
    return parse_transform(views, transform);
}

}  // namespace infra
