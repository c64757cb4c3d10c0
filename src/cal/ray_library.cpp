#include "cal/ray_library.h"

namespace infra::cal {

Library make_ray_library() {
    Library library(ray_builtins());
    library.load_file("rayinit.cal");
    return library;
}

}  // namespace infra::cal
