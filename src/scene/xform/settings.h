// One application of xform: the options in front, the transform, the files.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/options.h"
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

/// All options of xform. The first of the transform's takes the rest of the command line. -a and -f are
/// carried out before (repetition.h) and refused here. The table refers to `settings`, which must outlive it.
OptionTable option_table(Settings& settings);

/// Reads a command line without -a and -f.
///   returns  nothing if -help or -version was answered
///   throws   Error "command line error at '-zz'" for what is neither an option, a transform nor a file
std::optional<Settings> parse_settings(std::vector<std::string> words);

}  // namespace infra::xform
