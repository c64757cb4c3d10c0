// The machine code that expressions compile to. Instructions work on registers: doubles in one array.
//
// Register file of an Evaluator: the constants, then the temporaries of the roots (which share their place,
// as they never run inside each other), then those of each cell, then the call stack with a frame for each
// running instance. An instance's registers count from its frame, those of roots and cells from the start of
// the file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cal/builtin.h"
#include "cal/program.h"
#include "common/error.h"

namespace infra::cal {

enum class Opcode : std::uint8_t {
    move,                   ///< dst = a
    channel,                ///< dst = $data
    argument,               ///< dst = arg(a)
    argument_constant,      ///< dst = real argument number data, from 0
    argument_affine,        ///< dst = arg(k0 + k1*a + k2*b), the k in three registers from c on
    interpolate_arguments,  ///< dst = (1-t)*arg(k0 + k1*a + k2*b) + t*arg(k3 + k1*a + k2*b), t in register
                            ///< data
    negate,                 ///< dst = -a
    add,                    ///< dst = a + b
    subtract,               ///< dst = a - b
    multiply,               ///< dst = a * b
    divide,                 ///< dst = a / b, 0 if b is 0
    power,                  ///< dst = a ^ b
    minimum,                ///< dst = min(a, b)
    maximum,                ///< dst = max(a, b)
    clamp,                  ///< dst = max(min(a, c), b)
    multiply_add,           ///< dst = a * b + c
    interpolate,            ///< dst = (1 - a) * b + a * c
    square_root,            ///< dst = sqrt(a), and so on
    floor,
    ceiling,
    sine,
    cosine,
    arc_cosine,
    arc_cosine_clamped,    ///< dst = acos(max(min(a, 1), -1))
    arc_tangent2,          ///< dst = atan2(a, b)
    arc_tangent2_or_zero,  ///< the same, 0 for a = b = 0
    builtin,               ///< dst = builtin number data of the registers from a on
    choose,                ///< dst = a > 0 ? b : c
    jump,                  ///< to data
    jump_unless_positive,  ///< to data unless a > 0
    jump_unless_greater,   ///< to data unless a > b
    jump_selected,  ///< to where the table at `data` says: count, then targets if outside, for 0, 1, ...
    load_cell,      ///< dst = cell number data, computed if it is stale
    call,           ///< dst = instance number data, its parameters in the registers from a on
    delay,          ///< dst, dst+1, dst+2 = a value to be computed by the code at data when it is forced
    force,          ///< computes the delayed value in a, a+1, a+2, unless that has been done
    finish,         ///< ends the body with the value a
    fail,           ///< throws error number data
};

struct Instruction;
struct Machine;

/// Carries out an instruction and all that follow it, up to `finish`. `last` is what the one before it
/// computed.
using Execute = double (*)(const Instruction*, double* registers, Machine&, double last);

struct Instruction {
    Execute execute = nullptr;
    Opcode opcode = Opcode::fail;
    std::uint8_t last_operand =
        0;  ///< which of a, b, c (1 to 3) is what the instruction before computed; 0: none
    std::uint32_t dst = 0;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t c = 0;
    std::uint32_t data = 0;
};

/// A function that could not be inlined. Its frame starts with the parameters, then the constants it uses.
struct InstanceCode {
    std::string name;                   ///< for the error about endless recursion
    std::uint32_t entry = 0;            ///< first instruction
    std::uint32_t parameter_slots = 0;  ///< registers that the parameters take: one, or three if delayed
    std::uint32_t frame_size = 0;
    std::vector<bool> delayed;  ///< for each parameter
    std::vector<double> constants;
};

struct Code {
    struct Root {
        bool is_instance = false;
        std::uint32_t target = 0;  ///< entry, or number of the instance
    };

    std::vector<Instruction> instructions;
    std::vector<double> constants;
    std::vector<Root> roots;           ///< by ExprId
    std::vector<std::uint32_t> cells;  ///< entry of each cell's body
    std::vector<InstanceCode> instances;
    std::vector<std::uint32_t> jump_tables;
    std::vector<Builtin> builtins;
    std::vector<Error> errors;
    std::uint32_t static_registers = 0;  ///< all but the call stack
    std::uint32_t stack_registers = 0;
};

}  // namespace infra::cal
