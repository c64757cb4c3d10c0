// xform: scene descriptions in, the same moved, turned, scaled, mirrored, repeated out.
#include "common/error.h"
#include "scene/xform/run.h"

namespace {

int xform(int argc, char** argv) {
    infra::xform::run({argv, argv + argc}, stdout);
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return infra::run_program("xform", xform, argc, argv); }
