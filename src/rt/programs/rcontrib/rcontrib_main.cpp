#include "common/error.h"
#include "rt/programs/rcontrib/rcontrib.h"

int main(int argc, char** argv) { return infra::run_program("rcontrib", infra::rcontrib, argc, argv); }
