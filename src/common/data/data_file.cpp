#include "common/data/data_file.h"

#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "common/format.h"
#include "common/number_text.h"
#include "common/text_file.h"

namespace infra {
namespace {

constexpr long long most_values = 1LL << 30;

std::vector<double> read_places(NumberText& text, long long count, std::size_t axis) {
    std::vector<double> places;
    for (long long i = 0; i < count; ++i) {
        const double place = text.real(formatted("place %lld of dimension %zu", i + 1, axis));
        const std::size_t n = places.size();
        const bool stands_still = n > 0 && place == places[n - 1];
        const bool turns = n > 1 && (place > places[n - 1]) != (places[n - 1] > places[n - 2]);
        if (stands_still || turns)
            throw text.error(
                formatted("place %g of dimension %zu is out of order after %g", place, axis, places[n - 1]),
                "places must rise or fall");
        places.push_back(place);
    }
    return places;
}

/// axis: from 1, for messages.
DataAxis read_axis(NumberText& text, std::size_t axis) {
    const std::string name = formatted(" of dimension %zu", axis);
    const double begin = text.real("the begin" + name);
    const double end = text.real("the end" + name);
    const long long count = text.integer("the number of places" + name);
    if (count < 2 || count > most_values)
        throw text.error("the number of places" + name + " is " + std::to_string(count),
                         "there must be at least 2");
    if (begin == end) return DataAxis(read_places(text, count, axis));
    return DataAxis(begin, end, static_cast<std::size_t>(count));
}

std::vector<float> read_values(NumberText& text, const std::vector<DataAxis>& axes) {
    std::string shape;
    long long count = 1;
    for (const DataAxis& axis : axes) {
        shape += (shape.empty() ? "" : " x ") + std::to_string(axis.size());
        count *= static_cast<long long>(axis.size());
        if (count > most_values) throw text.error("a table of " + shape + " values is too large");
    }
    std::vector<float> values;  // grows with what the file really holds
    for (long long i = 0; i < count; ++i) {
        const double number = text.real(formatted("value %lld of %lld (%s)", i + 1, count, shape.c_str()));
        values.push_back(static_cast<float>(number));
        if (std::isinf(values.back())) throw text.error(formatted("value %g is too large", number));
    }
    if (!text.at_end()) {
        text.real("");
        throw text.error(formatted("more numbers than the %lld values (%s)", count, shape.c_str()));
    }
    return values;
}

}  // namespace

DataTable parse_data(std::string_view content, const std::string& name) {
    NumberText text(content, name);
    const long long dimensions = text.integer("the number of dimensions");
    if (dimensions < 1 || dimensions > static_cast<long long>(DataTable::most_dimensions))
        throw text.error(formatted("the number of dimensions is %lld", dimensions),
                         formatted("from 1 to %zu", DataTable::most_dimensions));
    std::vector<DataAxis> axes;
    for (long long i = 1; i <= dimensions; ++i) axes.push_back(read_axis(text, static_cast<std::size_t>(i)));
    std::vector<float> values = read_values(text, axes);
    return DataTable(std::move(axes), std::move(values));
}

DataTable read_data_file(const std::string& path) { return parse_data(read_text_file(path), path); }

}  // namespace infra
