#include "rt/functions/data_lookup.h"

#include "common/format.h"
#include "rt/compile/data_cache.h"
#include "rt/compile/modifier_table.h"

namespace infra {

DataValue::DataValue(ModifierContext& context, std::size_t first)
    : table_(shared_data(context, context.strings()[first + 1])),
      functions_(context, first + 3, table_->dimensions(), first + 2) {
    functions_.add_function(context, first, 1);
}

bool DataValue::evaluate(Tracer& tracer, const Interaction& at, double& value) const {
    std::array<double, DataTable::most_dimensions> place;
    FunctionCall call(functions_, tracer, at);
    call.expressions(place.data());
    value = call.call(0, table_->value(std::span(place).first(table_->dimensions())));
    return call.ok();
}

TripleFunctions::TripleFunctions(ModifierContext& context, FunctionSet& functions,
                                 TripleArguments arguments) {
    for (std::size_t i = 0; i < 3; ++i) {
        own_only_[i] = arguments == TripleArguments::all_or_own && i > 0 && functions.arity(context, i) < 3;
        functions.add_function(context, i, own_only_[i] ? 1 : 3);
    }
}

void TripleFunctions::apply(FunctionCall& call, const double* values, double* results) const {
    for (std::size_t i = 0; i < 3; ++i)
        results[i] = call.call(i, own_only_[i] ? std::span(values + i, 1) : std::span(values, 3));
}

DataTriple::DataTriple(ModifierContext& context, TripleArguments arguments)
    : tables_{shared_data(context, context.strings()[3]), shared_data(context, context.strings()[4]),
              shared_data(context, context.strings()[5])},
      functions_(context, 7, tables_[0]->dimensions(), 6),
      triple_(context, functions_, arguments) {
    for (std::size_t i = 1; i < 3; ++i)
        if (tables_[i]->dimensions() != tables_[0]->dimensions())
            throw context.error(formatted("data files of %zu and %zu dimensions", tables_[0]->dimensions(),
                                          tables_[i]->dimensions()),
                                "all three are looked up at the same place");
}

bool DataTriple::evaluate(Tracer& tracer, const Interaction& at, double* triple) const {
    std::array<double, DataTable::most_dimensions> place;
    FunctionCall call(functions_, tracer, at);
    call.expressions(place.data());
    const std::span<const double> point = std::span(place).first(tables_[0]->dimensions());
    double values[3];
    for (std::size_t i = 0; i < 3; ++i)
        values[i] = i > 0 && tables_[i] == tables_[0] ? values[0] : tables_[i]->value(point);
    triple_.apply(call, values, triple);
    return call.ok();
}

}  // namespace infra
