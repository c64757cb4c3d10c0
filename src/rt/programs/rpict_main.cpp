#include "common/error.h"
#include "rt/programs/rpict.h"

int main(int argc, char** argv) { return infra::run_program("rpict", infra::rpict, argc, argv); }
