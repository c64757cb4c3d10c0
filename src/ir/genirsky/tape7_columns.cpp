#include "ir/genirsky/tape7_columns.h"

#include <algorithm>
#include <array>

#include "common/format.h"
#include "common/parse_number.h"

namespace infra::ir {
namespace {

/// Headings of two words, which MODTRAN 4 separates by a blank.
constexpr std::array<std::string_view, 10> pairs{"TOT_TRANS", "PTH_THRML", "THRML_SCT", "SURF_EMIS",
                                                 "SOL_SCAT",  "SING_SCAT", "GRND_RFLT", "DRCT_RFLT",
                                                 "TOTAL_RAD", "REF_SOL"};

std::string joined_pairs(std::string_view line) {
    std::string text(line);
    for (const std::string_view pair : pairs) {
        std::string spaced(pair);
        spaced[spaced.find('_')] = ' ';
        const std::size_t at = text.find(spaced);
        if (at != std::string::npos) text.replace(at, pair.size(), pair);
    }
    return text;
}

}  // namespace

bool Tape7Columns::are_headings(std::string_view line) {
    const std::vector<std::string> words = split_words(line);
    return !words.empty() && (words[0].starts_with("FREQ") || words[0].starts_with("WAVLEN"));
}

Tape7Columns::Tape7Columns(std::string_view line, Location where) : where_(std::move(where)) {
    const std::string text = joined_pairs(line);
    std::size_t end = 0;
    for (const std::string& word : split_words(text)) {
        const std::size_t begin = end;
        end = text.find(word, begin) + word.size();
        columns_.push_back({word, begin, end});
    }
    const auto has = [this](std::string_view heading) {
        return std::ranges::find(columns_, heading, &Tape7Column::heading) != columns_.end();
    };
    if (!has("FREQ"))
        throw Error(where_, "spectra by \"" + columns_[0].heading + "\" are not read",
                    "tape7 itself, by FREQ in cm-1, not its convolution");
    if (has("LOS"))
        throw Error(where_, "several lines of sight in one run", "make a run for each line of sight");
    has_radiance_ = has("TOTAL_RAD");
    if (!has_radiance_ && !has("COMBIN"))
        throw Error(where_, "neither radiances nor transmittances: a run of solar irradiance (IEMSCT 3)?",
                    "IEMSCT 1 or 2 gives radiance");
}

const Tape7Column& Tape7Columns::column(std::string_view heading) const {
    const auto found = std::ranges::find(columns_, heading, &Tape7Column::heading);
    if (found == columns_.end()) throw Error(where_, "there is no column " + std::string(heading));
    return *found;
}

std::optional<double> tape7_field(std::string_view line, const Tape7Column& column, const Location& where) {
    const std::string_view field =
        line.substr(std::min(column.begin, line.size()), column.end - column.begin);
    const std::size_t first = field.find_first_not_of(" \t");
    if (first == std::string_view::npos) return std::nullopt;
    const Location place{where.file, where.line, static_cast<int>(column.begin + first) + 1};
    if (line.size() < column.end) throw Error(place, "the line is cut off in column " + column.heading);
    const std::string_view word = field.substr(first, field.find_last_not_of(" \t") + 1 - first);
    double value = 0;
    if (!parse_real(word, value))
        throw Error(place, column.heading + ": expected a number, found \"" + std::string(word) + "\"",
                    "columns end where their headings end");
    return value;
}

}  // namespace infra::ir
