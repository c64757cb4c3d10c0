// Bytes that go from one rank to another, written and read value by value. All ranks are the same program on
// machines of one kind, so that numbers go as they are in memory.
#pragma once

#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "common/error.h"

namespace infra {

using Bytes = std::vector<char>;

class MessageWriter {
  public:
    template <class T>
    void put(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        append(&value, sizeof value);
    }
    template <class T>
    void put_all(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        put(values.size());
        append(values.data(), values.size_bytes());
    }
    void put_text(const std::string& text) { put_all(std::span<const char>(text)); }

    Bytes take() { return std::move(bytes_); }

  private:
    void append(const void* data, std::size_t size) {
        if (size == 0) return;
        const std::size_t old = bytes_.size();
        bytes_.resize(old + size);
        std::memcpy(bytes_.data() + old, data, size);
    }
    Bytes bytes_;
};

/// Reads what a MessageWriter has written, in the same order. throws Error where there is less of it.
class MessageReader {
  public:
    /// The bytes outlive this.
    explicit MessageReader(std::span<const char> bytes) : rest_(bytes) {}

    template <class T>
    T get() {
        static_assert(std::is_trivially_copyable_v<T>);
        T value;
        copy(&value, sizeof value);
        return value;
    }
    template <class T>
    std::vector<T> get_all() {
        const auto count = get<std::size_t>();
        if (count > rest_.size() / sizeof(T)) fail();
        std::vector<T> values(count);
        copy(values.data(), count * sizeof(T));
        return values;
    }
    std::string get_text() {
        const std::vector<char> text = get_all<char>();
        return {text.begin(), text.end()};
    }

    bool at_end() const { return rest_.empty(); }

  private:
    [[noreturn]] static void fail() {
        throw Error("a message between ranks is cut short", {}, Severity::internal);
    }
    void copy(void* target, std::size_t size) {
        if (size > rest_.size()) fail();
        if (size > 0) std::memcpy(target, rest_.data(), size);
        rest_ = rest_.subspan(size);
    }
    std::span<const char> rest_;
};

}  // namespace infra
