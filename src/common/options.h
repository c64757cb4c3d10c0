// One table per program describes its options. Parsing, -defaults, -help and the manual page all come from
// it.
//
//     OptionTable options("rpict");
//     options.real("-dt", &settings.direct_threshold, "direct threshold");
//     options.toggle("-u", &settings.uncorrelated, "uncorrelated sampling", "correlated sampling");
//     options.unsupported("-features", "", "-help lists what there is");
//     const auto operands = options.parse(argc, argv);
//     if (!operands) return 0;  // -defaults, -help or -version was answered
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/vec.h"

namespace infra {

/// What was given to one option. The values have been checked against the row's pattern.
struct OptionValues {
    std::string_view option;              ///< as typed, "-ovn"
    std::string_view attached;            ///< the letters after the row's spelling, "vn"
    std::span<const std::string> values;  ///< one per pattern letter, fewer where some are optional

    double real(std::size_t i) const;
    int integer(std::size_t i) const;
    const std::string& text(std::size_t i) const { return values[i]; }

    /// Throws the command line error for this option, with what is wrong and what to try.
    [[noreturn]] void reject(std::string_view why, std::string_view hint = {}) const;
};

/// One option. The member functions adjust a row that OptionTable has just made, and return it.
class OptionRow {
  public:
    enum class Form {
        exact,     ///< "-ab 2": the spelling, then arguments
        toggle,    ///< "-u", "-u+", "-u-", "-u1", "-u0"
        attached,  ///< "-ovn": letters follow the spelling without a blank
        rest       ///< "-c command ..": takes all words that follow
    };

    std::string spelling;                            ///< with its dash, "-ab"
    Form form = Form::exact;                         ///< how it is written
    std::string pattern;                             ///< a letter an argument: f real, i integer, s text
    std::size_t required = std::string::npos;        ///< how many of these have to be there
    std::string arguments;                           ///< names of the arguments for people, "x y z"
    std::string help;                                ///< what it sets, "ambient bounces"
    std::string unsupported;                         ///< why RADIANCE's option is refused; empty: it works
    std::function<void(const OptionValues&)> apply;  ///< sets the target
    std::function<std::string()> shown_value;        ///< "-ab 2" for -defaults; empty function: not listed
    std::function<std::string()> shown_help;         ///< the remark in -defaults where it is not `help`
    std::optional<double> minimum;                   ///< least number allowed
    std::string differs;   ///< how it differs from RADIANCE's; empty: it does the same
    bool is_ours = false;  ///< RADIANCE has no such option

    /// Writes the option in -defaults by `value` instead of in the usual form; not while that is empty.
    OptionRow& shown(std::function<std::string()> value);
    /// Writes the remark of -defaults by `remark`, for a text that depends on the value.
    OptionRow& remark(std::function<std::string()> remark);
    /// Leaves the option out of -defaults.
    OptionRow& unlisted();
    /// Names the arguments for -help, "width height".
    OptionRow& named(std::string names);
    /// Makes the arguments after the first `count` optional: each is taken while it is a number of its kind.
    OptionRow& optional_after(std::size_t count);
    /// Refuses numbers below `least`.
    OptionRow& at_least(double least);
    /// Says in the reference how the option differs from RADIANCE's, and why.
    OptionRow& differing(std::string how);
    /// Marks an option that RADIANCE's program does not have.
    OptionRow& ours();
};

class OptionTable {
  public:
    /// `program` opens -help; `usage` is what follows the options there, "[octree]".
    explicit OptionTable(std::string program, std::string usage = {});

    /// Numbers, shown in -defaults as RADIANCE does: %f, or %.2e where `scientific`, and %-9d.
    OptionRow& real(std::string spelling, double* target, std::string help, bool scientific = false);
    OptionRow& real(std::string spelling, float* target, std::string help, bool scientific = false);
    OptionRow& integer(std::string spelling, int* target, std::string help);
    /// "-u" inverts; help texts for the on and the off state. One text serves as "text on" and "text off".
    OptionRow& toggle(std::string spelling, bool* target, std::string help);
    OptionRow& toggle(std::string spelling, bool* target, std::string help_on, std::string help_off);
    /// A word. Not listed in -defaults.
    OptionRow& text(std::string spelling, std::string* target, std::string help);
    OptionRow& vec3(std::string spelling, Vec3* target, std::string help);
    OptionRow& color(std::string spelling, std::array<float, 3>* target, std::string help,
                     bool scientific = false);
    /// Anything else. Not listed in -defaults unless shown() says how.
    OptionRow& custom(std::string spelling, std::string pattern,
                      std::function<void(const OptionValues&)> apply, std::string help);
    /// An option written in one word with letters joined on, as -ovn, -ffd, -vtv; may take arguments besides.
    OptionRow& attached(std::string spelling, std::string pattern,
                        std::function<void(const OptionValues&)> apply, std::string help);
    /// An option that takes the rest of the command line, `least` words or more, none of which is an option.
    OptionRow& rest(std::string spelling, std::size_t least, std::function<void(const OptionValues&)> apply,
                    std::string help);
    /// An option that RADIANCE has and we don't yet: refused by name, with the reason.
    OptionRow& unsupported(std::string spelling, std::string pattern, std::string reason);
    /// The same for options with letters joined on (-apX).

    /// What the program does, in lines of -help between the usage and the options.
    void describe(std::string description);

    /// Reads options from this environment variable before those of the command line, when it is set.
    void read_environment(std::string variable);

    /// Leaves "@file" and "$NAME" alone, for programs that take any words.
    void take_words_literally();

    /// Applies the options and returns the words after them, or nothing when -defaults, -help or -version was
    /// printed. The first word that is no option ends them; "-" alone is no option. On the way "@file" is
    /// replaced by the words of a file ('#' to the end of line is a remark) and "$NAME" by those of an
    /// environment variable. throws Error "command line error at '-zz': ..." for unknown options, missing or
    /// bad arguments.
    std::optional<std::vector<std::string>> parse(int argc, char** argv);
    std::optional<std::vector<std::string>> parse(std::vector<std::string> words);

    /// After parse(): "program -options" with @file and $NAME replaced, as RADIANCE's headers record it.
    std::string command_line() const;
    /// The same without the options of these spellings and their arguments.
    std::string command_line_without(std::span<const std::string_view> spellings) const;

    /// The text that -defaults prints: the values as they are now, one line each.
    std::string defaults() const;
    /// The text that -help prints.
    std::string help() const;

    /// All options in table order, for the manual.
    const std::deque<OptionRow>& rows() const { return rows_; }
    const std::string& program() const { return program_; }

  private:
    OptionRow& add(OptionRow row);
    const OptionRow* find(std::string_view word, std::string_view& attached) const;
    std::string near_spelling(std::string_view word) const;
    bool begins_option(const std::string& word) const;
    /// Applies one option at words[i] and returns the number of arguments it took.
    std::size_t apply(const OptionRow& row, std::string_view attached, const std::vector<std::string>& words,
                      std::size_t i) const;

    std::string program_;
    std::string usage_;
    std::string description_;
    std::string environment_;
    bool literal_ = false;
    std::deque<OptionRow> rows_;  // a deque, so that the references handed out stay good
    struct Applied {
        std::string spelling;            // of the row
        std::vector<std::string> words;  // as given
    };
    std::vector<Applied> applied_;
};

}  // namespace infra
