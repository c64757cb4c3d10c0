// A compiled set of expressions: immutable, so that any number of threads can share it, each with its own
// Evaluator.
#pragma once

#include <cstdint>
#include <memory>

namespace infra::cal {

/// Names one compiled expression of the Library that made it and of every Program linked from that Library.
struct ExprId {
    std::uint32_t index = 0;
    friend bool operator==(ExprId, ExprId) = default;
};

struct Code;

/// Cheap to copy: a handle to shared code.
class Program {
  public:
    explicit Program(std::shared_ptr<const Code> code) : code_(std::move(code)) {}
    const Code& code() const { return *code_; }

  private:
    std::shared_ptr<const Code> code_;
};

}  // namespace infra::cal
