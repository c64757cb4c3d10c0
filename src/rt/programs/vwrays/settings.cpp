#include "rt/programs/vwrays/settings.h"

#include <algorithm>

#include "common/error.h"
#include "common/pictures/picture_layout.h"
#include "common/views/view_options.h"

namespace infra {
namespace {

/// The view and the order of pixels of a picture that was rendered.
void take_picture(const std::string& path, VwraysSettings& settings) {
    const PictureLayout layout = read_picture_layout(path);
    const auto view = layout.header.view();
    if (!view) throw Error(Location{path}, "no view in picture", "its header has no legal VIEW= line");
    settings.view = *view;
    settings.order = layout.order;
}

}  // namespace

OptionTable vwrays_option_table(VwraysSettings& settings) {
    OptionTable table("vwrays", "[picture [distances]]");
    table.describe(
        "Writes the origin and direction of the ray through each pixel of a view, or of a picture. With a "
        "file\n"
        "of the pixels' distances (rpict -z): the points that they show, and the directions from there.");
    table.attached(
        "-f", "",
        [&settings](const OptionValues& given) {
            if (given.attached.size() != 1 ||
                std::string_view("afd").find(given.attached) == std::string_view::npos)
                given.reject("unknown format", "a text, f float, d double, as in -ff");
            settings.format = static_cast<NumberFormat>(given.attached[0]);
        },
        "format: a text, f float, d double");
    add_view_options(table, settings.view);  // after -f: "-vf" is its own
    table.integer("-x", &settings.order.width, "x resolution").at_least(1);
    table.integer("-y", &settings.order.height, "y resolution").at_least(1);
    table.real("-pa", &settings.pixel_aspect, "pixel aspect ratio").at_least(0);
    table.real("-pj", &settings.pixel_jitter, "pixel jitter");
    table.real("-pd", &settings.lens_diameter, "pixel depth-of-field")
        .at_least(0)
        .differing(
            "in a parallel view the lens moves along with the ray, where RADIANCE's rays all go to one "
            "point");
    table.integer("-c", &settings.repeats, "rays a pixel");
    table.custom(
        "-i", "", [&settings](const OptionValues&) { settings.pixels_from_input = true; },
        "pixel positions x y from the standard input, from the lower left corner");
    table.custom(
        "-u", "", [&settings](const OptionValues&) { settings.unbuffered = true; }, "write each ray at once");
    table.custom(
        "-d", "", [&settings](const OptionValues&) { settings.only_dimensions = true; },
        "write only the options of rtrace for the size");
    return table;
}

std::optional<VwraysSettings> read_vwrays_settings(int argc, char** argv) {
    VwraysSettings settings;
    const auto operands = vwrays_option_table(settings).parse(argc, argv);
    if (!operands) return std::nullopt;
    if (operands->size() > 2)
        throw Error("command line error at '" + (*operands)[2] + "': a picture and its distances at most");
    settings.repeats = std::max(settings.repeats, 1);
    if (!operands->empty()) take_picture(operands->front(), settings);
    set_up_view(settings.view);
    if (operands->empty())
        fit_resolution(view_aspect(settings.view), settings.pixel_aspect, settings.order.width,
                       settings.order.height);
    else if (operands->size() > 1)
        settings.depth_file = (*operands)[1];
    return settings;
}

}  // namespace infra
