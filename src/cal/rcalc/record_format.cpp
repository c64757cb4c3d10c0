#include "record_format.h"

#include "common/error.h"
#include "common/text.h"
#include "common/text_file.h"

namespace infra::rcalc {
namespace {

/// Takes the field at the start of `rest` off it.
Field next_field(std::string_view& rest) {
    Field field;
    if (rest.front() != '$' || rest.substr(0, 2) == "$$") {
        const std::size_t skipped = rest.front() == '$' ? 1 : 0;
        const std::size_t end = std::min(rest.find('$', skipped + skipped), rest.size());
        field.text = rest.substr(skipped, end - skipped);
        field.width = static_cast<int>(field.text.size());
        rest.remove_prefix(end);
        return field;
    }
    const char opening = rest.size() > 1 ? rest[1] : '\0';
    if (opening != '{' && opening != '(')
        throw Error("a '$' in a record format starts no field",
                    "fields are ${number} and $(string), a dollar is $$");
    const std::size_t end = rest.find(opening == '{' ? '}' : ')');
    if (end == std::string_view::npos)
        throw Error("a field of a record format is never closed: " +
                    std::string(rest.substr(0, rest.find('\n'))));
    field.kind = opening == '{' ? Field::Kind::number : Field::Kind::string;
    for (const char c : rest.substr(2, end - 2))
        if (!is_blank(c)) field.text += c;
    field.width = static_cast<int>(end + 1);
    rest.remove_prefix(end + 1);
    return field;
}

}  // namespace

RecordFormat read_record_format(std::string_view specification, bool ignore_newlines) {
    std::string text(specification);
    if (text.find('$') == std::string::npos) {
        text = read_text_file(text);
        if (text.empty()) throw Error(Location{std::string(specification)}, "record format is empty");
    }
    RecordFormat format;
    for (std::string_view rest = text; !rest.empty();) format.push_back(next_field(rest));
    if (!ignore_newlines && !text.ends_with('\n')) format.push_back({Field::Kind::literal, "\n", 1, {}});
    return format;
}

}  // namespace infra::rcalc
