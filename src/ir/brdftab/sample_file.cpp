#include "ir/brdftab/sample_file.h"

#include <array>
#include <optional>

#include "common/error.h"
#include "ir/brdftab/sample_text.h"

namespace infra::ir {
namespace {

/// Columns of a sample file and where they stand.
struct Columns {
    static constexpr std::array<std::string_view, 6> names{"theta_i", "phi_i", "theta_r",
                                                           "phi_r",   "phi",   "value"};
    std::array<std::optional<std::size_t>, names.size()> at;

    const std::optional<std::size_t>& of(std::string_view name) const {
        std::size_t n = 0;
        while (names[n] != name) ++n;
        return at[n];
    }
};

Columns read_header(const SampleText& text) {
    Columns columns;
    for (std::size_t w = 0; w < text.words().size(); ++w) {
        const std::string& word = text.words()[w];
        std::size_t n = 0;
        while (n < Columns::names.size() && Columns::names[n] != word) ++n;
        if (n == Columns::names.size()) {
            const std::string near = nearest_name(word, Columns::names);
            text.fail("unknown column \"" + word + "\"",
                      near.empty() ? "the first line names the columns: theta_i phi_i theta_r phi_r value"
                                   : "did you mean \"" + near + "\"?");
        }
        if (columns.at[n]) text.fail("column \"" + word + "\" is given twice");
        columns.at[n] = w;
    }
    for (const std::string_view needed : {"theta_i", "theta_r", "value"})
        if (!columns.of(needed)) text.fail("column \"" + std::string(needed) + "\" is missing");
    const bool both = columns.of("phi_i") && columns.of("phi_r");
    const bool either = columns.of("phi_i") || columns.of("phi_r");
    if (columns.of("phi") ? either : !both)
        text.fail("azimuths must be phi_i and phi_r, or phi alone",
                  "phi is the azimuth of the reflected minus that of the incident direction");
    return columns;
}

std::vector<double> read_azimuths(const SampleText& text) {
    std::vector<double> azimuths;
    for (std::size_t w = 1; w < text.words().size(); ++w)
        azimuths.push_back(text.azimuth(text.words()[w], "phi"));
    if (azimuths.empty()) text.fail("no azimuths after theta_r", "for example: theta_r 0 90 180");
    return azimuths;
}

}  // namespace

SampleSet parse_columns(std::string_view text, const std::string& name, const SampleRules& rules) {
    SampleText lines(text, name, rules);
    if (!lines.next_line()) lines.fail("the file is empty", "the first line names the columns");
    const Columns columns = read_header(lines);
    const std::size_t count = lines.words().size();
    while (lines.next_line()) {
        if (lines.words().size() != count)
            lines.fail("found " + std::to_string(lines.words().size()) + " words where the header has " +
                       std::to_string(count) + " columns");
        const auto word = [&](std::string_view column) -> const std::string& {
            return lines.words()[*columns.of(column)];
        };
        const double phi =
            columns.of("phi") ? lines.azimuth(word("phi"), "phi")
                              : lines.azimuth(word("phi_r"), "phi_r") - lines.azimuth(word("phi_i"), "phi_i");
        lines.add(lines.polar_angle(word("theta_i"), "theta_i"), phi,
                  lines.polar_angle(word("theta_r"), "theta_r"), word("value"));
    }
    return lines.take();
}

SampleSet parse_cuts(std::string_view text, const std::string& name, const SampleRules& rules) {
    SampleText lines(text, name, rules);
    std::optional<double> theta_i;
    std::vector<double> azimuths;
    while (lines.next_line()) {
        const std::vector<std::string>& words = lines.words();
        if (words[0] == "theta_i") {
            if (words.size() != 2) lines.fail("expected one incident angle", "theta_i degrees");
            theta_i = lines.polar_angle(words[1], "theta_i");
            azimuths.clear();
        } else if (words[0] == "theta_r") {
            if (!theta_i) lines.fail("a table before its incident angle", "start with: theta_i degrees");
            azimuths = read_azimuths(lines);
        } else {
            if (azimuths.empty())
                lines.fail("values before a line that names the azimuths", "for example: theta_r 0 90 180");
            if (words.size() != azimuths.size() + 1)
                lines.fail("found " + std::to_string(words.size() - 1) + " values for " +
                               std::to_string(azimuths.size()) + " azimuths",
                           "\"-\" stands for a value not measured");
            const double theta_r = lines.polar_angle(words[0], "theta_r");
            for (std::size_t k = 0; k < azimuths.size(); ++k)
                if (words[k + 1] != "-") lines.add(*theta_i, azimuths[k], theta_r, words[k + 1]);
        }
    }
    return lines.take();
}

}  // namespace infra::ir
