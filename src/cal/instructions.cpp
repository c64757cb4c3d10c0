// One function for each opcode.
//
// Each does its work and calls the function of the next instruction as its last act, which compiles to a
// jump: there is no loop and no switch, and the processor predicts the jump behind each kind of instruction
// by itself. The value just computed travels along in a floating-point register, so that a chain of
// instructions does not wait for memory.
#include <array>
#include <cmath>
#include <limits>

#include "cal/graph.h"
#include "cal/machine.h"

namespace infra::cal {
namespace {

bool is_finite(double value) { return std::abs(value) <= std::numeric_limits<double>::max(); }

double next(const Instruction* i, double* r, Machine& m, double last) {
    return i[1].execute(i + 1, r, m, last);
}

double jump_to(std::uint32_t target, double* r, Machine& m, double last) {
    const Instruction* const i = m.code.instructions.data() + target;
    return i->execute(i, r, m, last);
}

double store(double value, const Instruction* i, double* r, Machine& m) {
    r[i->dst] = value;
    return next(i, r, m, value);
}

double store_checked(double value, const Instruction* i, double* r, Machine& m) {
    if (!is_finite(value)) [[unlikely]]
        value = m.domain_fault(*i);
    return store(value, i, r, m);
}

// Arithmetic, from an operation and the number of the operand that is the last value.

template <auto operation, int from_last, bool check = false>
double unary(const Instruction* i, double* r, Machine& m, double last) {
    const double value = operation(from_last == 1 ? last : r[i->a]);
    return check ? store_checked(value, i, r, m) : store(value, i, r, m);
}

template <auto operation, int from_last, bool check = false>
double binary(const Instruction* i, double* r, Machine& m, double last) {
    const double value = operation(from_last == 1 ? last : r[i->a], from_last == 2 ? last : r[i->b]);
    return check ? store_checked(value, i, r, m) : store(value, i, r, m);
}

template <auto operation, int from_last>
double ternary(const Instruction* i, double* r, Machine& m, double last) {
    const double a = from_last == 1 ? last : r[i->a];
    const double b = from_last == 2 ? last : r[i->b];
    return store(operation(a, b, from_last == 3 ? last : r[i->c]), i, r, m);
}

template <int from_last>
double divide(const Instruction* i, double* r, Machine& m, double last) {
    const double a = from_last == 1 ? last : r[i->a];
    const double b = from_last == 2 ? last : r[i->b];
    return store(b != 0 ? a / b : m.domain_fault(*i), i, r, m);
}

constexpr auto negated = [](double a) { return -a; };
constexpr auto same = [](double a) { return a; };
constexpr auto sum = [](double a, double b) { return a + b; };
constexpr auto difference = [](double a, double b) { return a - b; };
constexpr auto product = [](double a, double b) { return a * b; };
constexpr auto power = [](double a, double b) { return std::pow(a, b); };
constexpr auto clamped = [](double x, double low, double high) { return larger(smaller(x, high), low); };
constexpr auto product_sum = [](double a, double b, double c) { return a * b + c; };
constexpr auto interpolated = [](double t, double a, double b) { return (1 - t) * a + t * b; };
constexpr auto chosen = [](double condition, double yes, double no) { return condition > 0 ? yes : no; };
constexpr auto square_root = [](double a) { return std::sqrt(a); };
constexpr auto ceiling = [](double a) { return std::ceil(a); };
constexpr auto sine = [](double a) { return std::sin(a); };
constexpr auto cosine = [](double a) { return std::cos(a); };
constexpr auto arc_cosine = [](double a) { return std::acos(a); };
constexpr auto arc_cosine_clamped = [](double a) { return std::acos(clamped(a, -1, 1)); };
constexpr auto arc_tangent2 = [](double y, double x) { return std::atan2(y, x); };
constexpr auto arc_tangent2_or_zero = [](double y, double x) {
    return x * x + y * y > 0 ? std::atan2(y, x) : 0;
};

// Without SSE 4.1 std::floor is a call; the numbers that fit an integer are most.
constexpr auto floored = [](double a) {
    constexpr double limit = 1e15;
    if (!(std::abs(a) < limit)) return std::floor(a);
    const auto truncated = static_cast<double>(static_cast<long long>(a));
    return truncated - (truncated > a ? 1. : 0.);
};

// What reaches outside: the host, other code, errors.

double channel(const Instruction* i, double* r, Machine& m, double) {
    return store(m.host.channel_value(static_cast<int>(i->data)), i, r, m);
}

template <int from_last>
double argument(const Instruction* i, double* r, Machine& m, double last) {
    return store(m.real_argument(from_last == 1 ? last : r[i->a]), i, r, m);
}

double argument_constant(const Instruction* i, double* r, Machine& m, double) {
    return store(m.real_argument(i->data + 1.), i, r, m);
}

double argument_affine(const Instruction* i, double* r, Machine& m, double) {
    const double* const k = r + i->c;
    return store(m.real_argument(k[0] + k[1] * r[i->a] + k[2] * r[i->b]), i, r, m);
}

double interpolate_arguments(const Instruction* i, double* r, Machine& m, double) {
    const double* const k = r + i->c;
    const double offset = k[1] * r[i->a] + k[2] * r[i->b];
    return store(interpolated(r[i->data], m.real_argument(k[0] + offset), m.real_argument(k[3] + offset)), i,
                 r, m);
}

double builtin(const Instruction* i, double* r, Machine& m, double) {
    const Builtin& function = m.code.builtins[i->data];
    const double value = function.call(r + i->a, m.host);
    return store(is_finite(value) ? value : m.fault(function.name), i, r, m);
}

double jump(const Instruction* i, double* r, Machine& m, double last) { return jump_to(i->data, r, m, last); }

template <int from_last>
double jump_unless_positive(const Instruction* i, double* r, Machine& m, double last) {
    if ((from_last == 1 ? last : r[i->a]) > 0) return next(i, r, m, last);
    return jump_to(i->data, r, m, last);
}

template <int from_last>
double jump_unless_greater(const Instruction* i, double* r, Machine& m, double last) {
    if ((from_last == 1 ? last : r[i->a]) > (from_last == 2 ? last : r[i->b])) return next(i, r, m, last);
    return jump_to(i->data, r, m, last);
}

double jump_selected(const Instruction* i, double* r, Machine& m, double last) {
    const std::uint32_t* const table = m.code.jump_tables.data() + i->data;
    const int choice = selected(r[i->a], static_cast<int>(table[0]));
    if (choice < 0) m.domain_fault(*i);
    return jump_to(table[choice + 2], r, m, last);
}

double load_cell(const Instruction* i, double* r, Machine& m, double) {
    return store(m.cell(i->data), i, r, m);
}

double call(const Instruction* i, double* r, Machine& m, double) {
    return store(m.run_instance(i->data, r + i->a), i, r, m);
}

double delay(const Instruction* i, double* r, Machine& m, double last) {
    r[i->dst + 1] = i->data;
    r[i->dst + 2] = static_cast<double>(r - m.registers);
    return next(i, r, m, last);
}

double force(const Instruction* i, double* r, Machine& m, double last) {
    if (r[i->a + 1] != 0) m.force(r + i->a);
    return next(i, r, m, last);
}

template <int from_last>
double finish(const Instruction* i, double* r, Machine&, double last) {
    return from_last == 1 ? last : r[i->a];
}

double fail(const Instruction* i, double*, Machine& m, double) { throw m.code.errors[i->data]; }

/// The functions of an opcode, by the operand that is the last value; null where that has no function of its
/// own.
using Variants = std::array<Execute, 4>;

template <auto operation, bool check = false>
constexpr Variants unaries{unary<operation, 0, check>, unary<operation, 1, check>};
template <auto operation, bool check = false>
constexpr Variants binaries{binary<operation, 0, check>, binary<operation, 1, check>,
                            binary<operation, 2, check>};
template <auto operation>
constexpr Variants ternaries{ternary<operation, 0>, ternary<operation, 1>, ternary<operation, 2>,
                             ternary<operation, 3>};

Variants variants(Opcode opcode) {
    switch (opcode) {
        case Opcode::move:
            return unaries<same>;
        case Opcode::channel:
            return {channel};
        case Opcode::argument:
            return {argument<0>, argument<1>};
        case Opcode::argument_constant:
            return {argument_constant};
        case Opcode::argument_affine:
            return {argument_affine};
        case Opcode::interpolate_arguments:
            return {interpolate_arguments};
        case Opcode::negate:
            return unaries<negated>;
        case Opcode::add:
            return binaries<sum>;
        case Opcode::subtract:
            return binaries<difference>;
        case Opcode::multiply:
            return binaries<product>;
        case Opcode::divide:
            return {divide<0>, divide<1>, divide<2>};
        case Opcode::power:
            return binaries<power, true>;
        case Opcode::minimum:
            return binaries<smaller>;
        case Opcode::maximum:
            return binaries<larger>;
        case Opcode::clamp:
            return ternaries<clamped>;
        case Opcode::multiply_add:
            return ternaries<product_sum>;
        case Opcode::interpolate:
            return ternaries<interpolated>;
        case Opcode::square_root:
            return unaries<square_root, true>;
        case Opcode::floor:
            return unaries<floored, true>;
        case Opcode::ceiling:
            return unaries<ceiling, true>;
        case Opcode::sine:
            return unaries<sine, true>;
        case Opcode::cosine:
            return unaries<cosine, true>;
        case Opcode::arc_cosine:
            return unaries<arc_cosine, true>;
        case Opcode::arc_cosine_clamped:
            return unaries<arc_cosine_clamped, true>;
        case Opcode::arc_tangent2:
            return binaries<arc_tangent2, true>;
        case Opcode::arc_tangent2_or_zero:
            return binaries<arc_tangent2_or_zero, true>;
        case Opcode::builtin:
            return {builtin};
        case Opcode::choose:
            return ternaries<chosen>;
        case Opcode::jump:
            return {jump};
        case Opcode::jump_unless_positive:
            return {jump_unless_positive<0>, jump_unless_positive<1>};
        case Opcode::jump_unless_greater:
            return {jump_unless_greater<0>, jump_unless_greater<1>, jump_unless_greater<2>};
        case Opcode::jump_selected:
            return {jump_selected};
        case Opcode::load_cell:
            return {load_cell};
        case Opcode::call:
            return {call};
        case Opcode::delay:
            return {delay};
        case Opcode::force:
            return {force};
        case Opcode::finish:
            return {finish<0>, finish<1>};
        case Opcode::fail:
            return {fail};
    }
    return {fail};
}

}  // namespace

Execute execute_function(Opcode opcode, std::uint8_t last_operand) { return variants(opcode)[last_operand]; }

std::uint8_t operand_count(Opcode opcode) {
    const Variants functions = variants(opcode);
    std::uint8_t count = 0;
    while (count < 3 && functions[count + 1u]) ++count;
    return count;
}

bool gives_value(Opcode opcode) {
    switch (opcode) {
        case Opcode::jump:
        case Opcode::jump_unless_positive:
        case Opcode::jump_unless_greater:
        case Opcode::jump_selected:
        case Opcode::delay:
        case Opcode::force:
        case Opcode::finish:
        case Opcode::fail:
            return false;
        default:
            return true;
    }
}

}  // namespace infra::cal
