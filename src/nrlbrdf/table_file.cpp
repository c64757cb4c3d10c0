#include "nrlbrdf/table_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <utility>

#include "common/error.h"
#include "common/text_file.h"
#include "nrlbrdf/table_text.h"

namespace infra {
namespace {

constexpr double pi = std::numbers::pi;

/// A printed D may exceed pi min f by its own rounding and the table's, half a unit in the fourth digit each.
constexpr double diffuse_rounding = 1e-3;

/// A printed table may reflect this much over 1 by rounding alone, without a warning.
constexpr double energy_rounding = 1e-4;

std::string printed(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", number);
    return text;
}

/// Counts as the file states them, and where each of its numbers belongs.
struct Layout {
    std::size_t ni = 0, np = 0, nt = 0;
    bool half_phi = false, mirror_at_zero = false;
    std::size_t values() const { return ni * np * nt; }

    std::string theta_i(std::size_t i) const { return angle("theta_i", 90.0 * i / (ni - 1.0)); }
    std::string theta_r(std::size_t j) const { return angle("theta_r", 90.0 * j / (nt - 1.0)); }
    std::string place(std::size_t value) const {
        const std::size_t k = value / nt % np;
        const double phi = half_phi ? 180.0 * k / (np - 1.0) : 360.0 * k / np;
        return theta_i(value / (np * nt)) + ", " + angle("phi", phi) + ", " + theta_r(value % nt);
    }
    static std::string angle(const char* name, double degrees) {
        return std::string(name) + " = " + printed(degrees) + " deg";
    }
};

Layout read_counts(TableText& text) {
    Layout layout{.half_phi = text.half_phi(), .mirror_at_zero = text.mirror_at_zero()};
    std::size_t* const counts[] = {&layout.ni, &layout.np, &layout.nt};
    const char* const names[] = {"Ni (theta_i)", "Np (phi)", "Nt (theta_r)"};
    double product = 1;
    for (int n = 0; n < 3; ++n) {
        double number = 0;
        if (!text.next(number))
            throw Error({text.name(), text.line()}, std::string("table ends before the count ") + names[n],
                        "a table starts with three counts: Ni Np Nt");
        const Location here{text.name(), text.line()};
        const bool sensible = number >= 2 && number <= static_cast<double>(max_table_values);
        if (!sensible || number != std::floor(number))
            throw Error(here, std::string("bad count ") + names[n] + ": " + printed(number),
                        n == 0 ? "a table starts with three counts, whole numbers >= 2: Ni Np Nt"
                               : "a whole number >= 2");
        product *= number;
        if (product > static_cast<double>(max_table_values))
            throw Error(here, "table of " + printed(product) + " values is too large",
                        "at most " + printed(static_cast<double>(max_table_values)));
        *counts[n] = static_cast<std::size_t>(number);
    }
    return layout;
}

/// Every number after the counts, D and values as they come.
std::vector<double> read_numbers(TableText& text, const Layout& layout) {
    const std::size_t with_one = layout.values() + 1, with_each = layout.values() + layout.ni;
    std::vector<double> numbers;
    numbers.reserve(
        std::min(with_each, text.characters_left() / 2 + 1));  // never more than the text can hold
    std::size_t found = 0;
    for (double number = 0; text.next(number); ++found)
        if (found < with_each) numbers.push_back(number);
    if (found != with_one && found != with_each) {
        const std::string counts =
            std::to_string(layout.ni) + " x " + std::to_string(layout.np) + " x " + std::to_string(layout.nt);
        throw Error({text.name(), text.line()},
                    "found " + std::to_string(found) + " numbers after the counts, not the " +
                        std::to_string(with_one) + " of " + counts + " values with one D, nor " +
                        std::to_string(with_each) + " with a D before each block",
                    found < with_one
                        ? "the table ends in the block " +
                              layout.theta_i(std::min(found / (layout.np * layout.nt), layout.ni - 1))
                        : "check the order Ni Np Nt and `#% phi 180`");
    }
    return numbers;
}

/// Takes the Ds out and checks that each fits under the data it heads, and every value.
std::vector<float> take_values(const TableText& text, const Layout& layout,
                               const std::vector<double>& numbers) {
    constexpr std::size_t counts = 3;
    const bool one_d = numbers.size() == layout.values() + 1;
    const std::size_t blocks = one_d ? 1 : layout.ni;
    const std::size_t block_size = layout.values() / blocks;
    std::vector<float> values;
    values.reserve(layout.values());
    for (std::size_t b = 0; b < blocks; ++b) {
        const std::size_t head = b * (block_size + 1);
        std::size_t lowest = 0;
        for (std::size_t n = 0; n < block_size; ++n) {
            const double f = numbers[head + 1 + n];
            if (!(f >= 0 && f <= static_cast<double>(std::numeric_limits<float>::max())))
                throw Error({text.name(), text.line_of(counts + head + 1 + n)},
                            (f < 0 ? "negative BRDF value " : "BRDF value is not finite: ") + printed(f) +
                                " at " + layout.place(values.size()));
            values.push_back(static_cast<float>(f));
            if (f < numbers[head + 1 + lowest]) lowest = n;
        }
        const double diffuse = numbers[head];
        const double most = pi * numbers[head + 1 + lowest];
        const std::string whose = one_d ? "" : " of the block " + layout.theta_i(b);
        if (!(diffuse >= 0 && std::isfinite(diffuse)))
            throw Error({text.name(), text.line_of(counts + head)},
                        "diffuse reflectance D" + whose + " is " + printed(diffuse), "finite and >= 0");
        if (diffuse > most * (1 + diffuse_rounding))
            throw Error({text.name(), text.line_of(counts + head)},
                        "diffuse reflectance D = " + printed(diffuse) + whose +
                            " is larger than the data allow, " + printed(most) + " at " +
                            layout.place(b * block_size + lowest),
                        "D is at most pi times the smallest value");
    }
    return values;
}

/// Rows 0..180 deg with both ends become rows all the way round.
std::vector<float> mirrored(const std::vector<float>& half, const Layout& layout) {
    const std::size_t full = 2 * (layout.np - 1);
    std::vector<float> values;
    values.reserve(layout.ni * full * layout.nt);
    for (std::size_t i = 0; i < layout.ni; ++i)
        for (std::size_t k = 0; k < full; ++k) {
            const std::size_t row = i * layout.np + std::min(k, full - k);
            const auto start = half.begin() + static_cast<std::ptrdiff_t>(row * layout.nt);
            values.insert(values.end(), start, start + static_cast<std::ptrdiff_t>(layout.nt));
        }
    return values;
}

/// A grid that still knows its text, for messages about the finished table.
struct Parsed {
    BrdfGrid grid;
    Layout layout;
    bool one_d = true;
    /// Where in the text, counted in numbers, the first value of block i is.
    std::size_t block_start(std::size_t i) const {
        return 3 + i * layout.np * layout.nt + (one_d ? 1 : i + 1);
    }
};

Parsed parse(TableText& text) {
    Parsed parsed{.layout = read_counts(text)};
    const Layout& layout = parsed.layout;
    const std::vector<double> numbers = read_numbers(text, layout);
    parsed.one_d = numbers.size() == layout.values() + 1;
    BrdfGrid& grid = parsed.grid;
    grid.values = take_values(text, layout, numbers);
    if (layout.half_phi) grid.values = mirrored(grid.values, layout);
    grid.theta_i_count = static_cast<int>(layout.ni);
    grid.phi_count = static_cast<int>(layout.half_phi ? 2 * (layout.np - 1) : layout.np);
    grid.theta_r_count = static_cast<int>(layout.nt);
    grid.phi_origin = layout.mirror_at_zero ? pi : 0;
    return parsed;
}

/// Index of the largest, when it is over 1 by more than rounding; -1 otherwise.
int worst_reflectance(const std::vector<double>& reflectances) {
    const auto worst = std::max_element(reflectances.begin(), reflectances.end());
    return *worst > 1 + energy_rounding ? static_cast<int>(worst - reflectances.begin()) : -1;
}

std::string energy_warning(Location where, double reflectance, const std::string& angle) {
    return Error(std::move(where),
                 "directional-hemispherical reflectance " + printed(reflectance) + " is over 1 at " + angle)
        .what();
}

/// Reflectance over 1, at the worst incident angle and at the worst viewing angle.
std::vector<std::string> energy_warnings(const BrdfTable& table, const Parsed& parsed,
                                         const TableText& text) {
    std::vector<std::string> warnings;
    std::vector<double> reflectances;
    for (int i = 0; i < table.theta_i_count(); ++i) reflectances.push_back(table.incident_reflectance(i));
    if (const int i = worst_reflectance(reflectances); i >= 0) {
        const auto block = static_cast<std::size_t>(i);
        warnings.push_back(energy_warning({text.name(), text.line_of(parsed.block_start(block))},
                                          reflectances[block], parsed.layout.theta_i(block)));
    }
    reflectances.clear();
    for (int j = 0; j < table.theta_r_count(); ++j)
        reflectances.push_back(table.diffuse_reflectance() + table.lobe_reflectance_node(j));
    if (const int j = worst_reflectance(reflectances); j >= 0) {
        const auto column = static_cast<std::size_t>(j);
        warnings.push_back(energy_warning({text.name(), text.line_of(0)}, reflectances[column],
                                          "the viewing angle " + parsed.layout.theta_r(column)));
    }
    return warnings;
}

LoadedTable load(TableText& text) {
    Parsed parsed = parse(text);
    LoadedTable loaded{.band = text.band(), .place = {text.name(), text.table_line()}};
    loaded.table = std::make_shared<const BrdfTable>(parsed.grid);
    loaded.warnings = energy_warnings(*loaded.table, parsed, text);
    return loaded;
}

/// Refuses a second table.
void expect_end(TableText& text) {
    if (text.next_table())
        throw Error({text.name(), text.table_line()}, "another table of a file that should have one only");
}

}  // namespace

BrdfGrid parse_table(std::string_view text, const std::string& name) {
    TableText numbers(text, name);
    BrdfGrid grid = parse(numbers).grid;
    expect_end(numbers);
    return grid;
}

BrdfGrid read_table_file(const std::string& path) { return parse_table(read_text_file(path), path); }

LoadedTable load_table(const std::string& path) {
    const std::string content = read_text_file(path);
    TableText text(content, path);
    LoadedTable loaded = load(text);
    expect_end(text);
    return loaded;
}

std::vector<LoadedTable> load_tables(const std::string& path) {
    const std::string content = read_text_file(path);
    TableText text(content, path);
    std::vector<LoadedTable> tables;
    do tables.push_back(load(text));
    while (text.next_table());
    return tables;
}

}  // namespace infra
