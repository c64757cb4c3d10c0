#include "rt/programs/rcontrib/record_format.h"

#include <array>
#include <cstdint>
#include <cstring>

#include "common/pictures/rgbe.h"

namespace infra {

void RecordFormat::append(const OutputTarget& target, std::span<const double> sums, double scale,
                          std::string& out) const {
    const auto step = static_cast<std::size_t>(channels_);
    for (const OutputTarget::Range& range : target.ranges)
        for (std::size_t i = 0; i < range.count; ++i)
            append_spectrum(&sums[(range.first + i) * step], scale, out);
    if (format_ == NumberFormat::text) out.push_back('\n');
}

void RecordFormat::append_spectrum(const double* sums, double scale, std::string& out) const {
    const auto count = static_cast<std::size_t>(channels_);
    if (format_ == NumberFormat::color) {
        std::array<float, Channels::most> values;
        std::array<std::uint8_t, Channels::most + 1> pixel;
        for (std::size_t c = 0; c < count; ++c) values[c] = static_cast<float>(sums[c] * scale);
        to_common_exponent(std::span(values).first(count), std::span(pixel).first(count + 1));
        out.append(reinterpret_cast<const char*>(pixel.data()), count + 1);
        return;
    }
    for (std::size_t c = 0; c < count; ++c) append_real(format_, sums[c] * scale, out);
}

std::size_t RecordFormat::spectrum_bytes() const {
    const auto count = static_cast<std::size_t>(channels_);
    switch (format_) {
        case NumberFormat::floats:
            return count * sizeof(float);
        case NumberFormat::doubles:
            return count * sizeof(double);
        case NumberFormat::color:
            return count + 1;
        case NumberFormat::text:
            break;
    }
    return 0;
}

bool RecordFormat::read(std::FILE* file, std::span<double> spectrum) const {
    if (format_ == NumberFormat::text) {
        for (double& value : spectrum)
            if (std::fscanf(file, "%lf", &value) != 1) return false;
        return true;
    }
    std::array<char, Channels::most * sizeof(double)> bytes;
    if (std::fread(bytes.data(), 1, spectrum_bytes(), file) != spectrum_bytes()) return false;
    const auto* const pixel = reinterpret_cast<const std::uint8_t*>(bytes.data());
    for (std::size_t c = 0; c < spectrum.size(); ++c) {
        if (format_ == NumberFormat::color) {
            spectrum[c] = double(rgbe_factor(pixel[spectrum.size()])) * (pixel[c] + 0.5);
        } else if (format_ == NumberFormat::floats) {
            float value;
            std::memcpy(&value, &bytes[c * sizeof value], sizeof value);
            spectrum[c] = double(value);
        } else {
            std::memcpy(&spectrum[c], &bytes[c * sizeof(double)], sizeof(double));
        }
    }
    return true;
}

}  // namespace infra
