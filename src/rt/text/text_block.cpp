#include "rt/text/text_block.h"

#include <cmath>

#include "common/raypath.h"
#include "common/text.h"
#include "common/text_file.h"
#include "rt/compile/data_cache.h"
#include "rt/compile/modifier_table.h"
#include "rt/tracer.h"

namespace infra {
namespace {

std::string lines_of_file(const ModifierContext& context, std::string_view name) {
    const auto path = find_library_file(name);
    if (!path)
        throw context.error("cannot find text file \"" + std::string(name) + "\"", "looked for in RAYPATH");
    return read_text_file(*path);
}

std::string line_of_words(std::span<const std::string_view> words) {
    std::string line;
    for (const std::string_view word : words) line.append(line.empty() ? "" : " ").append(word);
    return line;
}

Vec3 vector_at(std::span<const double> numbers, std::size_t first) {
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

}  // namespace

TextBlock::TextBlock(ModifierContext& context, std::size_t font, std::size_t spacing)
    : font_(shared_font(context, context.strings()[font])), origin_(vector_at(context.reals(), 0)) {
    const auto strings = context.strings();
    const auto numbers = context.reals();
    const Vec3 right = vector_at(numbers, 3), down = vector_at(numbers, 6);
    const Vec3 normal = cross(down, right);
    const double size2 = dot(normal, normal);
    constexpr double least = 1e-24;  // of size2 * |down|^2, RADIANCE's figure
    if (!(size2 * dot(down, down) > least))
        throw context.error("illegal motion vector", "the steps right and down must not be parallel or 0");
    across_ = cross(normal, down) / size2;
    down_ = cross(right, normal) / size2;

    double distance = 0, square = 1;
    if (numbers.size() > spacing) {
        distance = numbers[spacing];
        square = font_->mean_width() / double{character_size} + std::fabs(distance);
    }
    across_ *= square * character_size;

    const std::size_t text = font + 1;
    const std::string content = strings.size() == text + 1 ? lines_of_file(context, strings[text])
                                                           : line_of_words(strings.subspan(text + 1));
    const double room = (1 + std::fabs(distance)) * character_size;  // at most, of a character
    for (std::string_view rest = content; !rest.empty();) {
        const std::string_view line = take_line(rest);
        constexpr double longest = 1e9;  // keeps places within an int
        if (room * static_cast<double>(line.size() + 1) > longest)
            throw context.error("a line of text is too long", "or its spacing too large");
        lines_.emplace_back(line, *font_, static_cast<int>(distance * character_size));
    }
}

bool TextBlock::covers(const Tracer& tracer, const Interaction& at) const {
    Placement placement;
    const bool placed =
        at.placement != 0 && tracer.scene().geometry().modifier_placement(at.placement, placement);
    const Vec3 offset = (placed ? placement.point_inside(at.point) : at.point) - origin_;
    const double x = dot(offset, across_), y = dot(offset, down_);
    if (!(x >= 0 && y >= 0 && y < static_cast<double>(lines_.size()))) return false;
    const double row = std::floor(y);
    const TextLine& line = lines_[static_cast<std::size_t>(row)];
    return x < line.width() && line.covers(x, (row + 1 - y) * character_size);
}

}  // namespace infra
