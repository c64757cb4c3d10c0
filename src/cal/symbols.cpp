#include "cal/symbols.h"

#include <tuple>

#include "cal/lexer.h"

namespace infra::cal {
namespace {

constexpr char context_mark = '`';

/// The qualified names that a use of `name` may mean, innermost first; a definition takes the first.
std::vector<std::string> candidates(std::string_view name, std::string_view context) {
    const bool local_only = name.starts_with(context_mark);
    if (local_only) name.remove_prefix(1);
    if (name.ends_with(context_mark)) return {std::string(name.substr(0, name.size() - 1))};
    std::vector<std::string> names{std::string(name).append(context)};
    while (!local_only && !context.empty()) {
        const std::size_t parent = context.find(context_mark, 1);
        context = parent == std::string_view::npos ? std::string_view{} : context.substr(parent);
        names.push_back(std::string(name).append(context));
    }
    return names;
}

std::pair<Intrinsic, std::uint32_t> intrinsic_of(std::string_view name, std::span<const Builtin> builtins) {
    if (name == "if") return {Intrinsic::if_positive, 0};
    if (name == "select") return {Intrinsic::select, 0};
    if (name == "min") return {Intrinsic::minimum, 0};
    if (name == "max") return {Intrinsic::maximum, 0};
    for (std::uint32_t i = 0; i < builtins.size(); ++i)
        if (name == builtins[i].name) return {Intrinsic::builtin, i};
    return {Intrinsic::none, 0};
}

}  // namespace

SymbolTable::SymbolTable(std::span<const Builtin> extra) {
    const auto core = core_builtins();
    builtins_.assign(core.begin(), core.end());
    builtins_.insert(builtins_.end(), extra.begin(), extra.end());
}

std::string SymbolTable::context_path(std::string_view name) {
    while (name.starts_with(context_mark)) name.remove_prefix(1);
    while (name.ends_with(context_mark)) name.remove_suffix(1);
    if (name.empty()) return {};
    std::string path(1, context_mark);
    for (const char c : name) path += is_name_character(c) ? c : '_';
    return path;
}

SymbolId SymbolTable::insert(std::string name, std::string_view unqualified) {
    const auto id = static_cast<SymbolId>(symbols_.size());
    Symbol symbol;
    symbol.name = std::move(name);
    std::tie(symbol.intrinsic, symbol.builtin) = intrinsic_of(unqualified, builtins_);
    index_.emplace(symbol.name, id);
    symbols_.push_back(std::move(symbol));
    return id;
}

std::optional<SymbolId> SymbolTable::find(std::string_view name, std::string_view context) const {
    for (const std::string& candidate : candidates(name, context))
        if (const auto found = index_.find(candidate); found != index_.end()) return found->second;
    return {};
}

SymbolId SymbolTable::refer(std::string_view name, std::string_view context) {
    if (const auto known = find(name, context)) return *known;
    const bool intrinsic = intrinsic_of(name, builtins_).first != Intrinsic::none;
    std::string qualified = intrinsic ? std::string(name) : candidates(name, context).front();
    return insert(qualified, qualified);
}

SymbolId SymbolTable::declare(std::string_view name, std::string_view context) {
    std::string qualified = candidates(name, context).front();
    if (const auto found = index_.find(qualified); found != index_.end()) return found->second;
    return insert(qualified, qualified);
}

int SymbolTable::arity(std::string_view name, std::string_view context) const {
    Symbol unmentioned;
    std::tie(unmentioned.intrinsic, unmentioned.builtin) = intrinsic_of(name, builtins_);
    const auto known = find(name, context);
    const Symbol& symbol = known ? symbols_[*known] : unmentioned;
    return symbol.is_function() ? static_cast<int>(symbol.definition->parameters.size())
                                : intrinsic_arity(symbol);
}

int SymbolTable::intrinsic_arity(const Symbol& symbol) const {
    switch (symbol.intrinsic) {
        case Intrinsic::none:
            return 0;
        case Intrinsic::if_positive:
            return 3;
        case Intrinsic::builtin:
            return builtins_[symbol.builtin].arity;
        default:
            return 1;
    }
}

std::string SymbolTable::spelling_hint(std::string_view qualified, bool as_function) const {
    std::vector<std::string_view> known;
    for (const Symbol& symbol : symbols_) {
        const bool meant = as_function ? symbol.is_function() : symbol.is_variable();
        if (meant && symbol.name != qualified) known.push_back(symbol.name);
    }
    if (as_function) {
        known.insert(known.end(), {"if", "select", "min", "max"});
        for (const Builtin& builtin : builtins_) known.push_back(builtin.name);
    }
    const std::string nearest = nearest_name(qualified, known);
    return nearest.empty() ? "" : "did you mean \"" + nearest + "\"?";
}

}  // namespace infra::cal
