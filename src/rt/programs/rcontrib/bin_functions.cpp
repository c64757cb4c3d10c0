#include "rt/programs/rcontrib/bin_functions.h"

#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <tuple>

#include "cal/evaluator.h"
#include "cal/ray_library.h"
#include "common/error.h"
#include "common/format.h"

namespace infra {
namespace {

constexpr const char* context = "RC.";  // the definitions' (settings.cpp)
const Location bin_place{"-b option", 1, 1};
const Location count_place{"-bn option", 1, 1};

cal::Library make_library(std::span<const FunctionDefinition> definitions, const std::string& parameters) {
    cal::Library library = cal::make_ray_library();
    for (const FunctionDefinition& definition : definitions) add_definition(library, definition);
    for (const BinParameter& parameter : parse_parameters(parameters))
        library.define(formatted("%s = %.17g;", parameter.name.c_str(), parameter.value),
                       Location{"-p option", 1, 1}, context);
    return library;
}

int count_bins(const TrackedModifier& modifier, const std::vector<FunctionDefinition>& definitions) {
    if (modifier.bin_count.empty()) return 0;
    cal::Library library =
        make_library(std::span(definitions).first(modifier.count_definitions), modifier.count_parameters);
    const cal::ExprId expression = library.compile(modifier.bin_count, count_place, context);
    cal::Evaluator evaluator(library.link());
    const double count = evaluator.evaluate(expression, cal::Host{.owner = "-bn"}) + 0.5;
    const bool fits = count >= 0 && count < std::numeric_limits<int>::max();
    return fits ? static_cast<int>(count) : 0;
}

}  // namespace

BinFunctions::BinFunctions(const RcontribSettings& settings) {
    const std::vector<FunctionDefinition>& definitions = settings.render.definitions;
    std::map<std::string, int> known;  // parameters to libraries
    std::vector<cal::Library> libraries;
    std::map<std::tuple<std::string, std::string, std::size_t>, int> counts;
    for (const TrackedModifier& modifier : settings.modifiers) {
        const auto [library, is_new] =
            known.try_emplace(modifier.parameters, static_cast<int>(libraries.size()));
        if (is_new) libraries.push_back(make_library(definitions, modifier.parameters));
        cal::Library& functions = libraries[static_cast<std::size_t>(library->second)];
        if (const std::optional<double> bin = functions.constant(modifier.bin, bin_place, context)) {
            if (std::fabs(*bin) >= 0.5)
                throw Error("illegal non-zero constant for bin (" + modifier.bin + ")",
                            "an expression of Dx, Px and their kin tells bins apart");
            rules_.push_back({});
            continue;
        }
        const auto [count, is_unknown] = counts.try_emplace(
            {modifier.bin_count, modifier.count_parameters, modifier.count_definitions}, 0);
        if (is_unknown) count->second = count_bins(modifier, definitions);
        if (count->second <= 0)
            throw Error("unspecified or illegal bin count for modifier '" + modifier.name + "'",
                        "give -bn before -m");
        rules_.push_back(
            {count->second, library->second, functions.compile(modifier.bin, bin_place, context)});
    }
    for (const cal::Library& library : libraries) programs_.push_back(library.link());
}

}  // namespace infra
