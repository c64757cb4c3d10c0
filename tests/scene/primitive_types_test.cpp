#include "scene/primitive_types.h"

#include <gtest/gtest.h>

#include <set>

namespace infra {
namespace {

// Every type of RADIANCE 6.1's reference manual, section 2.1, and the three of ours.
const std::set<std::string_view> documented = {
    "source",    "sphere",     "bubble",    "polygon",    "cone",       "cup",        "cylinder",
    "tube",      "ring",       "instance",  "mesh",       "light",      "illum",      "glow",
    "spotlight", "mirror",     "prism1",    "prism2",     "mist",       "plastic",    "metal",
    "trans",     "plastic2",   "metal2",    "trans2",     "ashik2",     "dielectric", "interface",
    "glass",     "plasfunc",   "metfunc",   "transfunc",  "BRTDfunc",   "plasdata",   "metdata",
    "transdata", "BSDF",       "aBSDF",     "WGMDfunc",   "antimatter", "texfunc",    "texdata",
    "colorfunc", "brightfunc", "colordata", "brightdata", "colorpict",  "colortext",  "brighttext",
    "spectrum",  "specfile",   "specfunc",  "specdata",   "specpict",   "mixfunc",    "mixdata",
    "mixpict",   "mixtext",    "alias",     "emissive",   "nrlbrdf",    "thermal"};

TEST(PrimitiveTypes, HoldsEveryDocumentedTypeOnce) {
    std::set<std::string_view> names;
    for (const PrimitiveInfo& row : primitive_types()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(find_primitive_type(row.name), row.type);
        EXPECT_EQ(&info(row.type), &row);
    }
    EXPECT_EQ(names, documented);
    EXPECT_EQ(primitive_types().size(), std::size_t(primitive_type_count));
}

TEST(PrimitiveTypes, UnknownNames) {
    EXPECT_FALSE(find_primitive_type("furnace"));
    EXPECT_FALSE(find_primitive_type("Sphere"));
    EXPECT_EQ(nearest_primitive_type("sphree"), "sphere");
    EXPECT_EQ(nearest_primitive_type("xyzzy"), "");
}

TEST(PrimitiveTypes, ArgumentsAreExplained) {
    for (const PrimitiveInfo& row : primitive_types()) {
        EXPECT_EQ(row.strings.most > 0, !row.string_meaning.empty()) << row.name;
        EXPECT_EQ(row.reals.most > 0, !row.real_meaning.empty()) << row.name;
    }
}

struct Counts {
    const char* type;
    std::size_t strings, reals;
    bool right;
};

class ArgumentCounts : public ::testing::TestWithParam<Counts> {};

TEST_P(ArgumentCounts, AreChecked) {
    const Counts& c = GetParam();
    const std::string wrong = wrong_counts(info(*find_primitive_type(c.type)), c.strings, c.reals);
    EXPECT_EQ(wrong.empty(), c.right) << c.type << ": " << wrong;
}

INSTANTIATE_TEST_SUITE_P(
    Types, ArgumentCounts,
    ::testing::Values(
        Counts{"polygon", 0, 9, true}, Counts{"polygon", 0, 12, true}, Counts{"polygon", 0, 6, false},
        Counts{"polygon", 0, 10, false}, Counts{"sphere", 0, 4, true}, Counts{"sphere", 1, 4, false},
        Counts{"glass", 0, 3, true}, Counts{"glass", 0, 4, true}, Counts{"glass", 0, 5, false},
        Counts{"mist", 3, 0, true}, Counts{"mist", 0, 3, true}, Counts{"mist", 0, 6, true},
        Counts{"mist", 0, 7, true}, Counts{"mist", 0, 5, false}, Counts{"mist", 0, 9, false},
        Counts{"BSDF", 6, 9, true}, Counts{"BSDF", 6, 4, false}, Counts{"BSDF", 5, 0, false},
        Counts{"spectrum", 0, 4, false}, Counts{"spectrum", 0, 40, true}, Counts{"mirror", 0, 3, true},
        Counts{"mirror", 1, 3, true}, Counts{"mirror", 2, 3, false}, Counts{"emissive", 0, 3, true},
        Counts{"emissive", 1, 4, true}, Counts{"emissive", 1, 5, false}, Counts{"emissive", 2, 3, false},
        Counts{"nrlbrdf", 1, 5, true}, Counts{"nrlbrdf", 3, 5, true}, Counts{"nrlbrdf", 1, 8, true},
        Counts{"nrlbrdf", 1, 6, false}, Counts{"nrlbrdf", 0, 5, false}, Counts{"brightfunc", 2, 0, true},
        Counts{"brightfunc", 1, 0, false}));

TEST(PrimitiveTypes, RulesInWords) {
    EXPECT_EQ(info(PrimitiveType::sphere).reals.text(), "4");
    EXPECT_EQ(info(PrimitiveType::glass).reals.text(), "3 or 4");
    EXPECT_EQ(info(PrimitiveType::nrlbrdf).reals.text(), "5 or 8");
    EXPECT_EQ(info(PrimitiveType::mist).reals.text(), "0, 3, 6 or 7");
    EXPECT_EQ(info(PrimitiveType::polygon).reals.text(), "9, 12, 15...");
    EXPECT_EQ(info(PrimitiveType::texfunc).strings.text(), "at least 4");
}

}  // namespace
}  // namespace infra
