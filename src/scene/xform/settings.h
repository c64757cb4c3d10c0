// One application of xform: the options in front, the transform, the files.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/transform.h"

namespace infra::xform {

struct Settings {
    std::vector<std::string> words;   ///< the command line, program name first, that amounts to all below
    std::size_t transform_begin = 1;  ///< the transform is words[transform_begin .. transform_end)
    std::size_t transform_end = 1;    ///< and the files are the rest

    Transform transform;
    std::string prefix;        ///< -n: put before the names of surfaces, with a dot
    std::string new_modifier;  ///< -m: modifier of all surfaces; "" keeps theirs
    bool invert = false;       ///< -I
    bool expand = true;        ///< run commands; not with -c

    std::span<const std::string> transform_words() const {
        return std::span(words).subspan(transform_begin, transform_end - transform_begin);
    }
    std::span<const std::string> files() const { return std::span(words).subspan(transform_end); }
};

/// Reads a command line without -a and -f.
///   throws  Error "command line error at '-zz'" for what is neither an option, a transform nor a file
Settings parse_settings(std::vector<std::string> words);

}  // namespace infra::xform
