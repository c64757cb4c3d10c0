#include "scene/mesh/ply_header.h"

#include <utility>

#include "common/parse_number.h"

namespace infra {
namespace {

constexpr std::size_t longest_line = 4096;
constexpr std::int64_t most_of_an_element = 0x7fffffff;

class HeaderReader {
  public:
    HeaderReader(std::FILE* file, const std::string& name) : file_(file), name_(name) {}

    PlyHeader read();

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(Location{name_, header_.lines}, what);
    }
    /// One byte at a time: the bytes behind the header are not the header's to read.
    std::string line();
    void statement(std::string_view key, std::string_view rest);
    void set_encoding(std::string_view rest);
    void add_element(std::string_view rest);
    void add_property(std::string_view rest);
    PlyType type(std::string_view word) const;

    std::FILE* file_;
    const std::string& name_;
    PlyHeader header_;
    bool has_encoding_ = false;
};

std::string HeaderReader::line() {
    std::string text;
    ++header_.lines;
    for (int c = std::getc(file_); c != '\n'; c = std::getc(file_)) {
        if (c == EOF) fail("the file ends within its header");
        if (text.size() == longest_line) fail("this is no PLY file");
        text += static_cast<char>(c);
    }
    return text;
}

PlyType HeaderReader::type(std::string_view word) const {
    using Kind = PlyType::Kind;
    static constexpr std::pair<std::string_view, PlyType> known[] = {
        {"char", {Kind::signed_integer, 1}},
        {"int8", {Kind::signed_integer, 1}},
        {"uchar", {Kind::unsigned_integer, 1}},
        {"uint8", {Kind::unsigned_integer, 1}},
        {"short", {Kind::signed_integer, 2}},
        {"int16", {Kind::signed_integer, 2}},
        {"ushort", {Kind::unsigned_integer, 2}},
        {"uint16", {Kind::unsigned_integer, 2}},
        {"int", {Kind::signed_integer, 4}},
        {"int32", {Kind::signed_integer, 4}},
        {"uint", {Kind::unsigned_integer, 4}},
        {"uint32", {Kind::unsigned_integer, 4}},
        {"float", {Kind::real, 4}},
        {"float32", {Kind::real, 4}},
        {"double", {Kind::real, 8}},
        {"float64", {Kind::real, 8}},
    };
    for (const auto& [name, type] : known)
        if (name == word) return type;
    fail("\"" + std::string(word) + "\" is no type of a number");
}

void HeaderReader::set_encoding(std::string_view rest) {
    const std::string_view word = take_word(rest);
    if (word == "ascii")
        header_.encoding = PlyEncoding::text;
    else if (word == "binary_little_endian")
        header_.encoding = PlyEncoding::little_endian;
    else if (word == "binary_big_endian")
        header_.encoding = PlyEncoding::big_endian;
    else
        fail("unknown format \"" + std::string(word) + "\"");
    has_encoding_ = true;
}

void HeaderReader::add_element(std::string_view rest) {
    PlyElement element;
    element.name = take_word(rest);
    long long count = 0;
    if (!parse_int(take_word(rest), count) || count < 0 || count > most_of_an_element)
        fail("element " + element.name + " has a senseless number");
    element.count = count;
    header_.elements.push_back(std::move(element));
}

void HeaderReader::add_property(std::string_view rest) {
    if (header_.elements.empty()) fail("a property before any element");
    PlyProperty property;
    std::string_view word = take_word(rest);
    property.is_list = word == "list";
    if (property.is_list) {
        property.count_type = type(take_word(rest));
        if (property.count_type.kind == PlyType::Kind::real) fail("a list whose length is no integer");
        word = take_word(rest);
    }
    property.type = type(word);
    property.name = take_word(rest);
    header_.elements.back().properties.push_back(std::move(property));
}

void HeaderReader::statement(std::string_view key, std::string_view rest) {
    if (key == "format")
        set_encoding(rest);
    else if (key == "element")
        add_element(rest);
    else if (key == "property")
        add_property(rest);
    else if (!key.empty() && key != "comment" && key != "obj_info")
        fail("\"" + std::string(key) + "\" is nothing that a PLY header says");
}

PlyHeader HeaderReader::read() {
    std::string text = line();
    std::string_view rest = text;
    if (take_word(rest) != "ply") fail("this is no PLY file");
    while (true) {
        text = line();
        rest = text;
        const std::string_view key = take_word(rest);
        if (key == "end_header") break;
        statement(key, rest);
    }
    if (!has_encoding_) fail("no format in the header");
    return std::move(header_);
}

}  // namespace

PlyHeader read_ply_header(std::FILE* file, const std::string& name) {
    return HeaderReader(file, name).read();
}

}  // namespace infra
