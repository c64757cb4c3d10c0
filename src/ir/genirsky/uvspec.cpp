#include "ir/genirsky/uvspec.h"

#include <algorithm>
#include <span>

#include "common/format.h"
#include "ir/genirsky/uvspec_azimuths.h"
#include "ir/genirsky/uvspec_columns.h"

namespace infra::ir {
namespace {

/// The unit, or the error that asks for it.
const SpectralUnit& required_unit(const UvspecLayout& layout) {
    if (!layout.unit)
        throw Error("the unit of the radiances is not stated", "-unit " + SpectralUnit::choices());
    return *layout.unit;
}

double radiance(const PlacedNumber& number, const NumberText& text, const SpectralUnit& unit) {
    if (number.value < 0) throw Error(text.place(number), formatted("negative radiance %g", number.value));
    return unit.watts(number.value);
}

SampledSpectrum empty_spectrum(const NumberText& text, SpectralAxis axis, const SpectralUnit& unit) {
    return {.file = text.name,
            .place = {},
            .value = {},
            .line = text.lines[0][0].line,
            .axis = axis,
            .density = unit.density()};
}

void append(SampledSpectrum& spectrum, double place, double value) {
    spectrum.place.push_back(place);
    spectrum.value.push_back(value);
}

/// Checks that the lines go one way along the spectrum.
class Order {
  public:
    void next(double place, const Location& where) {
        if (count_ > 1 ? (place - last_) * step_ <= 0 : count_ == 1 && place == last_)
            throw Error(where, "the spectrum is out of order",
                        "one output level (zout) and one time a file, wavelengths in order");
        step_ = place - last_;
        last_ = place;
        ++count_;
    }
    int count() const { return count_; }
    bool descends() const { return step_ < 0; }

  private:
    double last_ = 0, step_ = 0;
    int count_ = 0;
};

/// Turns spectra that were read by falling place, and refuses those too short.
void finish(SampledSpectrum& spectrum, const Order& order, const NumberText& text) {
    if (order.count() < 2) throw Error(text.end(), "a spectrum needs at least 2 wavelengths");
    if (!order.descends()) return;
    std::ranges::reverse(spectrum.place);
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
        const double um = line()[0].value / nm_per_um;
        order_.next(um, text_.place(line()[0]));
        ++next_;
        read_phi();
        const bool first = directions_.empty();
        std::size_t known = 0;
        while (next_ < text_.lines.size() && is_cosine(line()[0])) read_direction(um, first, known);
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
        std::vector<double> phi;
        for (const PlacedNumber& number : azimuths) phi.push_back(number.value);
        azimuths_ = UvspecAzimuths(phi);
        ++next_;
    }

    void read_direction(double um, bool first, std::size_t& known) {
        const NumberLine& numbers = line();
        // without azimuths the mean over them, u0u, is the radiance
        const std::size_t before = has_azimuths() ? 2 : 1;
        if (numbers.size() != before + azimuths_.columns())
            throw Error(text_.place(numbers[0]), formatted("found %zu numbers where umu, u0u and uu make %zu",
                                                           numbers.size(), before + azimuths_.columns()));
        const double umu = numbers[0].value;
        const std::vector<PlacedNumber> found = azimuths_.distinct(std::span(numbers).subspan(before), text_);
        for (std::size_t i = 0; i < found.size(); ++i, ++known) {
            const std::optional<double>& phi = azimuths_.directions()[i];
            if (first)
                directions_.push_back({umu, phi, empty_spectrum(text_, SpectralAxis::wavelength, unit_)});
            if (known == directions_.size() || directions_[known].umu != umu || directions_[known].phi != phi)
                throw Error(text_.place(numbers[0]), "the block has not the directions of the first");
            append(directions_[known].radiance, um, radiance(found[i], text_, unit_));
        }
        ++next_;
    }
    bool has_azimuths() const { return azimuths_.directions()[0].has_value(); }

    const NumberText& text_;
    const SpectralUnit& unit_;
    std::size_t next_ = 0;
    UvspecAzimuths azimuths_;
    std::vector<UvspecRadiance> directions_;
    Order order_;
};

std::vector<UvspecRadiance> parse_lines(const NumberText& text, const UvspecLayout& layout) {
    const UvspecColumns columns(layout);
    if (!columns.has("uu")) throw Error("-columns names no radiances", "-columns lambda,uu");
    const UvspecAzimuths azimuths(layout.phi);
    std::vector<UvspecRadiance> directions;
    for (const double umu : layout.umu)
        for (const std::optional<double>& phi : azimuths.directions())
            directions.push_back({umu, phi, empty_spectrum(text, columns.axis(), *layout.unit)});
    Order order;
    for (const NumberLine& line : text.lines) {
        columns.check(line, text);
        const double place = columns.place(line, text);
        order.next(place, text.place(line[0]));
        const PlacedNumber* uu = &columns.first(line, "uu");
        for (auto direction = directions.begin(); direction != directions.end(); uu += azimuths.columns())
            for (const PlacedNumber& number : azimuths.distinct({uu, azimuths.columns()}, text))
                append((direction++)->radiance, place, radiance(number, text, *layout.unit));
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
    const SampledSpectrum none = empty_spectrum(text, columns.axis(), unit);
    PathSpectra spectra{none, none};
    Order order;
    for (const NumberLine& line : text.lines) {
        columns.check(line, text);
        const double place = columns.place(line, text);
        order.next(place, text.place(line[0]));
        const PlacedNumber& transmittance = columns.first(line, "transmittance");
        if (!(transmittance.value >= 0 && transmittance.value <= 1))
            throw Error(text.place(transmittance),
                        formatted("transmittance %g is not within 0..1", transmittance.value));
        append(spectra.transmittance, place, transmittance.value);
        append(spectra.radiance, place, radiance(columns.first(line, "radiance"), text, unit));
    }
    finish(spectra.transmittance, order, text);
    finish(spectra.radiance, order, text);
    return spectra;
}

}  // namespace infra::ir
