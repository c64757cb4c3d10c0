#include "scene/xform/settings.h"

#include "common/error.h"

namespace infra::xform {
namespace {

/// The transform begins with `given`; the files follow it.
void take_transform(Settings& settings, const OptionValues& given) {
    std::vector<std::string> words = {std::string(given.option)};
    words.insert(words.end(), given.values.begin(), given.values.end());
    const std::size_t read = parse_transform(words, settings.transform);
    settings.transform_begin = settings.words.size() - words.size();
    settings.transform_end = settings.transform_begin + read;
    if (read == words.size() || !words[read].starts_with('-')) return;
    const std::string& word = words[read];
    throw Error("command line error at '" + word + "'",
                is_transform_option(word) ? "its numbers are missing or no numbers"
                                          : "first -c -e -I -m -n, then the transform, then the files");
}

void add_transform_rows(OptionTable& options, Settings& settings) {
    struct Row {
        const char *spelling, *arguments, *help;
    };
    for (const Row& row : {Row{"-t", "x y z", "move along this vector"},
                           {"-rx", "degrees", "turn about the x axis"},
                           {"-ry", "degrees", "turn about the y axis"},
                           {"-rz", "degrees", "turn about the z axis"},
                           {"-s", "factor", "scale"},
                           {"-mx", "", "mirror in the yz plane"},
                           {"-my", "", "mirror in the xz plane"},
                           {"-mz", "", "mirror in the xy plane"},
                           {"-i", "count", "repeat what follows, up to the next -i"}})
        options
            .rest(
                row.spelling, 0, [&settings](const OptionValues& given) { take_transform(settings, given); },
                row.help)
            .named(row.arguments);
    const auto refuse = [](const OptionValues& given) { given.reject("cannot stand here"); };
    options.custom("-a", "i", refuse, "repeat what follows, up to the next -a or -i, 0, 1 .. n-1 times")
        .named("n");
    options.custom("-f", "s", refuse, "put each line of a file in place of this option")
        .named("file")
        .differing(
            "a quote ends where it is closed, so that words may follow a quoted one; scene and lines may "
            "both "
            "come from the standard input");
}

}  // namespace

OptionTable option_table(Settings& settings) {
    OptionTable options("xform", "[transform] [file ..]");
    options.take_words_literally();
    options.custom(
        "-c", "", [&](const OptionValues&) { settings.expand = false; },
        "pass commands on, with the transform added");
    options.custom(
        "-e", "", [&](const OptionValues&) { settings.expand = true; },
        "run commands and transform what they write");
    options.custom(
        "-I", "", [&](const OptionValues&) { settings.invert = !settings.invert; },
        "turn surfaces inside out");
    options
        .custom(
            "-m", "s",
            [&](const OptionValues& given) {
                if (settings.new_modifier.empty()) settings.new_modifier = given.text(0);
            },
            "modifier of all surfaces")
        .named("modifier");
    options
        .custom(
            "-n", "s",
            [&](const OptionValues& given) {
                if (!settings.prefix.empty()) settings.prefix += '.';
                settings.prefix += given.text(0);
            },
            "prefix of all names of surfaces")
        .named("name")
        .differing("names in a mist that hold blanks or quotes stay quoted");
    add_transform_rows(options, settings);
    return options;
}

std::optional<Settings> parse_settings(std::vector<std::string> words) {
    Settings settings;
    settings.words = std::move(words);
    settings.transform_begin = 0;
    OptionTable options = option_table(settings);
    const auto files = options.parse({settings.words.begin() + 1, settings.words.end()});
    if (!files) return std::nullopt;
    if (settings.transform_begin == 0)
        settings.transform_begin = settings.transform_end = settings.words.size() - files->size();
    return settings;
}

}  // namespace infra::xform
