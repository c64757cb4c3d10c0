#include "cal/host.h"

namespace infra::cal {

Error Host::error(std::string_view message, std::string_view hint) const {
    std::string text;
    if (!owner.empty()) text.append(owner).append(": ");
    text.append(message);
    return Error(where ? *where : Location{}, text, hint);
}

double Host::no_channel(int number) const {
    throw error("channel $" + std::to_string(number) + " used in a constant expression",
                "define it with '=', not ':'");
}

}  // namespace infra::cal
