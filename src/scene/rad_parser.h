// The grammar of .rad text: comments, !commands and primitives, before any name means something.
// xform works on this level; rad_reader.h resolves the names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/error.h"
#include "scene/primitive_types.h"
#include "scene/text_source.h"

namespace infra {

/// Longest word RADIANCE's programs read, in characters.
inline constexpr std::size_t longest_word = 511;

/// One primitive as written.
struct ParsedPrimitive {
    std::string modifier;
    PrimitiveType type = PrimitiveType::polygon;
    std::string name;
    std::vector<std::string> strings;  ///< of an alias: the name of its target
    std::vector<double> reals;

    /// "polygon "north"", for messages.
    std::string description() const;
};

class RadParser {
  public:
    enum class Item { end, comment, command, primitive };

    explicit RadParser(TextSource source) : source_(std::move(source)) {}

    /// Reads the next item; text() or primitive() hold it.
    ///   throws  Error with file and line for anything malformed
    Item next();

    /// A comment from its '#' to the end of the line, or a command from its '!' with escaped line ends kept.
    const std::string& text() const { return text_; }
    const ParsedPrimitive& primitive() const { return primitive_; }
    /// Place of the current item.
    Location location() const { return {source_.name(), line_, 0}; }
    int line() const { return line_; }
    /// Description of the primitive before the current one, "" at the first: miscounted arguments show up as
    /// nonsense in the primitive that follows them.
    std::string previous() const;

  private:
    void read_comment();
    void read_command();
    void read_primitive();
    void read_arguments();
    /// The next word, valid until the one after it is read. returns false at the end of the file.
    bool read_word(std::string_view& word);
    bool read_quoted_word(std::string_view& word);
    /// Reports the end of the file where a word should stand.
    [[noreturn]] void missing_word(std::string_view what);
    int read_count(const char* sort);
    void refuse_tab(std::string_view word, const char* what) const;
    [[noreturn]] void fail(std::string_view message, std::string_view hint = {}) const;

    TextSource source_;
    ParsedPrimitive primitive_;
    std::string text_;
    std::string_view word_;
    std::string quoted_word_;
    int line_ = 0;       // of the current item
    int word_line_ = 0;  // of the current word
    PrimitiveType previous_type_ = PrimitiveType::polygon;
    std::string previous_name_;
};

}  // namespace infra
