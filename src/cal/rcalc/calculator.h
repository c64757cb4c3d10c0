// The work of rcalc: records in, records out.
#pragma once

#include <memory>

#include "cal/evaluator.h"
#include "columns.h"
#include "record_writer.h"
#include "settings.h"
#include "template_reader.h"

namespace infra::rcalc {

class Calculator {
  public:
    explicit Calculator(Settings settings);

    /// All files named on the command line, the standard input if none is, or a single record with -n.
    void run();

  private:
    void run_file(const std::string& name);
    void run_stream(std::FILE* file);
    bool next_record(std::FILE* file);
    void write_record();
    double evaluate(cal::ExprId expression);
    double channel(int number);

    Settings settings_;
    Columns columns_;
    std::unique_ptr<TemplateReader> template_;
    std::optional<cal::ExprId> condition_;
    std::unique_ptr<RecordWriter> writer_;
    std::unique_ptr<cal::Evaluator> evaluator_;
    cal::Host host_;
    long record_ = 0;   ///< records read from this file
    long written_ = 0;  ///< records written for it
};

}  // namespace infra::rcalc
