#include "rt/functions/programmed_value.h"

#include <algorithm>
#include <array>

#include "common/format.h"
#include "rt/compile/data_cache.h"
#include "rt/compile/modifier_table.h"

namespace infra {
namespace {

constexpr std::size_t first_coordinate = 3;  // of the string arguments with data

std::shared_ptr<const DataTable> table_of(ModifierContext& context, ProgrammedValue::Kind kind) {
    if (kind == ProgrammedValue::Kind::function) return nullptr;
    auto table = shared_data(context, context.strings()[1]);
    const std::size_t needed = first_coordinate + table->dimensions();
    if (context.strings().size() < needed)
        throw context.error(
            formatted("%zu string arguments where at least %zu are needed", context.strings().size(), needed),
            formatted("the data file has %zu dimensions", table->dimensions()));
    return table;
}

}  // namespace

SourceArguments::SourceArguments(const FunctionCall& call, const Vec3& wi, double omega) {
    const Vec3 local = call.to_local(wi);
    values[0] = local.x;
    values[1] = local.y;
    values[2] = local.z;
    values[3] = omega;
}

ProgrammedValue::ProgrammedValue(ModifierContext& context, Kind kind)
    : table_(table_of(context, kind)), functions_(context, 0, 0, kind == Kind::data ? 2 : 1) {
    functions_.add_function(context, 0, table_ ? 5 : 4);
    for (std::size_t i = 0; table_ && i < table_->dimensions(); ++i)
        functions_.add_function(context, first_coordinate + i, 4);
}

bool ProgrammedValue::evaluate(Tracer& tracer, const Interaction& at, const MaterialVariables& variables,
                               const Vec3& wi, double omega, double& value) const {
    FunctionCall call(functions_, tracer, at, &variables);
    const SourceArguments source(call, wi, omega);
    if (!table_) {
        value = call.call(0, source.values);
        return call.ok();
    }
    std::array<double, DataTable::most_dimensions> place;
    for (std::size_t i = 0; i < table_->dimensions(); ++i) place[i] = call.call(1 + i, source.values);
    double arguments[5] = {table_->value(std::span(place).first(table_->dimensions()))};
    std::copy(std::begin(source.values), std::end(source.values), arguments + 1);
    value = call.call(0, arguments);
    return call.ok();
}

}  // namespace infra
