// Readers of BSDF files: what they understand, and where they say that something is wrong.
#include <gtest/gtest.h>

#include <numbers>

#include "bsdf/bsdf.h"
#include "bsdf_text.h"
#include "common/error.h"

namespace infra {
namespace {

using test::disk_lobe;
using test::quarter_tags;
using test::quarter_values;
using test::scattering_block;
using test::tree_tags;
using test::window_element;

std::string fault(const std::string& text) {
    try {
        parse_bsdf(text, "test.xml");
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

void expect_fault(const std::string& text, const std::string& start, const std::string& part) {
    const std::string found = fault(text);
    EXPECT_EQ(found.rfind(start, 0), 0u) << found;
    EXPECT_NE(found.find(part), std::string::npos) << found;
}

const std::string constant = quarter_values(disk_lobe(0.1, 0, 1));

std::string matrix_of(const std::string& data) {
    return window_element("Columns", scattering_block("Visible", "Reflection Back", quarter_tags, data));
}
std::string tree_of(const std::string& data) {
    return window_element("TensorTree4", scattering_block("Visible", "Reflection Back", tree_tags, data));
}

TEST(BsdfFile, TellsItsSides) {
    const Bsdf& bsdf = *parse_bsdf(window_element("Columns", scattering_block("Visible", "Reflection Front",
                                                                              quarter_tags, constant)),
                                   "test.xml")
                            .bsdf;
    EXPECT_EQ(bsdf.lambertian_reflectance(true).y, 0);
    EXPECT_GT(bsdf.lambertian_reflectance(false).y, 0.3);
}

TEST(BsdfFile, TurnsRowsAndColumns) {
    const auto skewed = [](const Point2& in, const Point2& out) { return 0.2 + 0.1 * in[0] + 0.05 * out[1]; };
    const auto turned = [&](const Point2& in, const Point2& out) { return skewed(out, in); };
    const auto load = [&](const char* structure, const test::DiskFunction& f) {
        return parse_bsdf(window_element(structure, scattering_block("Visible", "Reflection Back",
                                                                     quarter_tags, quarter_values(f))),
                          "test.xml")
            .bsdf;
    };
    const auto columns = load("Columns", skewed), rows = load("Rows", turned);
    const Vec3 a = normalize(Vec3{0.5, 0.2, 1}), b = normalize(Vec3{-0.1, 0.6, 1});
    EXPECT_EQ(columns->reflection(true)->entry(a, b).value, rows->reflection(true)->entry(a, b).value);
    EXPECT_NE(columns->reflection(true)->entry(a, b).value, rows->reflection(true)->entry(b, a).value);
}

TEST(BsdfFile, HasAnglesOfItsOwn) {
    const std::string bases =
        "<AngleBasis><AngleBasisName>two</AngleBasisName>"
        "<AngleBasisBlock><nPhis>1</nPhis><ThetaBounds><LowerTheta>0</LowerTheta><UpperTheta>30</UpperTheta>"
        "</ThetaBounds></AngleBasisBlock>"
        "<AngleBasisBlock><nPhis>2</nPhis><ThetaBounds><LowerTheta>30</LowerTheta><UpperTheta>90</UpperTheta>"
        "</ThetaBounds></AngleBasisBlock></AngleBasis>\n";
    const std::string tags = "<ColumnAngleBasis>TWO</ColumnAngleBasis><RowAngleBasis>two</RowAngleBasis>\n";
    const auto bsdf = parse_bsdf(window_element("Columns",
                                                scattering_block("Visible", "Reflection Back", tags,
                                                                 "0.3 0 0\n0 0.1 0\n0 0 0.2\n"),
                                                bases),
                                 "test.xml")
                          .bsdf;
    const ScatterTable& table = *bsdf->reflection(true);
    EXPECT_FLOAT_EQ(static_cast<float>(table.entry({0, 0, 1}, {0, 0, 1}).value), 0.3f);
    const Vec3 right = normalize(Vec3{1, 0, 1}), left = normalize(Vec3{-1, 0, 1});
    EXPECT_FLOAT_EQ(static_cast<float>(table.entry(left, right).value), 0.1f);
    EXPECT_FLOAT_EQ(static_cast<float>(table.entry(right, left).value), 0.2f);
    EXPECT_EQ(table.entry(right, right).value, 0);
}

TEST(BsdfFile, AddsColor) {
    const auto block = [](const char* wavelength, double f) {
        return scattering_block(wavelength, "Reflection Back", quarter_tags,
                                quarter_values(disk_lobe(f, 0, 1)));
    };
    const auto bsdf = parse_bsdf(window_element("Columns", block("CIE-X", 0.12) + block("Visible", 0.1) +
                                                               block("CIE-Z", 0.05)),
                                 "test.xml")
                          .bsdf;
    const Xyz& color = bsdf->lambertian_reflectance(true);
    EXPECT_NEAR(color.x, 0.12 * std::numbers::pi, 1e-4);
    EXPECT_NEAR(color.y, 0.10 * std::numbers::pi, 1e-4);
    EXPECT_NEAR(color.z, 0.05 * std::numbers::pi, 1e-4);
}

TEST(BsdfFile, DescribesTheThing) {
    const auto text = window_element(
        "Columns", scattering_block("Visible", "Reflection Back", quarter_tags, constant), "",
        "<Name>blind</Name><Manufacturer>none</Manufacturer><Thickness unit=\"millimeter\">20</Thickness>");
    const BsdfDescription about = parse_bsdf(text, "test.xml").bsdf->description();
    EXPECT_EQ(about.material, "blind");
    EXPECT_NEAR(about.thickness, 0.02, 1e-12);
}

TEST(BsdfFile, WarnsOfTooMuchAndOfNegativeValues) {
    const auto bright = parse_bsdf(matrix_of(quarter_values(disk_lobe(0.4, 0, 1))), "test.xml");
    ASSERT_EQ(bright.warnings.size(), 1u);
    EXPECT_NE(bright.warnings[0].find("125.7 %"), std::string::npos) << bright.warnings[0];
    std::string data = constant;
    data.replace(data.find("0.1"), 3, "-.1");
    const auto negative = parse_bsdf(matrix_of(data), "test.xml");
    ASSERT_EQ(negative.warnings.size(), 1u);
    EXPECT_NE(negative.warnings[0].find("below 0"), std::string::npos) << negative.warnings[0];
}

TEST(BsdfFile, SaysWhereItIsWrong) {
    expect_fault("", "test.xml:1", "bad XML");
    expect_fault("<WindowElement>\n<Optical>\n", "test.xml:2", "bad XML");
    expect_fault("<Window/>", "test.xml:1", "WindowElement");
    expect_fault("<WindowElement/>", "test.xml:1", "Layer");
    expect_fault(window_element("Diagonals", ""), "test.xml:7", "Diagonals");
    expect_fault(window_element("Columns", ""), "test.xml:2", "Visible");
    expect_fault(matrix_of("0.1 0.2"), "test.xml:", "too few");
    expect_fault(matrix_of(constant.substr(0, constant.size() - 8) + "          "), "test.xml:", "41 x 41");
    expect_fault(matrix_of(constant + "0.1"), "test.xml:", "more scattering data");
    for (const char* word : {"nan", "inf", "x", "1e99", "{", "0x1"}) {
        std::string data = constant;
        data.replace(data.find("0.1"), 3, word);
        expect_fault(matrix_of(data), "test.xml:", "not a number");
    }
    expect_fault(
        window_element("Columns", scattering_block("Visible", "Reflection Back",
                                                   "<ColumnAngleBasis>none</ColumnAngleBasis>", "1")),
        "test.xml:", "angle basis \"none\"");
    EXPECT_THROW(load_bsdf("/no/such/file.xml"), Error);
}

TEST(BsdfFile, RefusesBadTrees) {
    expect_fault(tree_of(".1"), "test.xml:", "missing '{'");
    expect_fault(tree_of("{.1"), "test.xml:", "missing '}'");
    expect_fault(tree_of("{.1} {.1}"), "test.xml:", "after the end");
    expect_fault(tree_of("{.1 .2}"), "test.xml:", "2 values");
    expect_fault(tree_of("{{.1}{.2}}"), "test.xml:", "missing '{'");
    expect_fault(tree_of(std::string(100'000, '{')), "test.xml:", "levels deep");
    expect_fault(
        window_element("TensorTree3", scattering_block("Visible", "Reflection Back", quarter_tags, "{1}")),
        "test.xml:", "Shirley-Chiu");
}

TEST(BsdfFile, DoesNotExpandEntities) {
    const std::string bomb =
        "<?xml version=\"1.0\"?>\n<!DOCTYPE x [<!ENTITY a \"1 1 1 1\"><!ENTITY b \"&a;&a;&a;&a;\">]>\n";
    const std::string file = matrix_of("&b;" + constant);
    expect_fault(bomb + file.substr(file.find('\n') + 1), "test.xml:", "not a number");
}

}  // namespace
}  // namespace infra
