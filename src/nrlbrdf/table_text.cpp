#include "nrlbrdf/table_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "common/error.h"
#include "common/text.h"

namespace infra {
namespace {

/// A word as it may stand in a message: short and printable.
std::string quoted(std::string_view word) {
    constexpr std::size_t longest = 24;
    std::string shown(word.substr(0, longest));
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
    if (word.size() > longest) shown += "...";
    return "\"" + shown + "\"";
}

/// Takes the first word off a line.
std::string_view take_word(std::string_view& line) {
    const auto start = std::find_if_not(line.begin(), line.end(), is_blank);
    const auto end = std::find_if(start, line.end(), is_blank);
    const std::string_view word(start, end);
    line = std::string_view(end, line.end());
    return word;
}

/// A positive number of um that is the whole word; 0 for anything else.
double wavelength(std::string_view word) {
    double um = 0;
    const auto [stop, fault] = std::from_chars(word.data(), word.data() + word.size(), um);
    return fault == std::errc() && stop == word.data() + word.size() && std::isfinite(um) && um > 0 ? um : 0;
}

}  // namespace

TableText::TableText(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
    start_table();
}

void TableText::start_table() {
    directives_ = {};
    number_seen_ = at_next_table_ = false;
    number_line_ = line_;
    skip_blanks_and_comments();
    start_ = at_;
    first_line_ = line_;
}

bool TableText::next_table() {
    if (!at_next_table_) return false;
    start_table();
    return true;
}

void TableText::read_directive(std::string_view rest, std::size_t end) {
    const std::string_view key = take_word(rest);
    const Location here{name_, line_};
    static constexpr std::array<std::string_view, 3> known = {"phi", "mirror", "band"};
    if (std::find(known.begin(), known.end(), key) == known.end()) {
        const std::string near = nearest_name(key, known);
        throw Error(here, "unknown directive " + quoted(key),
                    near.empty() ? "known are phi 180, mirror 0 and band lo hi; a comment starts with # alone"
                                 : "did you mean " + near + "?");
    }
    if (key == "band") {
        if (number_seen_) {
            at_next_table_ = true;  // and is read again by start_table
            return;
        }
        if (directives_.band) throw Error(here, "two bands for one table", "a table follows each #% band");
        directives_.band = read_band(rest);
        directives_.band_line = line_;
    } else {
        const std::string_view value = take_word(rest);
        if (number_seen_)
            throw Error(here, "directive " + quoted(key) + " after the first number",
                        "put it before the counts, after the table's #% band");
        const bool ok = key == "phi" ? value == "180" || value == "360" : value == "0" || value == "180";
        if (!ok || !take_word(rest).empty())
            throw Error(here, "bad value " + quoted(value) + " of directive " + quoted(key),
                        key == "phi" ? "180 or 360" : "0 or 180");
        if (key == "phi")
            directives_.half_phi = value == "180";
        else
            directives_.mirror_at_zero = value == "0";
    }
    at_ = end;
}

WavelengthBand TableText::read_band(std::string_view rest) const {
    const Location here{name_, line_};
    const std::string_view low = take_word(rest), high = take_word(rest);
    const WavelengthBand band{wavelength(low), wavelength(high)};
    if (!(band.lo_um > 0 && band.hi_um > 0) || !take_word(rest).empty())
        throw Error(here, "bad band " + quoted(low) + " " + quoted(high),
                    "two wavelengths in um, as in #% band 8 9");
    if (band.lo_um > band.hi_um)
        throw Error(here, "band " + std::string(low) + " to " + std::string(high) + " um is reversed",
                    "the shorter wavelength stands first");
    if (band.lo_um == band.hi_um) throw Error(here, "band of " + std::string(low) + " um has no width");
    return band;
}

void TableText::skip_blanks_and_comments() {
    while (at_ < text_.size() && !at_next_table_) {
        const char c = text_[at_];
        if (c == '#') {
            const std::size_t end = std::min(text_.find('\n', at_), text_.size());
            const std::string_view comment = text_.substr(at_ + 1, end - at_ - 1);
            if (comment.starts_with('%'))
                read_directive(comment.substr(1), end);
            else
                at_ = end;
        } else if (is_blank(c)) {
            line_ += c == '\n';
            ++at_;
        } else {
            return;
        }
    }
}

bool TableText::next(double& number) {
    skip_blanks_and_comments();
    if (at_ == text_.size() || at_next_table_) return false;
    number_line_ = line_;
    number_seen_ = true;

    const char* const start = text_.data() + at_;
    const char* const end = text_.data() + text_.size();
    const char* const digits = start + (*start == '+' && start + 1 < end && start[1] != '-');
    const auto [stop, fault] = std::from_chars(digits, end, number);
    const bool whole = stop == end || is_blank(*stop) || *stop == '#';
    if (fault == std::errc::invalid_argument || !whole) {
        std::string_view rest = text_.substr(at_);
        const std::string_view word = take_word(rest);
        throw Error({name_, line_}, "expected a number, found " + quoted(word),
                    word.find(',') != word.npos ? "numbers are separated by blanks, not commas" : "");
    }
    if (fault == std::errc::result_out_of_range)  // from_chars does not say on which side
        number = std::strtod(std::string(digits, stop).c_str(), nullptr);
    at_ = static_cast<std::size_t>(stop - text_.data());
    return true;
}

int TableText::line_of(std::size_t n) const {
    TableText again(*this);
    again.at_ = start_;
    again.line_ = first_line_;
    again.at_next_table_ = false;
    double ignored = 0;
    for (std::size_t k = 0; k <= n; ++k) again.next(ignored);
    return again.line();
}

}  // namespace infra
