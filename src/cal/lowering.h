// Turns syntax trees into one graph: variables and functions are replaced by what they stand for.
//
// A function that does not lead back to itself is inlined, so that its arguments become ordinary vertices.
// One that does becomes an instance: a body of its own with parameters, made once for each combination of
// functions that are passed to it as arguments.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "cal/graph.h"
#include "cal/symbols.h"
#include "common/error.h"

namespace infra::cal {

struct Instance {
    std::string name;
    VertexId body = 0;
    std::uint32_t parameter_count = 0;
};

class Lowering {
  public:
    explicit Lowering(const SymbolTable& symbols);

    VertexId expression(const Node& node);

    /// An instance with `argument_count` parameters that hands them all to a function.
    std::uint32_t entry_point(const Node& function, std::uint32_t argument_count);

    /// Lowers the bodies of the instances met so far. Call after the last expression.
    void finish_instances();

    const Graph& graph() const { return graph_; }
    const std::deque<Instance>& instances() const { return instances_; }
    const std::vector<Error>& errors() const { return errors_; }

  private:
    struct Scope;

    /// What a parameter stands for while a body is lowered.
    struct Binding {
        enum class Kind { vertex, expression, symbol, missing };
        Kind kind = Kind::missing;
        VertexId vertex = 0;
        const Node* node = nullptr;  ///< expression, symbol: where it was written
        Scope* scope = nullptr;      ///< expression: what its own parameters stand for
        SymbolId symbol = 0;
    };

    struct Scope {
        std::string function;  ///< for errors
        std::vector<Binding> bindings;
    };

    /// Work put off: an instance whose body is still to be lowered.
    struct Pending {
        std::uint32_t instance;
        SymbolId symbol;
        Scope scope;
    };

    VertexId lower(const Node& node, Scope* scope);
    VertexId lower_name(const Node& use, SymbolId symbol);
    VertexId lower_parameter(const Node& use, Scope& scope);
    VertexId lower_call(const Node& call, Scope* scope);
    VertexId lower_intrinsic(const Node& call, const Symbol& symbol, Scope* scope);
    VertexId lower_definition(const Node& call, SymbolId symbol, Scope* scope);
    VertexId instance_call(SymbolId symbol, Scope& callee);
    VertexId argument(const Node& call, std::size_t number, const Symbol& symbol, Scope* scope);
    Binding bind(const Node& argument, Scope* scope) const;
    VertexId value_of(Binding& binding, const Node& use, const std::string& function);
    bool is_recursive(SymbolId symbol);
    VertexId fail(const Location& where, std::string_view message, std::string_view hint = {});

    const SymbolTable& symbols_;
    Graph graph_;
    std::deque<Instance> instances_;
    std::map<std::vector<std::int64_t>, std::uint32_t> instance_index_;
    std::deque<Pending> pending_;
    std::vector<Error> errors_;
    std::unordered_map<SymbolId, std::optional<VertexId>> variables_;  ///< empty while being lowered
    std::unordered_map<SymbolId, bool> recursive_;
    int depth_ = 0;
    int inline_depth_ = 0;
    std::size_t steps_ = 0;         ///< tree nodes visited so far
    std::size_t inline_limit_ = 0;  ///< steps beyond which functions are no longer inlined
};

}  // namespace infra::cal
