#include "template_reader.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

namespace infra::rcalc {
namespace {

bool is_number_character(int c) {
    return c != EOF && (std::isdigit(c) || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E');
}

}  // namespace

TemplateReader::TemplateReader(const Settings& settings)
    : settings_(settings), format_(*settings.input_format) {
    for (const Field& field : format_)
        if (field.kind == Field::Kind::number &&
            std::find(number_names_.begin(), number_names_.end(), field.text) == number_names_.end())
            number_names_.push_back(field.text);
    numbers_.resize(number_names_.size());
    is_set_.resize(number_names_.size());
    // Blanks before a record are skipped, so the template must not start with any.
    if (settings_.exact_blanks || format_.empty() || format_.front().kind != Field::Kind::literal) return;
    std::string& start = format_.front().text;
    start.erase(start.begin(),
                std::find_if(start.begin(), start.end(), [this](char c) { return !is_blank(c); }));
    if (start.empty()) format_.erase(format_.begin());
}

void TemplateReader::open(std::FILE* file) {
    file_ = file;
    ahead_.clear();
    home_ = place_ = 0;
    load();
}

bool TemplateReader::is_blank(int c) const {
    if (settings_.ignore_newlines) return c != EOF && std::isspace(c) != 0;
    return c == ' ' || c == '\t';
}

void TemplateReader::load() {
    if (place_ == ahead_.size()) {
        const int c = std::getc(file_);
        if (c == EOF) {
            current_ = EOF;
            return;
        }
        ahead_ += static_cast<char>(c);
    }
    current_ = static_cast<unsigned char>(ahead_[place_]);
}

void TemplateReader::advance() {
    if (current_ == EOF) return;
    ++place_;
    load();
}

/// Gives up the first character of a would-be record, and starts again at the second.
void TemplateReader::step_over_start() {
    constexpr std::size_t worth_dropping = 1 << 16;
    if (home_ == ahead_.size()) return;
    if (settings_.passive != Passive::off) std::putchar(ahead_[home_]);
    if (++home_ > worth_dropping) {
        ahead_.erase(0, home_);
        home_ = 0;
    }
    place_ = home_;
    load();
}

bool TemplateReader::read() {
    while (current() != EOF) {
        while (!settings_.exact_blanks && is_blank(current())) step_over_start();
        if (current() == EOF) return false;
        const bool skip_line = !settings_.ignore_newlines && current() != '\n';
        strings_ = settings_.presets;
        std::fill(is_set_.begin(), is_set_.end(), false);
        std::size_t field = 0;
        while (field < format_.size() && matches(field)) ++field;
        if (field == format_.size()) return true;
        step_over_start();
        if (!skip_line) continue;
        while (current() != '\n' && current() != EOF) step_over_start();
        if (current() == EOF) return false;
        step_over_start();
    }
    return false;
}

void TemplateReader::leave_record(bool refused) {
    if (refused && settings_.passive == Passive::unmatched_and_refused)
        std::fwrite(ahead_.data() + home_, 1, place_ - home_, stdout);
    ahead_.erase(0, place_);
    home_ = place_ = 0;
}

bool TemplateReader::matches(std::size_t index) {
    const Field& field = format_[index];
    if (field.kind == Field::Kind::literal) return match_literal(field.text);
    const bool delimited = index + 1 < format_.size() && format_[index + 1].kind == Field::Kind::literal;
    const int delimiter = delimited ? static_cast<unsigned char>(format_[index + 1].text.front()) : EOF;
    return field.kind == Field::Kind::string ? match_string(field, delimiter)
                                             : match_number(field, delimiter);
}

bool TemplateReader::match_literal(const std::string& text) {
    for (std::size_t i = 0; i < text.size();) {
        if (!settings_.exact_blanks && is_blank(text[i])) {
            if (!is_blank(current())) return false;
            while (i < text.size() && is_blank(text[i])) ++i;
            while (is_blank(current())) advance();
        } else if (static_cast<unsigned char>(text[i]) == current()) {
            ++i;
            advance();
        } else {
            return false;
        }
    }
    return true;
}

/// Whether a field that has `length` characters goes on with the current one: up to the delimiter, or for the
/// width it has in the template where there is none or blanks count.
bool TemplateReader::continues(std::size_t length, int delimiter, int width) const {
    if (settings_.exact_blanks || delimiter == EOF) return length < static_cast<std::size_t>(width);
    return is_blank(delimiter) ? !is_blank(current()) : current() != delimiter;
}

bool TemplateReader::match_string(const Field& field, int delimiter) {
    std::string text;
    while (current() != EOF && current() != '\n' && continues(text.size(), delimiter, field.width)) {
        text += static_cast<char>(current());
        advance();
    }
    const auto [known, is_new] = strings_.try_emplace(field.text, text);
    return is_new || known->second == text;
}

bool TemplateReader::match_number(const Field& field, int delimiter) {
    std::string text;
    bool started = false;
    for (;;) {
        const bool fits = is_number_character(current()) || (!started && is_blank(current()));
        if (!fits || !continues(text.size(), delimiter, field.width)) break;
        started = started || !is_blank(current());
        text += static_cast<char>(current());
        advance();
    }
    constexpr double tolerance = .001;  // relative, between fields of the same name
    const double value = std::strtod(text.c_str(), nullptr);
    const auto index = static_cast<std::size_t>(
        std::find(number_names_.begin(), number_names_.end(), field.text) - number_names_.begin());
    if (is_set_[index]) {
        const double deviation = (numbers_[index] - value) / (value == 0 ? 1 : value);
        return std::abs(deviation) <= tolerance;
    }
    is_set_[index] = true;
    numbers_[index] = value;
    return true;
}

}  // namespace infra::rcalc
