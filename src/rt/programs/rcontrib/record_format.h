// How the values of a record are written, and read again.
#pragma once

#include <cstdio>
#include <span>
#include <string>

#include "rt/programs/rcontrib/output_plan.h"

namespace infra {

class RecordFormat {
  public:
    RecordFormat(NumberFormat format, int channels) : format_(format), channels_(channels) {}

    int channels() const { return channels_; }
    /// Appends a target's part of a record; text ends with a line.
    ///   sums   of the whole record, a number a channel
    ///   scale  factor on them
    void append(const OutputTarget& target, std::span<const double> sums, double scale,
                std::string& out) const;
    /// Bytes a spectrum takes; 0 for text, which has no fixed size.
    std::size_t spectrum_bytes() const;
    /// Reads one spectrum. False where there is none any more.
    bool read(std::FILE* file, std::span<double> spectrum) const;

  private:
    void append_spectrum(const double* sums, double scale, std::string& out) const;

    NumberFormat format_;
    int channels_;
};

}  // namespace infra
