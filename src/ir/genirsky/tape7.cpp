#include "ir/genirsky/tape7.h"

#include <algorithm>
#include <optional>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/text.h"
#include "common/text_file.h"
#include "ir/genirsky/placed_numbers.h"
#include "ir/genirsky/tape7_columns.h"

namespace infra::ir {
namespace {

constexpr double per_m2 = 1e4;  // from per cm^2

std::vector<std::string_view> split_lines(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        std::string_view line = take_line(text);
        if (line.ends_with('\r')) line.remove_suffix(1);
        lines.push_back(line);
    }
    return lines;
}

bool is_end(std::string_view line) {
    const std::vector<std::string> words = split_words(line);
    double value = 0;
    return !words.empty() && parse_real(words[0], value) && value == -9999;
}

bool has_nothing(std::string_view line) { return line.find_first_not_of(" \t") == std::string_view::npos; }

class Tape7Parser {
  public:
    Tape7Parser(std::string_view text, const std::string& name) : lines_(split_lines(text)), name_(name) {}

    std::vector<Tape7Run> parse() {
        std::vector<Tape7Run> runs;
        while (find_run()) runs.push_back(read_run());
        if (runs.empty())
            throw Error(Location{name_, std::max(1, static_cast<int>(lines_.size()))},
                        "there are no spectra: no line of headings that begins with FREQ");
        return runs;
    }

  private:
    Location here() const { return {name_, static_cast<int>(next_) + 1}; }

    /// Goes to a run's first line of data. Headings stand before every run or, for further ones of the same
    /// cards, only before the first; what stands before headings is cards.
    bool find_run() {
        std::size_t headings = next_, end = next_;
        while (headings < lines_.size() && !Tape7Columns::are_headings(lines_[headings])) ++headings;
        while (end < lines_.size() && !is_end(lines_[end])) ++end;
        if (headings < lines_.size() && headings < end) {
            next_ = headings;
            refuse_tabs();
            columns_.emplace(lines_[headings], here());
            ++next_;
            // in mode 0 the headings have a second line, "CM-1 TRANS"
            if (next_ < lines_.size() && lines_[next_].find("CM-1") != std::string_view::npos) ++next_;
            return true;
        }
        return columns_ && (end < lines_.size() || has_rows_left());
    }

    /// Whether more follows than the short card that may close a file.
    bool has_rows_left() const {
        return std::any_of(lines_.begin() + static_cast<std::ptrdiff_t>(next_), lines_.end(),
                           [](std::string_view line) { return split_words(line).size() > 2; });
    }

    Tape7Run read_run() {
        Tape7Run run;
        run.line = columns_->line();
        run.has_radiance = columns_->has_radiance();
        for (SampledSpectrum* spectrum : {&run.transmittance, &run.path_radiance, &run.total_radiance})
            *spectrum = {.file = name_, .place = {}, .value = {}, .line = here().line};
        for (;; ++next_) {
            if (next_ == lines_.size())
                throw Error(Location{name_, static_cast<int>(lines_.size())}, "the run has no end",
                            "a line -9999. ends every run: is the file cut off?");
            if (is_end(lines_[next_])) break;
            if (!has_nothing(lines_[next_])) read_row(run);
        }
        if (run.transmittance.place.size() < 2) throw Error(here(), "a run needs at least 2 lines of data");
        ++next_;
        return run;
    }

    void read_row(Tape7Run& run) {
        refuse_tabs();
        const double frequency = needed(columns_->frequency());
        std::vector<double>& before = run.transmittance.place;
        if (!(frequency > 0) || (!before.empty() && frequency <= before.back()))
            throw Error(here(), formatted("frequency %g cm-1 does not come after %g cm-1", frequency,
                                          before.empty() ? 0 : before.back()));
        const double transmittance = needed(columns_->transmittance());
        if (!(transmittance >= 0 && transmittance <= 1))
            throw Error(here(), formatted("transmittance %g is not within 0..1", transmittance));
        add(run.transmittance, frequency, transmittance);
        if (!run.has_radiance) return;
        add(run.path_radiance, frequency, radiance("PTH_THRML") + radiance("SOL_SCAT", true));
        add(run.total_radiance, frequency, radiance("TOTAL_RAD"));
    }

    /// A field's place tells its column, and tabs have no width.
    void refuse_tabs() const {
        const std::size_t tab = lines_[next_].find('\t');
        if (tab != std::string_view::npos)
            throw Error(Location{name_, here().line, static_cast<int>(tab) + 1},
                        "a tab: columns must be of fixed width", "blanks, no tabs, as MODTRAN writes them");
    }

    static void add(SampledSpectrum& spectrum, double frequency, double value) {
        spectrum.place.push_back(frequency);
        spectrum.value.push_back(value);
    }

    double needed(const Tape7Column& column) const {
        const std::optional<double> value = tape7_field(lines_[next_], column, here());
        if (!value)
            throw Error(Location{name_, here().line, static_cast<int>(column.begin) + 1},
                        "column " + column.heading + " is blank");
        return *value;
    }

    /// Per m^2; 0 for a blank field that a mode may leave out.
    double radiance(std::string_view heading, bool may_be_blank = false) const {
        const Tape7Column& column = columns_->column(heading);
        if (may_be_blank && !tape7_field(lines_[next_], column, here())) return 0;
        const double value = needed(column);
        if (value < 0) throw Error(here(), formatted("%s is negative: %g", column.heading.c_str(), value));
        return per_m2 * value;
    }

    std::vector<std::string_view> lines_;
    std::string name_;
    std::size_t next_ = 0;
    std::optional<Tape7Columns> columns_;
};

}  // namespace

void Tape7Run::require_radiance() const {
    if (!has_radiance)
        throw Error(Location{transmittance.file, line}, "a run of transmittances alone (IEMSCT 0)",
                    "radiance needs IEMSCT 1 or 2");
}

std::vector<Tape7Run> parse_tape7(std::string_view text, const std::string& name) {
    return Tape7Parser(text, name).parse();
}

std::vector<Tape7Run> read_tape7(const std::string& path) {
    return parse_tape7(read_text_file(path), shown_name(path));
}

}  // namespace infra::ir
