// Finds the records in a stream that match an input template.
#pragma once

#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "settings.h"

namespace infra::rcalc {

using Strings = std::map<std::string, std::string>;  ///< values of string variables

class TemplateReader {
  public:
    /// What does not match is written to the standard output in passive mode.
    explicit TemplateReader(const Settings& settings);

    void open(std::FILE* file);

    /// Finds the next matching record; false at the end. strings() and numbers() are then those of the
    /// record.
    bool read();

    /// Goes on behind the record just read. A record refused by cond is passed on in passive mode -P.
    void leave_record(bool refused);

    const Strings& strings() const { return strings_; }
    double number(std::size_t index) const { return numbers_[index]; }

    /// Names of the numeric fields, each once; number(i) is the value of the ith.
    const std::vector<std::string>& number_names() const { return number_names_; }

  private:
    bool matches(std::size_t field);
    bool match_literal(const std::string& text);
    bool match_string(const Field& field, int delimiter);
    bool match_number(const Field& field, int delimiter);
    bool continues(std::size_t length, int delimiter, int width) const;
    bool is_blank(int c) const;
    int current() const { return current_; }
    void load();
    void advance();
    void step_over_start();

    const Settings& settings_;
    RecordFormat format_;
    std::FILE* file_ = nullptr;
    std::string ahead_;      ///< input from some point on
    std::size_t home_ = 0;   ///< in ahead_: where the record may start
    std::size_t place_ = 0;  ///< in ahead_: the current character
    int current_ = EOF;
    Strings strings_;
    std::vector<std::string> number_names_;
    std::vector<double> numbers_;
    std::vector<bool> is_set_;
};

}  // namespace infra::rcalc
