// The text of a .brdf file as numbers: directives, comments and places apart from what the numbers mean.
//
//     TableText text(content, path);
//     do {                                         // a table: its directives are known before its numbers
//         text.band(), text.half_phi(), ...
//         while (text.next(number)) ...
//     } while (text.next_table());
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "nrlbrdf/wavelength_band.h"

namespace infra {

/// Reads the text from front to back, so that counts are checked before anything is allocated for them.
class TableText {
  public:
    /// `text` must outlive this; `name` stands for the file in errors. Reads the first table's directives.
    TableText(std::string_view text, std::string name);

    /// Goes on to the table after a `#% band`; false when next() ended at the end of the text.
    bool next_table();

    /// Wavelengths of the table at hand (`#% band lo hi`), if they are stated.
    const std::optional<WavelengthBand>& band() const { return directives_.band; }
    /// Line of that directive, or of the table's first number where there is none.
    int table_line() const { return directives_.band ? directives_.band_line : first_line_; }

    /// True when rows cover 0..180 deg (`#% phi 180`).
    bool half_phi() const { return directives_.half_phi; }

    /// True when the mirror direction is phi = 0 (`#% mirror 0`).
    bool mirror_at_zero() const { return directives_.mirror_at_zero; }

    /// The next number of the table at hand; false at its end.
    ///   throws  infra::Error for what is no number, or another directive than a band's among the numbers;
    ///   nan
    ///           and inf pass
    bool next(double& number);

    /// Line of the number that next() gave last, also once it has met the end; before the first, that of the
    /// table's start.
    int line() const { return number_line_; }

    /// Line of the n-th number of the table at hand, from 0. Scans from its start: for messages.
    int line_of(std::size_t n) const;

    /// Characters from here to the end of the text: more numbers than half of them it cannot hold.
    std::size_t characters_left() const { return text_.size() - at_; }

    const std::string& name() const { return name_; }

  private:
    struct Directives {
        bool half_phi = false;
        bool mirror_at_zero = false;
        std::optional<WavelengthBand> band;
        int band_line = 0;
    };

    void start_table();
    void skip_blanks_and_comments();
    void read_directive(std::string_view rest, std::size_t end);
    WavelengthBand read_band(std::string_view rest) const;

    std::string_view text_;
    std::string name_;
    std::size_t at_ = 0;
    int line_ = 1;
    int number_line_ = 1;
    bool number_seen_ = false;  // of the table at hand
    bool at_next_table_ = false;
    Directives directives_;

    std::size_t start_ = 0;  // of the table's numbers
    int first_line_ = 1;
};

}  // namespace infra
