#include "rt/programs/value_converter.h"

#include <type_traits>

namespace infra {
namespace {

using Kind = OutputColor::Kind;

/// Lumens a watt of equal-energy white from 380 to 780 nm, RADIANCE's figures.
constexpr float white_efficacy = 179, white_scotopic = 412, white_melanopic = 179;

float efficacy(Kind kind) {
    switch (kind) {
        case Kind::xyz:
        case Kind::photopic:
            return white_efficacy;
        case Kind::scotopic:
            return white_scotopic;
        case Kind::melanopic:
            return white_melanopic;
        default:
            return 1;
    }
}

}  // namespace

ValueConverter::ValueConverter(const OutputColor& wanted, const Channels& channels) {
    const Kind kind = for_channels(wanted, channels).kind;
    efficacy_ = efficacy(kind);
    components_ = wanted.is_single() ? 1 : kind == Kind::spectrum ? channels.count() : 3;
    switch (kind) {
        case Kind::rgb:
            if (!channels.is_rgb()) conversion_ = ColorConverter::rgb(channels);
            break;
        case Kind::xyz:
            conversion_ = ColorConverter::xyz(channels);
            break;
        case Kind::primaries:
            conversion_ = ColorConverter::rgb(channels, wanted.primaries);
            break;
        case Kind::photopic:
            conversion_ = Response(channels, EyeResponse::y);
            break;
        case Kind::scotopic:
            conversion_ = Response(channels, EyeResponse::scotopic);
            break;
        case Kind::melanopic:
            conversion_ = Response(channels, EyeResponse::melanopic);
            break;
        case Kind::average:
            conversion_ = Mean();
            break;
        case Kind::spectrum:
            break;
    }
}

ValueConverter::Numbers ValueConverter::share(const Spectrum& value) const {
    Numbers numbers;
    numbers.count = components_;
    const auto convert = [&](const auto& conversion) {
        using Conversion = std::decay_t<decltype(conversion)>;
        if constexpr (std::is_same_v<Conversion, Kept>) {
            for (int c = 0; c < components_; ++c) numbers.values[static_cast<std::size_t>(c)] = value[c];
        } else if constexpr (std::is_same_v<Conversion, Mean>) {
            numbers.values[0] = value.mean();
        } else if constexpr (std::is_same_v<Conversion, Response>) {
            numbers.values[0] = static_cast<float>(conversion(value));
        } else {
            const Color color = conversion(value);
            for (std::size_t c = 0; c < color.size(); ++c) numbers.values[c] = color[c];
        }
    };
    std::visit(convert, conversion_);
    return numbers;
}

ValueConverter::Numbers ValueConverter::radiance(const Spectrum& value) const {
    Numbers numbers = share(value);
    for (std::size_t c = 0; c < static_cast<std::size_t>(numbers.count); ++c) numbers.values[c] *= efficacy_;
    return numbers;
}

}  // namespace infra
