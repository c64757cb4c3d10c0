// The definitions of function files and strings while a scene is being loaded.
//
// Order of calls: construct (or make_ray_library), load and define, compile the expressions wanted, link
// once, then hand the Program to as many Evaluators as there are threads. Names are bound when text is read,
// so a definition may come after its use, and a later definition replaces an earlier one for every
// expression.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cal/builtin.h"
#include "cal/program.h"
#include "common/error.h"

namespace infra::cal {

class Library {
  public:
    /// Knows the functions every program has (if, select, sin, ...) and the `extra` ones.
    explicit Library(std::span<const Builtin> extra = {});
    ~Library();
    Library(Library&&) noexcept;
    Library& operator=(Library&&) noexcept;

    /// Reads the statements in `text`. `start` locates its first character: a file's name and line 1 column
    /// 1, say, or the line of the scene on which a string stands. `context` is "" for global or a name such
    /// as "sky".
    ///   throws  Error with file, line and column for bad syntax
    void define(std::string_view text, const Location& start, std::string_view context = {});

    /// Reads a file found through RAYPATH. throws Error if it is not found; `where` names what asked for it.
    void load_file(std::string_view name, const Location& where = {}, std::string_view context = {});

    /// What a primitive's function file argument means: loads the file at its first mention, into a context
    /// of its own, and returns that context. "." is no file and gives the global context "".
    std::string load_function_file(std::string_view name, const Location& where);

    /// Makes `name` stand for channel `number`, replacing any definition.
    void define_channel(std::string_view name, int number, std::string_view context = {});

    bool defines_variable(std::string_view name, std::string_view context = {}) const;

    /// Whether anything defines or mentions this name.
    bool mentions(std::string_view name, std::string_view context = {}) const;

    /// Number of arguments the function needs; 0 if there is no such function.
    int function_arity(std::string_view name, std::string_view context = {}) const;

    /// Queues an expression. throws Error for bad syntax. A name without a definition is an error only if the
    /// evaluation reaches it.
    ExprId compile(std::string_view text, const Location& start, std::string_view context = {});

    /// The value of an expression of nothing but constants; nothing if it is another. throws Error for bad
    /// syntax.
    std::optional<double> constant(std::string_view text, const Location& start,
                                   std::string_view context = {});

    /// Queues a function to be called by Evaluator::evaluate with `argument_count` arguments.
    ExprId compile_function(std::string_view name, int argument_count, const Location& where,
                            std::string_view context = {});

    /// Queues the right-hand sides of `$n = expression;` statements, in the order of n.
    std::vector<std::pair<int, ExprId>> compile_output_channels();

    /// Whether constants are worked out, and bad ones refused, when text is read (the default).
    void set_constant_folding(bool on);

    /// Whether `$n = ...` statements are allowed (off by default).
    void allow_output_channels(bool on);

    /// Compiles all that was queued. May be called again after more was queued; ids stay valid.
    Program link() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace infra::cal
