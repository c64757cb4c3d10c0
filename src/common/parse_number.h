// Strict numbers: the whole text must be one number, so that "3x" or "nan" in a file is an error and not a 3.
#pragma once

#include <string_view>

namespace infra {

/// Reads a decimal number as RADIANCE writes them: "3", "+3", "-.5", "5.", "1e-1", "1.5E+3".
/// Refuses surrounding blanks, hexadecimal, "inf", "nan", an exponent without digits and values beyond
/// double. Returns whether `text` was a number; `value` changes only then. Values too small for a double
/// become 0.
bool parse_real(std::string_view text, double& value);

/// Reads a decimal integer with an optional sign; refuses what does not fit.
bool parse_int(std::string_view text, int& value);
bool parse_int(std::string_view text, long long& value);

}  // namespace infra
