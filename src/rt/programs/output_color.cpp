#include "rt/programs/output_color.h"

#include <cmath>

#include "common/format.h"
#include "common/pictures/spectral_header.h"

namespace infra {
namespace {

using Kind = OutputColor::Kind;

/// An option without arguments that asks for one kind of output, listed while that is in force.
void add_kind_row(OptionTable& table, OutputColor& color, const char* spelling, Kind kind, const char* help) {
    table
        .custom(
            spelling, "", [&color, kind](const OptionValues&) { color.kind = kind; }, help)
        .shown([&color, kind, spelling] { return color.kind == kind ? std::string(spelling) : ""; });
}

std::string chromaticities(const Primaries& p) {
    return formatted("%.4f %.4f %.4f %.4f %.4f %.4f %.4f %.4f", p.red.x, p.red.y, p.green.x, p.green.y,
                     p.blue.x, p.blue.y, p.white.x, p.white.y);
}

bool nearly(const Primaries& a, const Primaries& b) {
    constexpr double tolerance = 0.001;  // primaries given this close to RADIANCE's mean those
    const auto near = [](const Chromaticity& c, const Chromaticity& d) {
        return std::abs(c.x - d.x) <= tolerance && std::abs(c.y - d.y) <= tolerance;
    };
    return near(a.red, b.red) && near(a.green, b.green) && near(a.blue, b.blue) && near(a.white, b.white);
}

void set_primaries(OutputColor& color, const OptionValues& given) {
    const auto pair = [&](std::size_t i) { return Chromaticity{given.real(i), given.real(i + 1)}; };
    const Primaries primaries = {pair(0), pair(2), pair(4), pair(6)};
    if (!usable(primaries))
        given.reject("illegal primary chromaticities",
                     "x and y of red, green, blue and white, which must differ and span colors");
    color.primaries = primaries;
    color.kind = nearly(primaries, radiance_primaries()) ? Kind::rgb : Kind::primaries;
}

}  // namespace

void add_primaries_rows(OptionTable& table, OutputColor& color) {
    add_kind_row(table, color, "-pRGB", Kind::rgb, "standard RGB color output");
    add_kind_row(table, color, "-pXYZ", Kind::xyz, "CIE XYZ color output");
    table
        .custom(
            "-pc", "ffffffff", [&color](const OptionValues& given) { set_primaries(color, given); },
            "output color primaries and white point")
        .named("xr yr xg yg xb yb xw yw")
        .shown([&color] {
            return color.kind == Kind::primaries ? "-pc " + chromaticities(color.primaries) : "";
        });
}

void add_response_rows(OptionTable& table, OutputColor& color) {
    add_kind_row(table, color, "-pY", Kind::photopic, "photopic output");
    add_kind_row(table, color, "-pS", Kind::scotopic, "scotopic output");
    add_kind_row(table, color, "-pM", Kind::melanopic, "melanopic output");
    add_kind_row(table, color, "-pA", Kind::average, "radiometric average output");
}

OptionRow& add_spectrum_row(OptionTable& table, OutputColor& color, const int& channel_count) {
    OptionRow& row = table.custom(
        "-co", "",
        [&color](const OptionValues& given) {
            const bool was_on = color.kind == Kind::spectrum;
            const bool on = given.attached.empty() ? !was_on : given.attached == "+" || given.attached == "1";
            if (on != was_on) color.kind = on ? Kind::spectrum : Kind::rgb;
        },
        "output spectral values");
    row.form = OptionRow::Form::toggle;
    row.shown([&color, &channel_count] {
        if (color.is_single() || channel_count <= Channels::fewest) return "";
        return color.kind == Kind::spectrum ? "-co+" : "-co-";
    });
    return row.remark([&color] {
        return color.kind == Kind::spectrum ? "output spectral values" : "output tristimulus colors";
    });
}

OutputColor for_channels(OutputColor color, const Channels& channels) {
    if (color.kind == Kind::spectrum && channels.is_rgb()) color.kind = Kind::rgb;
    return color;
}

std::string color_warning(const OutputColor& color, const Channels& channels) {
    if (channels.is_rgb() || channels.shows_colors()) return {};
    const std::string text = "spectral range incompatible with color output: ";
    switch (color.kind) {
        case Kind::spectrum:
        case Kind::average:
            return {};
        case Kind::rgb:
        case Kind::primaries:
            return text + "red, green and blue are the means of its thirds, longest wavelengths first";
        default:
            return text + "only what the eye sees of it is counted";
    }
}

const char* pixel_format(const OutputColor& color) {
    switch (color.kind) {
        case Kind::spectrum:
            return "Radiance_spectra";
        case Kind::xyz:
            return "32-bit_rle_xyze";
        default:
            return "32-bit_rle_rgbe";
    }
}

std::vector<std::string> color_header_lines(const OutputColor& color, const Channels& channels) {
    switch (color.kind) {
        case Kind::spectrum:
            return {wavelength_splits_line(channels)};
        case Kind::xyz:
            return {"PRIMARIES= " + chromaticities({{1, 0}, {0, 1}, {0, 0}, {1. / 3, 1. / 3}})};
        case Kind::primaries:
            return {"PRIMARIES= " + chromaticities(color.primaries)};
        default:
            return {};
    }
}

}  // namespace infra
