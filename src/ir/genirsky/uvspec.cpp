#include "ir/genirsky/uvspec.h"

#include <algorithm>

#include "common/format.h"
#include "ir/genirsky/uvspec_columns.h"

namespace infra::ir {
namespace {

constexpr double nm_cm = 1e7;  // wavelength in nm times wavenumber in cm^-1

/// The unit, or the error that asks for it.
const SpectralUnit& required_unit(const UvspecLayout& layout) {
    if (!layout.unit)
        throw Error("the unit of the radiances is not stated", "-unit " + SpectralUnit::choices());
    return *layout.unit;
}

double radiance(const PlacedNumber& number, double wavenumber, const NumberText& text,
                const SpectralUnit& unit) {
    if (number.value < 0) throw Error(text.place(number), formatted("negative radiance %g", number.value));
    return unit.per_wavenumber(number.value, wavenumber);
}

void append(SampledSpectrum& spectrum, double wavenumber, double value) {
    spectrum.wavenumber.push_back(wavenumber);
    spectrum.value.push_back(value);
}

/// Checks that the lines go one way along the spectrum.
class Order {
  public:
    void next(double wavenumber, const Location& where) {
        if (count_ > 1 ? (wavenumber - last_) * step_ <= 0 : count_ == 1 && wavenumber == last_)
            throw Error(where, "the spectrum is out of order",
                        "one output level (zout) and one time a file, wavelengths in order");
        step_ = wavenumber - last_;
        last_ = wavenumber;
        ++count_;
    }
    int count() const { return count_; }
    bool descends() const { return step_ < 0; }

  private:
    double last_ = 0, step_ = 0;
    int count_ = 0;
};

/// Turns spectra that were read by rising wavelength, and refuses those too short.
void finish(SampledSpectrum& spectrum, const Order& order, const NumberText& text) {
    if (order.count() < 2) throw Error(text.end(), "a spectrum needs at least 2 wavelengths");
    if (!order.descends()) return;
    std::ranges::reverse(spectrum.wavenumber);
    std::ranges::reverse(spectrum.value);
}

bool is_cosine(const PlacedNumber& number) {
    return number.value >= -1 && number.value <= 1 && number.value != 0;
}

/// Blocks of lines, read one after the other; all must be formed as the first.
class Blocks {
  public:
    Blocks(const NumberText& text, const SpectralUnit& unit) : text_(text), unit_(unit) {}

    std::vector<UvspecRadiance> read() {
        while (next_ < text_.lines.size()) read_block();
        for (UvspecRadiance& direction : directions_) finish(direction.radiance, order_, text_);
        return std::move(directions_);
    }

  private:
    const NumberLine& line() const {
        if (next_ == text_.lines.size())
            throw Error(text_.end(), "the last block is cut off or has no radiances",
                        "-columns tells what output_user wrote");
        return text_.lines[next_];
    }
    [[noreturn]] void fail(std::string_view message) const {
        throw Error(text_.place(line()[0]), message, "-columns tells what output_user wrote");
    }

    void read_block() {
        if (line()[0].value <= 1) fail("expected a line that begins with a wavelength in nm");
        const double wavenumber = nm_cm / line()[0].value;
        order_.next(wavenumber, text_.place(line()[0]));
        ++next_;
        read_phi();
        const bool first = directions_.empty();
        std::size_t known = 0;
        while (next_ < text_.lines.size() && is_cosine(line()[0])) read_direction(wavenumber, first, known);
        if (directions_.empty()) line(), fail("expected a line that begins with umu");
        if (known != directions_.size())
            throw Error(block_end(), "the block has not the directions of the first");
    }

    Location block_end() const { return {text_.name, text_.lines[next_ - 1][0].line}; }

    /// A line of azimuths has two numbers less than the line of umu after it.
    void read_phi() {
        const NumberLine& azimuths = line();
        if (next_ + 1 >= text_.lines.size() || text_.lines[next_ + 1].size() != azimuths.size() + 2 ||
            !is_cosine(text_.lines[next_ + 1][0]))
            return;
        phi_.clear();
        for (const PlacedNumber& number : azimuths) phi_.emplace_back(number.value);
        ++next_;
    }

    void read_direction(double wavenumber, bool first, std::size_t& known) {
        const NumberLine& numbers = line();
        if (numbers.size() != phi_.size() + 2)
            throw Error(text_.place(numbers[0]), formatted("found %zu numbers where umu, u0u and uu make %zu",
                                                           numbers.size(), phi_.size() + 2));
        // without azimuths the mean over them, u0u, is the radiance
        for (std::size_t i = phi_.empty() ? 1 : 2; i < numbers.size(); ++i, ++known) {
            if (first) {
                const auto phi = phi_.empty() ? std::nullopt : std::optional(phi_[i - 2]);
                directions_.push_back({numbers[0].value, phi, {text_.name, {}, {}}});
            }
            if (known == directions_.size() || directions_[known].umu != numbers[0].value)
                throw Error(text_.place(numbers[0]), "the block has not the directions of the first");
            append(directions_[known].radiance, wavenumber, radiance(numbers[i], wavenumber, text_, unit_));
        }
        ++next_;
    }

    const NumberText& text_;
    const SpectralUnit& unit_;
    std::size_t next_ = 0;
    std::vector<double> phi_;
    std::vector<UvspecRadiance> directions_;
    Order order_;
};

std::vector<UvspecRadiance> parse_lines(const NumberText& text, const UvspecLayout& layout) {
    const UvspecColumns columns(layout);
    if (!columns.has("uu")) throw Error("-columns names no radiances", "-columns lambda,uu");
    std::vector<UvspecRadiance> directions;
    for (const double umu : layout.umu) {
        if (layout.phi.empty()) directions.push_back({umu, std::nullopt, {text.name, {}, {}}});
        for (const double phi : layout.phi) directions.push_back({umu, phi, {text.name, {}, {}}});
    }
    Order order;
    for (const NumberLine& line : text.lines) {
        columns.check(line, text);
        const double wavenumber = columns.wavenumber(line, text);
        order.next(wavenumber, text.place(line[0]));
        const PlacedNumber* uu = &columns.first(line, "uu");
        for (UvspecRadiance& direction : directions)
            append(direction.radiance, wavenumber, radiance(*uu++, wavenumber, text, *layout.unit));
    }
    for (UvspecRadiance& direction : directions) finish(direction.radiance, order, text);
    return directions;
}

}  // namespace

std::vector<UvspecRadiance> parse_uvspec(const NumberText& text, const UvspecLayout& layout) {
    const SpectralUnit& unit = required_unit(layout);
    return layout.columns.empty() ? Blocks(text, unit).read() : parse_lines(text, layout);
}

PathSpectra parse_path_columns(const NumberText& text, const UvspecLayout& layout) {
    const UvspecColumns columns(layout);
    if (!columns.has("transmittance") || !columns.has("radiance"))
        throw Error("-columns names no transmittance and radiance of a path",
                    "-columns lambda,transmittance,radiance");
    const SpectralUnit& unit = required_unit(layout);
    PathSpectra spectra{{text.name, {}, {}}, {text.name, {}, {}}};
    Order order;
    for (const NumberLine& line : text.lines) {
        columns.check(line, text);
        const double wavenumber = columns.wavenumber(line, text);
        order.next(wavenumber, text.place(line[0]));
        const PlacedNumber& transmittance = columns.first(line, "transmittance");
        if (!(transmittance.value >= 0 && transmittance.value <= 1))
            throw Error(text.place(transmittance),
                        formatted("transmittance %g is not within 0..1", transmittance.value));
        append(spectra.transmittance, wavenumber, transmittance.value);
        append(spectra.radiance, wavenumber,
               radiance(columns.first(line, "radiance"), wavenumber, text, unit));
    }
    finish(spectra.transmittance, order, text);
    finish(spectra.radiance, order, text);
    return spectra;
}

}  // namespace infra::ir
