// Scene text as xform writes it.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include "scene/rad_parser.h"

namespace infra::xform {

/// Text is held back until it is known to be good, at least up to 64 MiB of it: a bad scene gives no output.
class Output {
  public:
    explicit Output(std::FILE* file) : file_(file) {}

    void text(std::string_view text);
    void primitive(const ParsedPrimitive& primitive);
    /// Writes what is held back. throws Error when the device is full.
    void finish();

  private:
    void reals(const ParsedPrimitive& primitive);

    std::FILE* file_;
    std::string buffer_;
};

}  // namespace infra::xform
