#include "cal/library.h"

#include <deque>
#include <map>
#include <set>

#include "cal/code.h"
#include "cal/evaluator.h"
#include "cal/generator.h"
#include "cal/lowering.h"
#include "cal/parser.h"
#include "common/raypath.h"
#include "common/text_file.h"

namespace infra::cal {
namespace {

/// An expression or function wanted by the user.
struct Request {
    NodePtr node;
    bool is_function = false;
    std::uint32_t argument_count = 0;
};

Program build(const SymbolTable& symbols, const std::deque<Request>& requests) {
    Lowering lowering(symbols);
    std::vector<RootSource> roots;
    for (const Request& request : requests) {
        if (request.is_function)
            roots.push_back({true, lowering.entry_point(*request.node, request.argument_count)});
        else
            roots.push_back({false, lowering.expression(*request.node)});
    }
    lowering.finish_instances();
    return Program(std::make_shared<const Code>(Generator(lowering, std::move(roots)).generate()));
}

NodePtr copy(const Node& node) {
    auto twin = std::make_unique<Node>();
    twin->kind = node.kind;
    twin->number = node.number;
    twin->index = node.index;
    twin->where = node.where;
    twin->depth = node.depth;
    for (const NodePtr& child : node.children) twin->children.push_back(copy(*child));
    return twin;
}

/// What an expression of constants comes to; outside its domain it is an error here, and not 0.
double constant_value(const SymbolTable& symbols, const Node& node) {
    if (node.kind == Node::Kind::name && symbols[node.index].is_variable()) {
        const Node& body = *symbols[node.index].definition->body;
        if (body.is_number()) return body.number;
    }
    std::deque<Request> request(1);
    request.front().node = copy(node);
    Evaluator evaluator(build(symbols, request));
    const double value = evaluator.evaluate(ExprId{0}, Host{});
    if (evaluator.fault_count() > 0) throw Error("bad constant: " + evaluator.last_fault());
    return value;
}

std::string_view without_suffix(std::string_view name) {
    constexpr std::string_view suffix = ".cal";
    if (name.size() <= suffix.size()) return name;
    const std::string_view end = name.substr(name.size() - suffix.size());
    const bool matches =
        end[0] == '.' && (end[1] | 32) == 'c' && (end[2] | 32) == 'a' && (end[3] | 32) == 'l';
    return matches ? name.substr(0, name.size() - suffix.size()) : name;
}

}  // namespace

struct Library::State {
    explicit State(std::span<const Builtin> extra) : symbols(extra) {}

    Parser parser(std::string_view text, const Location& start, std::string_view context) {
        ConstantEvaluator evaluate;
        if (folding) evaluate = [this](const Node& node) { return constant_value(symbols, node); };
        return Parser(text, start, SymbolTable::context_path(context), symbols, std::move(evaluate));
    }

    ExprId queue(Request request) {
        requests.push_back(std::move(request));
        return ExprId{static_cast<std::uint32_t>(requests.size() - 1)};
    }

    SymbolTable symbols;
    std::deque<Request> requests;
    std::map<int, NodePtr> output_channels;
    std::set<std::string> loaded_contexts;
    bool folding = true;
    bool outputs_allowed = false;
};

Library::Library(std::span<const Builtin> extra) : state_(std::make_unique<State>(extra)) {}
Library::~Library() = default;
Library::Library(Library&&) noexcept = default;
Library& Library::operator=(Library&&) noexcept = default;

void Library::set_constant_folding(bool on) { state_->folding = on; }
void Library::allow_output_channels(bool on) { state_->outputs_allowed = on; }

void Library::define(std::string_view text, const Location& start, std::string_view context) {
    Parser parser = state_->parser(text, start, context);
    while (auto statement = parser.statement(state_->outputs_allowed)) {
        if (statement->output_channel)
            state_->output_channels[*statement->output_channel] = std::move(statement->definition.body);
        else
            state_->symbols[statement->symbol].definition = std::move(statement->definition);
    }
}

void Library::load_file(std::string_view name, const Location& where, std::string_view context) {
    std::string path;
    try {
        path = require_library_file(name, "function file");
    } catch (const Error& error) {
        if (where.file.empty()) throw;
        throw Error(where, error.message(), error.hint(), error.severity());
    }
    define(read_text_file(path), Location{path, 1, 1}, context);
}

std::string Library::load_function_file(std::string_view name, const Location& where) {
    if (name == ".") return {};
    std::string context(without_suffix(name));
    if (!state_->loaded_contexts.contains(SymbolTable::context_path(context))) {
        load_file(name, where, context);
        state_->loaded_contexts.insert(SymbolTable::context_path(context));
    }
    return context;
}

void Library::define_channel(std::string_view name, int number, std::string_view context) {
    const SymbolId symbol = state_->symbols.declare(name, SymbolTable::context_path(context));
    Definition definition;
    definition.body = make_leaf(Node::Kind::channel, static_cast<std::uint32_t>(number), {});
    state_->symbols[symbol].definition = std::move(definition);
}

bool Library::defines_variable(std::string_view name, std::string_view context) const {
    const auto symbol = state_->symbols.find(name, SymbolTable::context_path(context));
    return symbol && state_->symbols[*symbol].is_variable();
}

bool Library::mentions(std::string_view name, std::string_view context) const {
    return state_->symbols.find(name, SymbolTable::context_path(context)).has_value();
}

int Library::function_arity(std::string_view name, std::string_view context) const {
    return state_->symbols.arity(name, SymbolTable::context_path(context));
}

ExprId Library::compile(std::string_view text, const Location& start, std::string_view context) {
    Request request;
    request.node = state_->parser(text, start, context).expression();
    return state_->queue(std::move(request));
}

std::optional<double> Library::constant(std::string_view text, const Location& start,
                                        std::string_view context) {
    const NodePtr node = state_->parser(text, start, context).expression();
    if (!node->is_number()) return std::nullopt;
    return node->number;
}

ExprId Library::compile_function(std::string_view name, int argument_count, const Location& where,
                                 std::string_view context) {
    Request request;
    const SymbolId symbol = state_->symbols.refer(name, SymbolTable::context_path(context));
    request.node = make_leaf(Node::Kind::name, symbol, where);
    request.is_function = true;
    request.argument_count = static_cast<std::uint32_t>(argument_count);
    return state_->queue(std::move(request));
}

std::vector<std::pair<int, ExprId>> Library::compile_output_channels() {
    std::vector<std::pair<int, ExprId>> channels;
    for (const auto& [number, node] : state_->output_channels) {
        Request request;
        request.node = copy(*node);
        channels.emplace_back(number, state_->queue(std::move(request)));
    }
    return channels;
}

Program Library::link() const { return build(state_->symbols, state_->requests); }

}  // namespace infra::cal
