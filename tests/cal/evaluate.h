// Short ways to evaluate expressions in tests.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cal/evaluator.h"
#include "cal/library.h"
#include "cal/ray_library.h"

namespace infra::cal {

inline const Location test_text{"test.cal", 1, 1};

/// Value of an expression after definitions, with the functions that every program has.
inline double value_of(std::string_view expression, std::string_view definitions = {}) {
    Library library;
    library.define(definitions, test_text);
    const ExprId id = library.compile(expression, test_text);
    return Evaluator(library.link()).evaluate(id, Host{});
}

/// What an evaluation says is wrong, "" if nothing is.
inline std::string error_of(std::string_view expression, std::string_view definitions = {}) {
    try {
        value_of(expression, definitions);
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

/// A host whose channel n has the value values[n], and which counts the questions.
struct CountingHost {
    explicit CountingHost(std::vector<double> channel_values) : values(std::move(channel_values)) {
        host.self = this;
        host.channel = [](const void* self, int number) {
            const auto& world = *static_cast<const CountingHost*>(self);
            ++world.questions;
            return world.values.at(static_cast<std::size_t>(number));
        };
    }
    CountingHost(const CountingHost&) = delete;

    std::vector<double> values;
    mutable int questions = 0;
    Host host;
};

}  // namespace infra::cal
