#include "scene/xform/settings.h"

#include "common/error.h"

namespace infra::xform {

Settings parse_settings(std::vector<std::string> words) {
    Settings settings;
    std::size_t i = 1;
    for (; i < words.size(); ++i) {
        const std::string& word = words[i];
        const bool has_value = i + 1 < words.size();
        if (word == "-m" && has_value) {
            ++i;
            if (settings.new_modifier.empty()) settings.new_modifier = words[i];
        } else if (word == "-n" && has_value) {
            ++i;
            if (!settings.prefix.empty()) settings.prefix += '.';
            settings.prefix += words[i];
        } else if (word == "-c" || word == "-e") {
            settings.expand = word == "-e";
        } else if (word == "-I") {
            settings.invert = !settings.invert;
        } else {
            break;
        }
    }
    settings.transform_begin = i;
    settings.transform_end = i + parse_transform(std::span(words).subspan(i), settings.transform);
    if (settings.transform_end < words.size() && words[settings.transform_end].starts_with('-')) {
        const std::string& word = words[settings.transform_end];
        throw Error("command line error at '" + word + "'",
                    is_transform_option(word) ? "its numbers are missing or no numbers"
                                              : "first -c -e -I -m -n, then the transform, then the files");
    }
    settings.words = std::move(words);
    return settings;
}

}  // namespace infra::xform
