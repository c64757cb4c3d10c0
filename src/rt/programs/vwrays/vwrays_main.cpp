#include "common/error.h"
#include "rt/programs/vwrays/vwrays.h"

int main(int argc, char** argv) { return infra::run_program("vwrays", infra::vwrays, argc, argv); }
