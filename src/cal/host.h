// What an expression can see of the world while it is evaluated: channels ($1, $2, ...) and real arguments.
#pragma once

#include <span>
#include <string_view>

#include "common/error.h"

namespace infra::cal {

/// A cheap view that the caller fills for each evaluation. Everything it points to must outlive the call.
struct Host {
    const void* self = nullptr;  ///< handed back to `channel`
    double (*channel)(const void* self,
                      int number) = nullptr;  ///< value of $number; throws Error for an unknown one
    std::span<const double> reals;            ///< what arg(1), arg(2), ... give; arg(0) is their count
    std::string_view owner;                   ///< for errors, such as `brightfunc "sky"`
    const Location* where = nullptr;          ///< for errors: where the owner was defined

    /// Value of $number. throws Error where there are no channels at all, as in a constant.
    double channel_value(int number) const { return channel ? channel(self, number) : no_channel(number); }

    /// Error with this host's location, its message led by the owner.
    Error error(std::string_view message, std::string_view hint = {}) const;

  private:
    [[noreturn]] double no_channel(int number) const;
};

}  // namespace infra::cal
