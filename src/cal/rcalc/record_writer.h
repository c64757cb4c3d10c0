// Writes output records: columns of text, binary numbers, or a filled-in template.
#pragma once

#include <functional>

#include "settings.h"
#include "template_reader.h"

namespace infra::rcalc {

class RecordWriter {
  public:
    RecordWriter(const Settings& settings, std::vector<std::pair<int, cal::ExprId>> channels)
        : settings_(settings), channels_(std::move(channels)) {}

    /// Writes one record to the standard output. `evaluate` gives the value of an expression.
    void write(const std::function<double(cal::ExprId)>& evaluate, const Strings& strings);

  private:
    void write_columns(const std::function<double(cal::ExprId)>& evaluate) const;
    void write_binary(const std::function<double(cal::ExprId)>& evaluate) const;
    void write_template(const std::function<double(cal::ExprId)>& evaluate, const Strings& strings) const;

    const Settings& settings_;
    std::vector<std::pair<int, cal::ExprId>> channels_;
};

}  // namespace infra::rcalc
