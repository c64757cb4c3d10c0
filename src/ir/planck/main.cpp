// planck: radiance of a black surface from its temperature, in a band or through a response, and back.
#include <cstdio>
#include <string>

#include "common/error.h"
#include "common/format.h"
#include "common/text_file.h"
#include "ir/planck/arguments.h"
#include "ir/planck/columns.h"

namespace infra::ir {
namespace {

constexpr double ice_point = 273.15;  // K

double convert(const PlanckArguments& arguments, double value) {
    const double offset = arguments.celsius ? ice_point : 0.0;
    if (arguments.celsius && arguments.direction != Direction::temperature && !(value + offset > 0))
        throw Error(formatted("temperature %g degrees C is not above -273.15 degrees C", value));
    switch (arguments.direction) {
        case Direction::radiance:
            return arguments.scale->at(value + offset).radiance;
        case Direction::slope:
            return arguments.scale->at(value + offset).slope;
        case Direction::temperature:
            return arguments.scale->temperature(value) - offset;
    }
    throw Error("no such direction", {}, Severity::internal);
}

std::string results(const PlanckArguments& arguments) {
    const auto conversion = [&arguments](double value) { return convert(arguments, value); };
    if (arguments.values.empty())
        return convert_column(read_text_file("-"), arguments.column, conversion, "standard input");
    std::string text;
    for (const double value : arguments.values) text += formatted("%.9g\n", conversion(value));
    return text;
}

int run(int argc, char** argv) {
    const auto arguments = read_planck_arguments(argc, argv);
    if (!arguments) return 0;
    const std::string text = results(*arguments);  // whole before a byte of it is written
    std::fputs(text.c_str(), stdout);
    return 0;
}

}  // namespace
}  // namespace infra::ir

int main(int argc, char** argv) { return infra::run_program("planck", infra::ir::run, argc, argv); }
