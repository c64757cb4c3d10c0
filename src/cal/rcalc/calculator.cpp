#include "calculator.h"

#include <cstring>

#include "common/error.h"

namespace infra::rcalc {

Calculator::Calculator(Settings settings) : settings_(std::move(settings)), columns_(settings_) {
    cal::Library& library = settings_.library;
    if (settings_.input_format && !settings_.no_input) {
        template_ = std::make_unique<TemplateReader>(settings_);
        const auto& names = template_->number_names();
        for (std::size_t i = 0; i < names.size(); ++i)
            library.define_channel(names[i], first_field_channel + static_cast<int>(i));
    }
    if (!settings_.no_input && library.defines_variable("cond"))
        condition_ = library.compile("cond", Location{"cond"});
    if (!settings_.no_input && library.mentions("recno"))
        library.define_channel("recno", record_number_channel);
    if (!settings_.no_input && library.mentions("outno"))
        library.define_channel("outno", output_number_channel);
    writer_ = std::make_unique<RecordWriter>(settings_, library.compile_output_channels());
    evaluator_ = std::make_unique<cal::Evaluator>(library.link());
    host_.self = this;
    host_.channel = [](const void* self, int number) {
        return const_cast<Calculator*>(static_cast<const Calculator*>(self))->channel(number);
    };
}

double Calculator::channel(int number) {
    if (number == record_number_channel) return static_cast<double>(record_);
    if (number == output_number_channel) return static_cast<double>(written_ + 1);
    const bool no_columns = settings_.no_input || template_;
    if (number == column_count_channel) return no_columns ? 0 : static_cast<double>(columns_.count());
    if (number >= first_field_channel)
        return template_->number(static_cast<std::size_t>(number - first_field_channel));
    if (no_columns)
        throw Error(
            "there are no input columns, but $" + std::to_string(number) + " is used",
            settings_.no_input ? "option -n reads no input" : "the input format gives its fields names");
    if (number < 1) throw Error("columns are numbered from $1, not $" + std::to_string(number));
    return columns_.value(number);
}

double Calculator::evaluate(cal::ExprId expression) {
    const auto faults = evaluator_->fault_count();
    const double value = evaluator_->evaluate(expression, host_);
    if (evaluator_->fault_count() > faults && !settings_.quiet) {
        std::fprintf(stderr, "rcalc: warning: %s", evaluator_->last_fault().c_str());
        if (record_ > 0) std::fprintf(stderr, " in record %ld", record_);
        std::fputc('\n', stderr);
    }
    return value;
}

void Calculator::write_record() {
    const Strings& strings = template_ ? template_->strings() : settings_.presets;
    writer_->write([this](cal::ExprId expression) { return evaluate(expression); }, strings);
}

void Calculator::run() {
    if (settings_.no_input) {
        write_record();
    } else if (settings_.files.empty()) {
        run_stream(stdin);
    } else {
        for (const std::string& name : settings_.files) run_file(name);
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
        throw Error("cannot write the standard output", std::strerror(errno), Severity::system);
}

void Calculator::run_file(const std::string& name) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.c_str(), "rb"), std::fclose);
    if (!file) throw Error(Location{name}, "cannot open", std::strerror(errno));
    run_stream(file.get());
}

bool Calculator::next_record(std::FILE* file) { return template_ ? template_->read() : columns_.read(file); }

void Calculator::run_stream(std::FILE* file) {
    record_ = written_ = 0;
    if (template_) template_->open(file);
    while (next_record(file)) {
        ++record_;
        evaluator_->next_clock();
        const bool wanted = !condition_ || evaluate(*condition_) > 0;
        if (template_) template_->leave_record(!wanted);
        if (wanted) {
            write_record();
            ++written_;
        }
        if (settings_.input_limit > 0 && record_ >= settings_.input_limit) break;
        if (settings_.output_limit > 0 && written_ >= settings_.output_limit) break;
    }
}

}  // namespace infra::rcalc
