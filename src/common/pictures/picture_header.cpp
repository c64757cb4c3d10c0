// Variables of a picture's information header.
#include <algorithm>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

/// What follows "NAME=" in a line of that name.
std::optional<std::string_view> variable_text(std::string_view line, std::string_view name) {
    if (!line.starts_with(name) || line.substr(name.size(), 1) != "=") return std::nullopt;
    line.remove_prefix(name.size() + 1);
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return std::string_view();
    return line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
}

/// The numbers in a text, as far as they are numbers.
std::vector<double> numbers_in(std::string_view text) {
    std::vector<double> numbers;
    for (const std::string& word : split_words(text)) {
        double number = 0;
        if (!parse_real(word, number)) break;
        numbers.push_back(number);
    }
    return numbers;
}

/// Products, component by component, of all lines of a name with N positive numbers; 1 without such lines.
template <std::size_t N>
std::array<double, N> product(const std::vector<std::string>& lines, std::string_view name) {
    std::array<double, N> total;
    total.fill(1);
    for (const std::string& line : lines) {
        const auto text = variable_text(line, name);
        if (!text) continue;
        const std::vector<double> numbers = numbers_in(*text);
        if (numbers.size() < N || std::ranges::any_of(numbers, [](double x) { return x <= 0; })) continue;
        for (std::size_t i = 0; i < N; ++i) total[i] *= numbers[i];
    }
    return total;
}

}  // namespace

std::optional<std::string> PictureHeader::value(std::string_view name) const {
    for (auto line = lines.rbegin(); line != lines.rend(); ++line)
        if (const auto text = variable_text(*line, name)) return std::string(*text);
    return std::nullopt;
}

double PictureHeader::exposure() const { return product<1>(lines, "EXPOSURE")[0]; }
double PictureHeader::pixel_aspect() const { return product<1>(lines, "PIXASPECT")[0]; }
std::array<double, 3> PictureHeader::color_correction() const { return product<3>(lines, "COLORCORR"); }

std::optional<std::array<double, 8>> PictureHeader::primaries() const {
    const std::vector<double> numbers = numbers_in(value("PRIMARIES").value_or(""));
    if (numbers.size() != 8) return std::nullopt;
    std::array<double, 8> chromaticities;
    std::ranges::copy(numbers, chromaticities.begin());
    return chromaticities;
}

std::optional<View> PictureHeader::view() const {
    View found;
    int count = 0;
    for (const std::string& line : lines)
        if (is_view_line(line)) count += parse_view(line, found);
    if (count == 0) return std::nullopt;
    try {
        set_up_view(found);
    } catch (const Error&) {
        return std::nullopt;
    }
    return found;
}

void undo_exposure(Picture& picture) {
    const double exposure = picture.header.exposure();
    const std::array<double, 3> correction = picture.header.color_correction();
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const double channel_factor = picture.channels == 3 ? correction[i % 3] : 1;
        picture.pixels[i] = static_cast<float>(picture.pixels[i] / (exposure * channel_factor));
    }
    std::erase_if(picture.header.lines, [](const std::string& line) {
        return variable_text(line, "EXPOSURE") || variable_text(line, "COLORCORR");
    });
}

}  // namespace infra
