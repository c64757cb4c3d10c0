#include "ir/genirsky/dome_file.h"

#include <algorithm>

#include "common/error.h"
#include "common/format.h"

namespace infra::ir {
namespace {

constexpr double ice_point = 273.15;  // K

bool is_pairs(const NumberText& text) {
    return text.lines.size() > 1 &&
           std::ranges::all_of(text.lines, [](const NumberLine& line) { return line.size() == 2; });
}

/// throws Error for a number of values that is not `expected`, at the first too many or the text's end.
void check_count(const std::vector<PlacedNumber>& numbers, std::size_t expected, const NumberText& text,
                 std::string_view hint) {
    if (numbers.size() == expected) return;
    const Location place = numbers.size() > expected ? text.place(numbers[expected]) : text.end();
    throw Error(place, formatted("found %zu values where there should be %zu", numbers.size(), expected),
                hint);
}

Dome from_pairs(const NumberText& text, const ValueReader& reader) {
    std::vector<AngleSample> samples;
    for (const NumberLine& line : text.lines) {
        const double angle = line[0].value;
        if (!(angle >= 0 && angle <= 90))
            throw Error(text.place(line[0]), formatted("angle %g deg is not within 0..90", angle));
        if (!samples.empty() && angle <= samples.back().angle_deg)
            throw Error(text.place(line[0]), formatted("angle %g deg does not come after %g deg", angle,
                                                       samples.back().angle_deg));
        samples.push_back({angle, reader.radiance(line[1], text)});
    }
    return {at_rows(samples)};
}

Dome from_ten(const std::vector<PlacedNumber>& numbers, const NumberText& text, const ValueReader& reader,
              bool from_horizon) {
    Dome dome;
    for (const PlacedNumber& number : numbers) dome.values.push_back(reader.radiance(number, text));
    if (from_horizon) std::ranges::reverse(dome.values);
    return dome;
}

}  // namespace

double ValueReader::radiance(const PlacedNumber& number, const NumberText& text) const {
    if (unit_ == ValueUnit::radiance) {
        if (number.value < 0)
            throw Error(text.place(number), formatted("negative radiance %g", number.value));
        return number.value;
    }
    const bool celsius = unit_ == ValueUnit::celsius;
    const double kelvin = number.value + (celsius ? ice_point : 0);
    const std::string as_written = formatted("temperature %g %s", number.value, celsius ? "degrees C" : "K");
    if (!(kelvin > 0))
        throw Error(text.place(number),
                    as_written + (celsius ? " is not above -273.15 degrees C" : " is not above 0 K"));
    if (const std::string odd = oddity(kelvin); odd_ && !odd.empty()) {
        const bool cold = kelvin < ice_point;
        const std::string_view slip =
            celsius ? (cold ? "" : "kelvin, -K?") : (cold ? "degrees Celsius, -C?" : "");
        odd_->push_back(Error(text.place(number), as_written + " is " + odd, slip).what());
    }
    return passband_->scale().at(kelvin).radiance;
}

std::string oddity(double kelvin) {
    constexpr double coldest = 100, hottest = 400;
    if (kelvin < coldest) return formatted("below %g K", coldest);
    return kelvin > hottest ? formatted("above %g K", hottest) : "";
}

Dome parse_elevations(const NumberText& text, const ValueReader& reader, bool from_horizon) {
    if (is_pairs(text)) {
        if (from_horizon)
            throw Error(text.place(text.lines[0][0]),
                        "lines of an angle and a value have their order already");
        return from_pairs(text, reader);
    }
    const std::vector<PlacedNumber> numbers = text.all();
    check_count(numbers, Dome::rows, text,
                "for angles 0, 10 .. 90 deg from the pole; or lines of an angle and a value");
    return from_ten(numbers, text, reader, from_horizon);
}

Dome parse_dome_table(const NumberText& text, const ValueReader& reader) {
    constexpr std::size_t open = (Dome::columns - 1) * Dome::rows;
    const std::vector<PlacedNumber> numbers = text.all();
    if (numbers.size() != open)
        check_count(numbers, open + Dome::rows, text,
                    "ten from pole to horizon for each azimuth 0, 18 .. 360 deg; 200 without the last");
    Dome dome;
    for (const PlacedNumber& number : numbers) dome.values.push_back(reader.radiance(number, text));
    for (std::size_t row = 0; row < Dome::rows; ++row) {
        if (numbers.size() == open) {
            dome.values.push_back(dome.values[row]);
        } else if (dome.values[open + row] != dome.values[row]) {
            throw Error(text.place(numbers[open + row]),
                        formatted("azimuth 360 deg has not azimuth 0's value at %g deg from the pole",
                                  Dome::angle_deg(row)),
                        "the last ten values repeat the first, or are left out");
        }
    }
    return dome;
}

Dome parse_thrend(const NumberText& text, const ValueReader& reader, bool from_horizon) {
    if (text.lines.size() > 1)
        throw Error(text.place(text.lines[1][0]), "ThRend's sky has one line of ten values");
    check_count(text.lines[0], Dome::rows, text, "ThRend's sky has one line of ten values");
    return from_ten(text.lines[0], text, reader, from_horizon);
}

}  // namespace infra::ir
