// docs/reference.md is made from the tables that the programs themselves read; this test keeps it so.
//
// After a change of a table: INFRADIANCE_UPDATE_DOCS=1 build/tests/docs_test writes the page anew.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "program_tables.h"
#include "rt/compile/modifier_table.h"
#include "rt/programs/output_letters.h"
#include "scene/primitive_types.h"
#include "type_remarks.h"

namespace infra {
namespace {

const char* kind_name(PrimitiveKind kind) {
    switch (kind) {
        case PrimitiveKind::surface:
            return "surface";
        case PrimitiveKind::volume:
            return "volume";
        case PrimitiveKind::alias:
            return "alias";
        case PrimitiveKind::material:
            return "material";
        case PrimitiveKind::texture:
            return "texture";
        case PrimitiveKind::pattern:
            return "pattern";
        case PrimitiveKind::mixture:
            return "mixture";
    }
    return "";
}

/// The scene compiler takes every surface and volume, and the modifiers of its table.
bool is_rendered(const PrimitiveInfo& row) {
    return row.is_geometry() || row.kind == PrimitiveKind::alias || find_modifier_row(row.type) != nullptr;
}

std::string compared(const PrimitiveInfo& row) {
    if (!is_rendered(row)) return "not planned: read by oconv and refused by the renderers";
    if (row.is_ours()) return "ours";
    const std::string_view remark = type_remark(row.type);
    return remark.empty() ? "works" : "differs: " + std::string(remark);
}

std::string compared(const OptionRow& row) {
    if (!row.unsupported.empty()) return "not planned: " + row.unsupported;
    if (row.is_ours) return "ours";
    return row.differs.empty() ? "works" : "differs: " + row.differs;
}

std::string arguments(const CountRule& rule, std::string_view meaning) {
    if (rule.most == 0 && rule.also <= 0) return "";
    return rule.text() + ": `" + std::string(meaning) + "`";
}

std::string type_table() {
    std::string text =
        "| type | kind | string arguments | real arguments | RADIANCE 6.1 |\n| --- | --- | --- | --- | --- "
        "|\n";
    for (const PrimitiveInfo& row : primitive_types())
        text += "| `" + std::string(row.name) + "` | " + kind_name(row.kind) + " | " +
                arguments(row.strings, row.string_meaning) + " | " + arguments(row.reals, row.real_meaning) +
                " | " + compared(row) + " |\n";
    return text;
}

/// A bar would end a cell of the table.
std::string cell(std::string_view text) {
    std::string result;
    for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
    return result;
}

std::string option_table(const OptionTable& table) {
    std::string text = "| option | what it does | RADIANCE 6.1 |\n| --- | --- | --- |\n";
    for (const OptionRow& row : table.rows())
        text += "| `" + row.spelling + cell(row.arguments.empty() ? "" : " " + row.arguments) + "` | " +
                cell(row.help) + " | " + cell(compared(row)) + " |\n";
    return text;
}

/// Answered by every program before its table is asked.
bool is_built_in(const std::string& option) {
    return option == "-defaults" || option == "-help" || option == "-version";
}

std::string reference_page() {
    const ProgramTables programs;
    std::string text =
        "# Reference: types and options, compared with RADIANCE 6.1\n\n"
        "Every primitive type of RADIANCE and every option of its programs that are here too. This page is "
        "made "
        "from the tables that the programs read (`tests/docs/reference_test.cpp`), and held against the "
        "names "
        "that RADIANCE knows (`tests/docs/radiance_6_1.txt`).\n\n"
        "The last column says *works*: as in RADIANCE; *differs*: how, on purpose; *not planned*: why not; "
        "*ours*: RADIANCE has nothing of that name. What is not about one type or option stands in "
        "[compatibility.md](compatibility.md).\n\n"
        "## Primitive types\n\n" +
        type_table();
    for (const OptionTable& table : programs.tables)
        text += "\n## Options of " + table.program() + "\n\n" + option_table(table);
    return text +
           "\nEvery program also answers `-help`, `-version` and, where it lists values, `-defaults`.\n";
}

/// The names of one sort in the list of what RADIANCE knows.
std::set<std::string> radiance_names(const std::string& sort) {
    std::ifstream list(std::string(INFRA_SOURCE_DIR) + "/tests/docs/radiance_6_1.txt");
    std::set<std::string> names;
    for (std::string line; std::getline(list, line);) {
        const std::size_t blank = line.find(' ');
        if (line[0] != '#' && line.substr(0, blank) == sort) names.insert(line.substr(blank + 1));
    }
    EXPECT_FALSE(names.empty()) << sort;
    return names;
}

TEST(Reference, PageAgreesWithTheTables) {
    const std::string path = std::string(INFRA_SOURCE_DIR) + "/docs/reference.md";
    if (std::getenv("INFRADIANCE_UPDATE_DOCS")) std::ofstream(path) << reference_page();
    std::stringstream page;
    page << std::ifstream(path).rdbuf();
    EXPECT_EQ(page.str(), reference_page())
        << "run INFRADIANCE_UPDATE_DOCS=1 docs_test to write the page anew";
}

TEST(Reference, TypesAreRadiances) {
    std::set<std::string> theirs;
    for (const PrimitiveInfo& row : primitive_types())
        if (!row.is_ours()) theirs.insert(std::string(row.name));
    EXPECT_EQ(theirs, radiance_names("type"));
    for (const PrimitiveInfo& row : primitive_types())
        if (!type_remark(row.type).empty()) {
            EXPECT_TRUE(is_rendered(row) && !row.is_ours()) << row.name;
        }
}

TEST(Reference, OptionsAreRadiances) {
    const ProgramTables programs;
    for (const OptionTable& table : programs.tables) {
        const std::set<std::string> known = radiance_names(table.program());
        std::set<std::string> missing = known;
        std::erase_if(missing, is_built_in);
        for (const OptionRow& row : table.rows()) {
            const bool theirs = known.contains(row.spelling);
            missing.erase(row.spelling);
            EXPECT_NE(theirs, row.is_ours)
                << table.program() << " " << row.spelling
                << (theirs ? " is RADIANCE's" : " is not RADIANCE's: mark it ours()");
            EXPECT_TRUE(row.differs.empty() || (theirs && row.unsupported.empty()))
                << table.program() << " " << row.spelling << " differs from nothing";
        }
        for (const std::string& option : missing)
            ADD_FAILURE() << table.program() << " " << option << " of RADIANCE has no row";
    }
}

TEST(Reference, OutputLettersAreRadiances) {
    std::set<std::string> letters = {"t", "T"};  // the tree, which is not a value
    for (const OutputLetter& letter : output_letters()) letters.insert(std::string(1, letter.letter));
    EXPECT_EQ(letters, radiance_names("rtrace-output"));
}

TEST(Reference, EveryRenderedTypeIsAModifier) {
    for (const ModifierRow& row : modifier_table())
        EXPECT_TRUE(info(row.type).is_modifier()) << name(row.type);
}

}  // namespace
}  // namespace infra
