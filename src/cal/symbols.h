// The names of a Library, each qualified by its context, and what they stand for.
//
// A context is a path such as "`sky`day"; the name x in it is stored as "x`sky`day". A use of x means the
// innermost of x`sky`day, x`day and x that is known when the use is read. `x means x of the current context
// alone, x` the global one.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cal/builtin.h"
#include "cal/syntax.h"

namespace infra::cal {

/// What calling a name does when no definition hides it.
enum class Intrinsic { none, if_positive, select, minimum, maximum, builtin };

struct Symbol {
    std::string name;  ///< qualified
    Intrinsic intrinsic = Intrinsic::none;
    std::uint32_t builtin = 0;  ///< index among the builtins, if that is what it is
    std::optional<Definition> definition;

    bool is_variable() const { return definition && !definition->is_function; }
    bool is_function() const { return definition && definition->is_function; }
};

class SymbolTable {
  public:
    explicit SymbolTable(std::span<const Builtin> extra);

    /// Context path for a context's name: one leading back-quote, odd characters replaced by '_'.
    static std::string context_path(std::string_view name);

    /// Symbol that a use of `name` means, made if it is new.
    SymbolId refer(std::string_view name, std::string_view context);

    /// The same without making one.
    std::optional<SymbolId> find(std::string_view name, std::string_view context) const;

    /// Symbol that a definition of `name` sets.
    SymbolId declare(std::string_view name, std::string_view context);

    Symbol& operator[](SymbolId id) { return symbols_[id]; }
    const Symbol& operator[](SymbolId id) const { return symbols_[id]; }
    const std::vector<Builtin>& builtins() const { return builtins_; }

    /// Arguments that calling `name` needs, 0 if it is no function.
    int arity(std::string_view name, std::string_view context) const;

    /// Arguments the intrinsic of a symbol needs.
    int intrinsic_arity(const Symbol& symbol) const;

    /// The nearest name with a meaning as "did you mean ..?", or "".
    std::string spelling_hint(std::string_view qualified, bool as_function) const;

  private:
    SymbolId insert(std::string name, std::string_view unqualified);

    std::vector<Builtin> builtins_;
    std::deque<Symbol> symbols_;  // a deque, so that references stay good while symbols are added
    std::map<std::string, SymbolId, std::less<>> index_;
};

}  // namespace infra::cal
