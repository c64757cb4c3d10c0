#include "scene/warnings.h"

#include <cstdio>

namespace infra {

WarningSink print_warnings(std::string program) {
    return [program = std::move(program)](std::string_view text) {
        std::fprintf(stderr, "%s: warning - %.*s\n", program.c_str(), int(text.size()), text.data());
    };
}

WarningSink no_warnings() {
    return [](std::string_view) {};
}

}  // namespace infra
