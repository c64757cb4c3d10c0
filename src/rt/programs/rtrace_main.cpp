#include "common/error.h"
#include "rt/programs/rtrace.h"

int main(int argc, char** argv) { return infra::run_program("rtrace", infra::rtrace, argc, argv); }
