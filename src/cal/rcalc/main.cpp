// rcalc: transforms records of numbers and text by expressions.
#include "calculator.h"
#include "common/error.h"

namespace {

int run(int argc, char** argv) {
    infra::rcalc::Settings settings;
    if (infra::rcalc::read_command_line(argc, argv, settings))
        infra::rcalc::Calculator(std::move(settings)).run();
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return infra::run_program("rcalc", run, argc, argv); }
