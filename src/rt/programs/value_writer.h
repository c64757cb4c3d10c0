// Values on rtrace's output, as text or raw numbers.
#pragma once

#include <string>
#include <string_view>

#include "common/spectra/spectrum.h"
#include "common/vec.h"
#include "rt/programs/value_converter.h"

namespace infra {

/// How numbers are written and read; the letter of -f.
enum class NumberFormat : char { text = 'a', floats = 'f', doubles = 'd', color = 'c' };

/// Name of a format in a FORMAT= line: "ascii", "float", "double", or that of pixels of a color.
const char* format_name(NumberFormat format, const OutputColor& color);

/// Appends a number: as text "%e" and a tab, else raw in the machine's byte order. Not for colors.
void append_real(NumberFormat format, double value, std::string& out);

/// Appends values to a string. Text is "%e" and a tab for each; raw numbers are in the machine's byte order.
class ValueWriter {
  public:
    /// converter: outlives this.
    ValueWriter(NumberFormat format, const ValueConverter& converter, std::string& out)
        : format_(format),
          converter_(converter),
          plain_(converter.keeps_channels() && format != NumberFormat::color),
          out_(out) {}

    void real(double value) { append_real(format_, value, out_); }
    void vector(const Vec3& value);
    /// What the converter makes of a radiance, or of a share of it: numbers, or one pixel.
    void radiance(const Spectrum& value) {
        if (plain_) return channels(value);
        numbers(converter_.radiance(value));
    }
    void share(const Spectrum& value) {
        if (plain_) return channels(value);
        numbers(converter_.share(value));
    }
    /// A name and a tab, in any format.
    void name(std::string_view value);
    /// Ends the line of a ray; text only.
    void end_of_ray();
    /// Tabs before a ray of a tree, as many as its depth.
    void indent(int depth) { out_.append(static_cast<std::size_t>(depth), '\t'); }

  private:
    void channels(const Spectrum& value);
    void numbers(const ValueConverter::Numbers& numbers);

    NumberFormat format_;
    const ValueConverter& converter_;
    bool plain_;  ///< the numbers are the channels
    std::string& out_;
};

}  // namespace infra
