#include "binary.h"

#include <algorithm>
#include <cstring>

namespace infra::rcalc {
namespace {

bool is_swapped(NumberForm form) {
    return form == NumberForm::float32_swapped || form == NumberForm::float64_swapped;
}

}  // namespace

std::size_t number_size(NumberForm form) {
    return form == NumberForm::float32 || form == NumberForm::float32_swapped ? 4 : 8;
}

double decode_number(const char* bytes, NumberForm form) {
    std::array<char, 8> ordered{};
    const std::size_t size = number_size(form);
    std::copy_n(bytes, size, ordered.begin());
    if (is_swapped(form)) std::reverse(ordered.begin(), ordered.begin() + static_cast<std::ptrdiff_t>(size));
    if (size == sizeof(float)) {
        float value;
        std::memcpy(&value, ordered.data(), size);
        return value;
    }
    double value;
    std::memcpy(&value, ordered.data(), size);
    return value;
}

std::array<char, 8> encode_number(double value, NumberForm form) {
    std::array<char, 8> bytes{};
    const std::size_t size = number_size(form);
    if (size == sizeof(float)) {
        const auto single = static_cast<float>(value);
        std::memcpy(bytes.data(), &single, size);
    } else {
        std::memcpy(bytes.data(), &value, size);
    }
    if (is_swapped(form)) std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    return bytes;
}

}  // namespace infra::rcalc
