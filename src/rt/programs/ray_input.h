// Rays on rtrace's standard input: origin and direction, six numbers each.
#pragma once

#include <cstdio>
#include <string>

#include "common/vec.h"
#include "rt/programs/value_writer.h"

namespace infra {

struct RayRequest {
    Vec3 origin{0};
    Vec3 direction{0};  ///< unit length, or 0 0 0: a record of nothing, and the output is flushed
    double length = 0;  ///< of the direction as given
};

class RayInput {
  public:
    /// format: text, floats or doubles. Raw numbers are in the machine's byte order.
    RayInput(std::FILE* file, NumberFormat format) : file_(file), format_(format) {}

    /// Reads the next ray. False at the end of input, and where something is no ray.
    bool next(RayRequest& ray);
    /// What was wrong if the input ended badly: "'x' is no number"; otherwise "".
    const std::string& fault() const { return fault_; }

  private:
    bool read_text(double* values);
    template <class Number>
    bool read_raw(double* values);

    std::FILE* file_;
    NumberFormat format_;
    std::string fault_;
};

}  // namespace infra
