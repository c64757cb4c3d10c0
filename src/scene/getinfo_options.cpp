#include "scene/getinfo_options.h"

namespace infra {

OptionTable getinfo_option_table(GetinfoSettings& settings) {
    using Action = GetinfoSettings::Action;
    OptionTable options("getinfo", "[file ..|-]");
    options.describe(
        "Prints the header of each file, or of the standard input. \"-\" copies the standard input without "
        "it.");
    options.take_words_literally();
    options.custom(
        "-d", "", [&](const OptionValues&) { settings.dimensions = Dimensions::only; },
        "the dimensions of the picture, or the cube of the octree, in place of the header");
    options.custom(
        "+d", "", [&](const OptionValues&) { settings.dimensions = Dimensions::too; },
        "the dimensions behind the header");
    const auto take = [&](const char* spelling, const char* names, Action action, const char* help) {
        options
            .rest(
                spelling, 1,
                [&settings, action](const OptionValues& v) {
                    settings.action = action;
                    settings.words.assign(v.values.begin(), v.values.end());
                },
                help)
            .named(names);
    };
    take("-a", "line ..", Action::append, "copy the standard input with these lines added to its header");
    take("-r", "line ..", Action::replace,
         "the same, each in place of those that set the same; none of them for \"NAME=\"");
    take("-c", "command ..", Action::run,
         "copy the header with the command added, and give the data to the command");
    return options;
}

}  // namespace infra
