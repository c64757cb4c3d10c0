// Numbers in machine form, in either byte order.
#pragma once

#include <array>
#include <cstddef>

#include "settings.h"

namespace infra::rcalc {

/// Bytes that a number takes: 4 or 8.
std::size_t number_size(NumberForm form);

double decode_number(const char* bytes, NumberForm form);

/// The first number_size(form) bytes of the result are the number.
std::array<char, 8> encode_number(double value, NumberForm form);

}  // namespace infra::rcalc
