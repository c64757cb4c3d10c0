#include "cal/lowering.h"

#include <set>

namespace infra::cal {
namespace {

using Kind = Node::Kind;

constexpr int max_depth = 3000;        // of this recursion, so that no input exhausts the stack
constexpr int max_inline_depth = 100;  // functions within functions; a function given itself would not end
constexpr std::size_t inline_budget = 50000;  // tree nodes that one expression may come to by inlining

/// Operations that have a code of their own; other built-in functions are called through their pointer.
std::optional<Op> operation_of(std::string_view builtin) {
    if (builtin == "arg") return Op::argument;
    if (builtin == "sqrt") return Op::square_root;
    if (builtin == "floor") return Op::floor;
    if (builtin == "ceil") return Op::ceiling;
    if (builtin == "sin") return Op::sine;
    if (builtin == "cos") return Op::cosine;
    if (builtin == "acos") return Op::arc_cosine;
    if (builtin == "atan2") return Op::arc_tangent2;
    return {};
}

Op operation_of(Kind kind) {
    switch (kind) {
        case Kind::add:
            return Op::add;
        case Kind::subtract:
            return Op::subtract;
        case Kind::multiply:
            return Op::multiply;
        case Kind::divide:
            return Op::divide;
        default:
            return Op::power;
    }
}

std::string quoted(std::string_view name) { return std::string("\"").append(name).append("\""); }

void collect_names(const Node& node, std::vector<SymbolId>& names) {
    if (node.kind == Kind::name) names.push_back(node.index);
    for (const NodePtr& child : node.children) collect_names(*child, names);
}

}  // namespace

Lowering::Lowering(const SymbolTable& symbols) : symbols_(symbols), graph_(symbols.builtins()) {}

VertexId Lowering::fail(const Location& where, std::string_view message, std::string_view hint) {
    errors_.emplace_back(where, message, hint);
    return graph_.make(Op::fail, {}, static_cast<std::uint32_t>(errors_.size() - 1));
}

VertexId Lowering::expression(const Node& node) {
    inline_limit_ = steps_ + inline_budget;
    return lower(node, nullptr);
}

std::uint32_t Lowering::entry_point(const Node& function, std::uint32_t argument_count) {
    inline_limit_ = steps_ + inline_budget;
    const auto id = static_cast<std::uint32_t>(instances_.size());
    instances_.push_back({symbols_[function.index].name, 0, argument_count});
    Node call;
    call.kind = Kind::call;
    call.where = function.where;
    add_child(call, make_leaf(Kind::name, function.index, function.where));
    Scope scope{instances_[id].name, {}};
    for (std::uint32_t i = 0; i < argument_count; ++i) {
        add_child(call, make_leaf(Kind::parameter, i, function.where));
        scope.bindings.push_back({Binding::Kind::vertex, graph_.parameter(id, i), &function, nullptr, 0});
    }
    const VertexId body = lower_call(call, &scope);
    instances_[id].body = body;
    return id;
}

void Lowering::finish_instances() {
    while (!pending_.empty()) {
        Pending work = std::move(pending_.front());
        pending_.pop_front();
        inline_limit_ = steps_ + inline_budget;
        const VertexId body = lower(*symbols_[work.symbol].definition->body, &work.scope);
        instances_[work.instance].body = body;
    }
}

VertexId Lowering::lower(const Node& node, Scope* scope) {
    if (++depth_ > max_depth) throw Error(node.where, "definitions refer to each other too deeply");
    ++steps_;
    VertexId result = 0;
    switch (node.kind) {
        case Kind::number:
            result = graph_.constant(node.number);
            break;
        case Kind::channel:
            result = graph_.make(Op::channel, {}, node.index);
            break;
        case Kind::parameter:
            result = lower_parameter(node, *scope);
            break;
        case Kind::name:
            result = lower_name(node, node.index);
            break;
        case Kind::call:
            result = lower_call(node, scope);
            break;
        case Kind::negate:
            result = graph_.make(Op::negate, {lower(*node.children[0], scope)});
            break;
        default: {
            const VertexId left = lower(*node.children[0], scope);
            result = graph_.make(operation_of(node.kind), {left, lower(*node.children[1], scope)});
        }
    }
    --depth_;
    return result;
}

VertexId Lowering::lower_name(const Node& use, SymbolId id) {
    const Symbol& symbol = symbols_[id];
    if (!symbol.is_variable()) {
        const bool function = symbol.is_function() || symbol.intrinsic != Intrinsic::none;
        if (function) return fail(use.where, quoted(symbol.name) + " is a function and needs arguments here");
        return fail(use.where, "undefined variable " + quoted(symbol.name),
                    symbols_.spelling_hint(symbol.name, false));
    }
    if (const auto known = variables_.find(id); known != variables_.end()) {
        if (known->second) return *known->second;
        return fail(use.where, "variable " + quoted(symbol.name) + " depends on itself");
    }
    variables_[id] = std::nullopt;
    const VertexId value = lower(*symbol.definition->body, nullptr);
    variables_[id] = value;
    return value;
}

VertexId Lowering::lower_parameter(const Node& use, Scope& scope) {
    return value_of(scope.bindings[use.index], use, scope.function);
}

VertexId Lowering::value_of(Binding& binding, const Node& use, const std::string& function) {
    switch (binding.kind) {
        case Binding::Kind::vertex:
            return binding.vertex;
        case Binding::Kind::symbol:
            return lower_name(*binding.node, binding.symbol);
        case Binding::Kind::missing:
            return fail(use.where, function + "(): too few arguments");
        case Binding::Kind::expression:
            break;
    }
    const Node& node = *binding.node;
    Scope* const outer = binding.scope;
    const VertexId vertex = lower(node, outer);
    binding.kind = Binding::Kind::vertex;
    binding.vertex = vertex;
    return vertex;
}

Lowering::Binding Lowering::bind(const Node& argument, Scope* scope) const {
    if (argument.kind == Kind::parameter) return scope->bindings[argument.index];
    Binding binding;
    binding.kind = argument.kind == Kind::name ? Binding::Kind::symbol : Binding::Kind::expression;
    binding.node = &argument;
    binding.scope = scope;
    binding.symbol = argument.index;
    return binding;
}

VertexId Lowering::lower_call(const Node& call, Scope* scope) {
    const Node& callee = *call.children.front();
    SymbolId id = callee.index;
    if (callee.kind == Kind::parameter) {
        const Binding& binding = scope->bindings[callee.index];
        if (binding.kind == Binding::Kind::missing)
            return fail(callee.where, scope->function + "(): too few arguments");
        if (binding.kind != Binding::Kind::symbol)
            return fail(callee.where, scope->function + "(): argument " + std::to_string(callee.index + 1) +
                                          " is not a function");
        id = binding.symbol;
    }
    const Symbol& symbol = symbols_[id];
    if (symbol.is_function()) return lower_definition(call, id, scope);
    if (symbol.intrinsic != Intrinsic::none) return lower_intrinsic(call, symbol, scope);
    return fail(callee.where, "undefined function " + quoted(symbol.name),
                symbols_.spelling_hint(symbol.name, true));
}

VertexId Lowering::argument(const Node& call, std::size_t number, const Symbol& symbol, Scope* scope) {
    if (number < call.children.size()) return lower(*call.children[number], scope);
    return fail(call.where, symbol.name + "(): too few arguments");
}

VertexId Lowering::lower_intrinsic(const Node& call, const Symbol& symbol, Scope* scope) {
    std::size_t count = call.children.size() - 1;
    if (symbol.intrinsic == Intrinsic::if_positive || symbol.intrinsic == Intrinsic::builtin)
        count = static_cast<std::size_t>(symbols_.intrinsic_arity(symbol));
    std::vector<VertexId> inputs;
    for (std::size_t i = 1; i <= count; ++i) inputs.push_back(argument(call, i, symbol, scope));
    switch (symbol.intrinsic) {
        case Intrinsic::if_positive:
            return graph_.make(Op::if_positive, std::move(inputs));
        case Intrinsic::select:
            return graph_.make(Op::select, std::move(inputs));
        case Intrinsic::minimum:
        case Intrinsic::maximum: {
            const Op op = symbol.intrinsic == Intrinsic::minimum ? Op::minimum : Op::maximum;
            VertexId extreme = inputs.front();
            for (std::size_t i = inputs.size(); --i > 0;) extreme = graph_.make(op, {extreme, inputs[i]});
            return extreme;
        }
        default:
            break;
    }
    if (const auto op = operation_of(symbols_.builtins()[symbol.builtin].name))
        return graph_.make(*op, std::move(inputs));
    return graph_.make(Op::builtin, std::move(inputs), symbol.builtin);
}

VertexId Lowering::lower_definition(const Node& call, SymbolId id, Scope* scope) {
    const Definition& definition = *symbols_[id].definition;
    Scope callee{symbols_[id].name, {}};
    for (std::size_t i = 0; i < definition.parameters.size(); ++i)
        callee.bindings.push_back(i + 1 < call.children.size() ? bind(*call.children[i + 1], scope)
                                                               : Binding{});
    const bool inlined = !is_recursive(id) && inline_depth_ < max_inline_depth && steps_ < inline_limit_;
    if (!inlined) return instance_call(id, callee);
    ++inline_depth_;
    const VertexId result = lower(*definition.body, &callee);
    --inline_depth_;
    return result;
}

// An argument that names a function is built into the instance; one that has a value is passed.
VertexId Lowering::instance_call(SymbolId id, Scope& callee) {
    enum : std::int64_t { passed = -1, missing = -2 };
    std::vector<std::int64_t> key{id};
    std::vector<VertexId> values;
    for (std::size_t i = 0; i < callee.bindings.size(); ++i) {
        Binding& binding = callee.bindings[i];
        if (binding.kind == Binding::Kind::missing) {
            key.push_back(missing);
        } else if (binding.kind == Binding::Kind::symbol && !symbols_[binding.symbol].is_variable()) {
            key.push_back(binding.symbol);
        } else {
            key.push_back(passed);
            values.push_back(value_of(binding, *binding.node, callee.function));
        }
    }
    const auto [found, is_new] =
        instance_index_.try_emplace(key, static_cast<std::uint32_t>(instances_.size()));
    const std::uint32_t instance = found->second;
    if (is_new) {
        instances_.push_back({callee.function, 0, static_cast<std::uint32_t>(values.size())});
        Scope scope{callee.function, {}};
        std::uint32_t parameter = 0;
        for (std::size_t i = 0; i < callee.bindings.size(); ++i) {
            Binding inside = callee.bindings[i];
            if (key[i + 1] == passed) {
                inside.kind = Binding::Kind::vertex;
                inside.vertex = graph_.parameter(instance, parameter++);
            }
            scope.bindings.push_back(inside);
        }
        pending_.push_back({instance, id, std::move(scope)});
    }
    return graph_.make(Op::call, std::move(values), instance);
}

bool Lowering::is_recursive(SymbolId id) {
    if (const auto known = recursive_.find(id); known != recursive_.end()) return known->second;
    std::vector<SymbolId> open{id};
    std::set<SymbolId> seen;
    bool found = false;
    while (!open.empty() && !found) {
        const SymbolId next = open.back();
        open.pop_back();
        if (!symbols_[next].definition) continue;
        std::vector<SymbolId> names;
        collect_names(*symbols_[next].definition->body, names);
        for (const SymbolId name : names) {
            found = found || name == id;
            if (seen.insert(name).second) open.push_back(name);
        }
    }
    return recursive_[id] = found;
}

}  // namespace infra::cal
