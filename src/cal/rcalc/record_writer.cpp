#include "record_writer.h"

#include <cmath>
#include <cstdio>

#include "binary.h"
#include "common/error.h"
#include "common/format.h"

namespace infra::rcalc {
namespace {

/// The number with as many figures as the field's width has room for; whole numbers without decimals.
std::string number_text(double value, int width) {
    constexpr double largest_int = 2147483648., rounding = 1e-14;
    const double size = std::abs(value), nearest = std::floor(size + .5);
    if (size < largest_int && nearest > 0 && std::abs(size - nearest) <= size * rounding)
        return formatted("%.0f", value);
    return width <= 9 ? formatted("%g", value) : formatted("%.*e", width - 5, value);
}

}  // namespace

void RecordWriter::write(const std::function<double(cal::ExprId)>& evaluate, const Strings& strings) {
    if (settings_.output_format)
        write_template(evaluate, strings);
    else if (settings_.output_form == NumberForm::text)
        write_columns(evaluate);
    else
        write_binary(evaluate);
    if (settings_.unbuffered) std::fflush(stdout);
}

void RecordWriter::write_columns(const std::function<double(cal::ExprId)>& evaluate) const {
    std::string line;
    int column = 1;
    for (const auto& [number, expression] : channels_) {
        for (; column < number; ++column) line += settings_.separator;
        line += formatted("%.9g", evaluate(expression));
    }
    if (channels_.empty()) return;
    line += '\n';
    std::fwrite(line.data(), 1, line.size(), stdout);
}

void RecordWriter::write_binary(const std::function<double(cal::ExprId)>& evaluate) const {
    const std::size_t size = number_size(settings_.output_form);
    int column = 1;
    for (const auto& [number, expression] : channels_) {
        for (; column < number; ++column)
            std::fwrite(encode_number(0, settings_.output_form).data(), 1, size, stdout);
        std::fwrite(encode_number(evaluate(expression), settings_.output_form).data(), 1, size, stdout);
        ++column;
    }
}

// A field next to other text on both sides takes the room it needs, one next to text on its left is set flush
// left in its width, and one after a blank flush right.
void RecordWriter::write_template(const std::function<double(cal::ExprId)>& evaluate,
                                  const Strings& strings) const {
    const RecordFormat& format = *settings_.output_format;
    std::string record;
    bool text_before = false;
    for (std::size_t i = 0; i < format.size(); ++i) {
        const Field& field = format[i];
        if (field.kind == Field::Kind::literal) {
            record += field.text;
            text_before = !field.text.ends_with(' ');
            continue;
        }
        std::string text;
        if (field.kind == Field::Kind::number) {
            text = number_text(evaluate(field.expression), field.width);
        } else {
            const auto known = strings.find(field.text);
            if (known == strings.end())
                throw Error("undefined string variable \"" + field.text + "\" in the output format");
            text = known->second;
        }
        const bool last = i + 1 == format.size();
        const bool blank_after =
            !last && format[i + 1].kind == Field::Kind::literal && format[i + 1].text.front() == ' ';
        const bool text_after = !settings_.exact_blanks && !last && !blank_after;
        const auto width = static_cast<std::size_t>(field.width);
        const std::string padding(text.size() < width ? width - text.size() : 0, ' ');
        record += !text_before ? padding + text : text_after ? text : text + padding;
        text_before = true;
    }
    std::fwrite(record.data(), 1, record.size(), stdout);
}

}  // namespace infra::rcalc
