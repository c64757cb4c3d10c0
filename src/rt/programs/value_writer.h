// Values on rtrace's output, as text or raw numbers.
#pragma once

#include <string>
#include <string_view>

#include "common/spectrum.h"
#include "common/vec.h"

namespace infra {

/// How numbers are written and read; the letter of -f.
enum class NumberFormat : char { text = 'a', floats = 'f', doubles = 'd', color = 'c' };

/// Name of a format in a FORMAT= line: "ascii", "float", "double", "32-bit_rle_rgbe".
const char* format_name(NumberFormat format);

/// Appends values to a string. Text is "%e" and a tab for each; raw numbers are in the machine's byte order.
class ValueWriter {
  public:
    ValueWriter(NumberFormat format, std::string& out) : format_(format), out_(out) {}

    void real(double value);
    void vector(const Vec3& value);
    /// One number a channel, or one RGBE pixel.
    void spectrum(const Spectrum& value);
    /// A name and a tab, in any format.
    void name(std::string_view value);
    /// Ends the line of a ray; text only.
    void end_of_ray();
    /// Tabs before a ray of a tree, as many as its depth.
    void indent(int depth) { out_.append(static_cast<std::size_t>(depth), '\t'); }

  private:
    NumberFormat format_;
    std::string& out_;
};

}  // namespace infra
