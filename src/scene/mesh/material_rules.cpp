#include "scene/mesh/material_rules.h"

#include <algorithm>
#include <ranges>

#include "common/error.h"
#include "common/parse_number.h"
#include "common/text.h"
#include "common/text_file.h"

namespace infra {

class MaterialRules::Parser {
  public:
    Parser(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

    std::vector<Rule> rules() {
        std::vector<Rule> rules;
        for (skip_blanks(); !text_.empty(); skip_blanks()) rules.push_back(rule());
        return rules;
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(Location{file_, line_}, what, "rules look like: wood (Group \"door\") (Face [1:20]) ;");
    }
    char next() {
        if (text_.empty()) fail("the file ends within a rule");
        const char c = text_.front();
        text_.remove_prefix(1);
        line_ += c == '\n';
        return c;
    }
    /// Blanks, and remarks from '#' to the end of the line.
    void skip_blanks() {
        while (!text_.empty() && (is_blank(text_.front()) || text_.front() == '#')) {
            const bool remark = text_.front() == '#';
            while (next() != '\n' && remark && !text_.empty()) {
            }
        }
    }
    void expect(char wanted) {
        skip_blanks();
        if (next() != wanted) fail(std::string("'") + wanted + "' is missing");
    }
    std::string word(std::string_view ends) {
        skip_blanks();
        std::string result;
        while (!text_.empty() && !is_blank(text_.front()) && ends.find(text_.front()) == ends.npos)
            result += next();
        if (result.empty()) fail("a word is missing");
        return result;
    }
    long long number(std::string_view ends) {
        long long value = 0;
        const std::string text = word(ends);
        if (!parse_int(text, value)) fail("\"" + text + "\" is no integer");
        return value;
    }

    Rule rule() {
        Rule result{word(";("), {}};
        for (skip_blanks(); text_.empty() || text_.front() != ';'; skip_blanks())
            result.conditions.push_back(condition(result));
        next();
        return result;
    }

    Condition condition(const Rule& rule) {
        static constexpr std::string_view subjects[] = {"Material", "Map", "Group", "Object", "Face"};
        expect('(');
        Condition result;
        const std::string subject = word("\"[()");
        const auto found = std::ranges::find(subjects, subject);
        if (found == std::end(subjects))
            fail("\"" + subject + "\" is none of Material, Map, Group, Object, Face");
        result.subject = static_cast<Subject>(found - std::begin(subjects));
        const auto same = [&](const Condition& c) { return c.subject == result.subject; };
        if (std::ranges::any_of(rule.conditions, same)) fail(subject + " twice in a rule");
        skip_blanks();
        value(result);
        expect(')');
        return result;
    }

    void value(Condition& condition) {
        const char first = text_.empty() ? ';' : text_.front();
        if (first == '"') {
            next();
            for (char c = next(); c != '"'; c = next()) condition.name += c;
            if (condition.subject == Subject::face) fail("a face has a number and no name");
            return;
        }
        if (condition.subject != Subject::face) fail("a name in quotes is missing");
        if (first == '[') {
            next();
            condition.low = number(":]");
            expect(':');
            condition.high = number("]");
            expect(']');
        } else {
            condition.low = condition.high = number(")");
        }
        if (condition.low > condition.high) fail("a range that ends before it begins");
    }

    std::string_view text_;
    std::string file_;
    int line_ = 1;
};

MaterialRules::MaterialRules(const std::string& path) {
    const std::string text = read_text_file(path);
    rules_ = Parser(text, path).rules();
}

bool MaterialRules::holds(const Condition& condition, const Face& face) {
    switch (condition.subject) {
        case Subject::material:
            return face.names.material == condition.name;
        case Subject::map:
            return face.names.map == condition.name;
        case Subject::group:
            return std::ranges::find(face.names.groups, condition.name) != face.names.groups.end();
        case Subject::object:
            return face.names.object == condition.name;
        case Subject::face:
            return face.number >= condition.low && face.number <= condition.high;
    }
    return false;
}

std::optional<std::string> MaterialRules::material(const Face& face) const {
    for (const Rule& rule : std::views::reverse(rules_)) {
        const auto holds_here = [&](const Condition& condition) { return holds(condition, face); };
        if (!std::ranges::all_of(rule.conditions, holds_here)) continue;
        if (rule.material == "void") return std::nullopt;
        return rule.material;
    }
    return std::nullopt;
}

}  // namespace infra
