// docs/reference.md is made from the tables that the programs themselves read; this test keeps it so.
//
// After a change of a table: INFRADIANCE_UPDATE_DOCS=1 build/tests/docs_test writes the page anew.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "rt/compile/modifier_table.h"
#include "rt/geometry/geometry.h"
#include "rt/programs/rpict_options.h"
#include "rt/programs/rtrace_options.h"
#include "scene/primitive_types.h"

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

bool is_rendered(const PrimitiveInfo& row) {
    if (row.kind == PrimitiveKind::alias) return true;
    if (row.is_modifier()) return find_modifier_row(row.type) != nullptr;
    return row.kind == PrimitiveKind::surface;
}

std::string arguments(const CountRule& rule, std::string_view meaning) {
    if (rule.most == 0 && rule.also <= 0) return "";
    return rule.text() + ": `" + std::string(meaning) + "`";
}

std::string type_table() {
    std::string text =
        "| type | kind | string arguments | real arguments | rendered |\n| --- | --- | --- | --- | --- |\n";
    for (const PrimitiveInfo& row : primitive_types())
        text += "| `" + std::string(row.name) + "` | " + kind_name(row.kind) + " | " +
                arguments(row.strings, row.string_meaning) + " | " + arguments(row.reals, row.real_meaning) +
                " | " + (is_rendered(row) ? "yes" : "not yet") + " |\n";
    return text;
}

/// A bar would end a cell of the table.
std::string cell(std::string_view text) {
    std::string result;
    for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
    return result;
}

std::string option_table(const OptionTable& table) {
    std::string text = "| option | what it sets |\n| --- | --- |\n";
    for (const OptionRow& row : table.rows()) {
        text += "| `" + row.spelling + cell(row.arguments.empty() ? "" : " " + row.arguments) + "` | ";
        text += cell(row.unsupported.empty() ? row.help : "refused: " + row.unsupported);
        text += " |\n";
    }
    return text;
}

std::string reference_page() {
    RpictOptions rpict;
    RtraceOptions rtrace;
    return "# Reference: types and options\n\n"
           "This page is generated from the tables that the programs read "
           "(`tests/docs/reference_test.cpp`).\n\n"
           "## Primitive types\n\n"
           "Every type of RADIANCE 6.1, and `emissive` and `nrlbrdf`, which are ours. `oconv`, `xform` and "
           "`getinfo` know "
           "them all; a type that is not rendered yet is refused by name when `rpict` or `rtrace` meets "
           "it.\n\n" +
           type_table() +
           "\n## Options of rpict\n\nA refused option is one that RADIANCE has and we do not yet.\n\n" +
           option_table(rpict_option_table(rpict)) + "\n## Options of rtrace\n\n" +
           option_table(rtrace_option_table(rtrace));
}

TEST(Reference, PageAgreesWithTheTables) {
    const std::string path = std::string(INFRA_SOURCE_DIR) + "/docs/reference.md";
    if (std::getenv("INFRADIANCE_UPDATE_DOCS")) std::ofstream(path) << reference_page();
    std::stringstream page;
    page << std::ifstream(path).rdbuf();
    EXPECT_EQ(page.str(), reference_page())
        << "run INFRADIANCE_UPDATE_DOCS=1 docs_test to write the page anew";
}

TEST(Reference, EveryRenderedTypeIsAModifier) {
    for (const ModifierRow& row : modifier_table())
        EXPECT_TRUE(info(row.type).is_modifier()) << name(row.type);
}

}  // namespace
}  // namespace infra
