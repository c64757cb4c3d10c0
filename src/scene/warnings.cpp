#include "scene/warnings.h"

#include <cstdio>

#include "common/error.h"

namespace infra {

WarningSink print_warnings(std::string program) {
    return [program = std::move(program)](std::string_view text) {
        std::fprintf(stderr, "%s: warning - %s\n", program.c_str(), message_line(text).c_str());
    };
}

WarningSink no_warnings() {
    return [](std::string_view) {};
}

}  // namespace infra
