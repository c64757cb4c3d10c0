#include "ir/genirsky/uvspec_azimuths.h"

#include <algorithm>
#include <cmath>

#include "common/format.h"

namespace infra::ir {
namespace {

constexpr double written_digits = 1e-5;  // uvspec computes and writes in single precision

bool same_direction(double phi, double other) { return std::remainder(phi - other, 360) == 0; }

}  // namespace

UvspecAzimuths::UvspecAzimuths(const std::vector<double>& phi) {
    if (phi.empty()) {
        directions_.push_back(std::nullopt);
        column_of_.push_back(0);
    }
    for (const double angle : phi) {
        const auto before = std::ranges::find_if(
            directions_, [&](const std::optional<double>& other) { return same_direction(angle, *other); });
        column_of_.push_back(static_cast<std::size_t>(before - directions_.begin()));
        if (before == directions_.end()) directions_.push_back(angle);
    }
}

std::vector<PlacedNumber> UvspecAzimuths::distinct(std::span<const PlacedNumber> numbers,
                                                   const NumberText& text) const {
    std::vector<PlacedNumber> result;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::size_t column = column_of_[i];
        if (column == result.size()) {
            result.push_back(numbers[i]);
            continue;
        }
        const double first = result[column].value, again = numbers[i].value;
        if (std::abs(again - first) > written_digits * std::abs(first))
            throw Error(text.place(numbers[i]),
                        formatted("the radiance %g is not that of phi %g in the same direction, %g", again,
                                  *directions_[column], first));
    }
    return result;
}

}  // namespace infra::ir
