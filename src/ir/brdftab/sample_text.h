// Lines of a sample file as checked words and angles, whatever they mean.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ir/brdftab/sample.h"

namespace infra::ir {

class SampleText {
  public:
    /// `text` must outlive this.
    SampleText(std::string_view text, std::string name, const SampleRules& rules)
        : rest_(text), name_(std::move(name)), rules_(rules) {}

    /// Goes to the next line that has words; false at the end.
    bool next_line();

    const std::vector<std::string>& words() const { return words_; }
    int line() const { return line_; }

    /// A number of the current line; `what` names it in the error.
    double number(const std::string& word, std::string_view what) const;
    /// A polar angle given in degrees, in radians.
    double polar_angle(const std::string& word, std::string_view what) const;
    /// An azimuth given in degrees, in radians.
    double azimuth(const std::string& word, std::string_view what) const;

    /// Keeps a sample of the current line. phi as the file has it.
    void add(double theta_i, double phi, double theta_r, const std::string& value);

    /// What was kept; throws when that is nothing.
    SampleSet take();

    [[noreturn]] void fail(std::string_view message, std::string_view hint = {}) const;

  private:
    std::string_view rest_;
    std::string name_;
    SampleRules rules_;
    int line_ = 0;
    std::vector<std::string> words_;
    SampleSet set_;
};

}  // namespace infra::ir
