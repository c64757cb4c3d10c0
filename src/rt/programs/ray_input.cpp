#include "rt/programs/ray_input.h"

#include <array>
#include <cctype>
#include <cmath>

#include "common/parse_number.h"

namespace infra {
namespace {

constexpr int numbers_a_ray = 6;
/// More characters than any number has: what is longer is cut off and refused.
constexpr std::size_t longest_word = 60;
constexpr const char* cut_short = "it ends within a ray";

/// The next word, "" at the end of input. Only one thread reads, so no character needs a lock.
std::string next_word(std::FILE* file) {
    int c;
    do {
        c = getc_unlocked(file);
    } while (std::isspace(c));
    std::string word;
    for (; c != EOF && !std::isspace(c) && word.size() < longest_word; c = getc_unlocked(file))
        word.push_back(static_cast<char>(c));
    return word;
}

}  // namespace

bool RayInput::read_text(double* values) {
    for (int i = 0; i < numbers_a_ray; ++i) {
        const std::string word = next_word(file_);
        if (word.empty() && i > 0) fault_ = cut_short;
        if (!word.empty() && !parse_real(word, values[i])) fault_ = "'" + word + "' is no number";
        if (word.empty() || !fault_.empty()) return false;
    }
    return true;
}

template <class Number>
bool RayInput::read_raw(double* values) {
    std::array<Number, numbers_a_ray> raw;
    const std::size_t bytes = std::fread(raw.data(), 1, sizeof raw, file_);
    if (bytes > 0 && bytes < sizeof raw) fault_ = cut_short;
    if (bytes < sizeof raw) return false;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        values[i] = static_cast<double>(raw[i]);
        if (!std::isfinite(raw[i])) fault_ = "it is not finite";
    }
    return fault_.empty();
}

bool RayInput::next(RayRequest& ray) {
    double values[numbers_a_ray];
    const bool complete = format_ == NumberFormat::floats    ? read_raw<float>(values)
                          : format_ == NumberFormat::doubles ? read_raw<double>(values)
                                                             : read_text(values);
    if (!complete) return false;
    ray.origin = {values[0], values[1], values[2]};
    ray.direction = {values[3], values[4], values[5]};
    ray.length = length(ray.direction);
    if (ray.length > 0) ray.direction /= ray.length;
    return true;
}

}  // namespace infra
