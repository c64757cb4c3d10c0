// brdftab as its users run it: tables it writes, what it prints and what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "common/error.h"
#include "ir/brdftab/quality.h"
#include "nrlbrdf/table_file.h"
#include "programs/command.h"
#include "samples.h"

namespace infra::ir {
namespace {

using infra::test::Folder;
using infra::test::Outcome;
using infra::test::run;
using test::degree;
using test::pi;

/// A file of cuts.
std::string cuts_text(const BrdfFunction& f, const std::vector<int>& incident_deg, int step_deg) {
    std::string text;
    int block = -1, row = -1;
    for (const BrdfSample& s : test::measure_cuts(f, incident_deg, step_deg)) {
        const int i = static_cast<int>(std::lround(s.theta_i / degree));
        const int r = static_cast<int>(std::lround(s.theta_r / degree));
        if (i != block) {
            text += "\ntheta_i " + std::to_string(i) + "\ntheta_r 0 90 180";
            row = -1;
        }
        if (r != row) text += "\n" + std::to_string(r);
        char value[32];
        std::snprintf(value, sizeof value, " %.9g", s.f);
        text += value;
        block = i;
        row = r;
    }
    return text + "\n";
}

TEST(Brdftab, LambertianInLambertianOut) {
    const Folder folder;
    folder.write("grey.txt", cuts_text(lambertian(0.42), {20, 40, 60}, 10));
    for (const std::string source : {"-cuts grey.txt", "-lambert .42"}) {
        const Outcome outcome = run(folder, "brdftab -o grey.brdf " + source);
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const LoadedTable loaded = load_table(folder.path("grey.brdf"));
        EXPECT_TRUE(loaded.warnings.empty());
        for (int j = 0; j < 19; ++j) {
            EXPECT_NEAR(loaded.table->diffuse_reflectance() + loaded.table->lobe_reflectance_node(j), 0.42,
                        1e-6);
            EXPECT_NEAR(loaded.table->incident_reflectance(j), 0.42, 1e-6);
        }
        EXPECT_NEAR(table_value(*loaded.table, 1.5, 1, 1.5), 0.42 / pi, 1e-6);
    }
}

TEST(Brdftab, SamplesOnNodesComeBack) {
    const Folder folder;
    const BrdfFunction f = test::ward_in_full(0.1, 0.3, 0.15);
    folder.write("paint.txt", cuts_text(f, {20, 40, 60}, 5));
    ASSERT_EQ(run(folder, "brdftab -cuts -o paint.brdf paint.txt").status, 1);  // -cuts takes the file's name
    const Outcome outcome = run(folder, "brdftab -cuts paint.txt -o paint.brdf -plot paint.svg");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const LoadedTable loaded = load_table(folder.path("paint.brdf"));
    EXPECT_TRUE(loaded.warnings.empty());
    for (const BrdfSample& s : test::measure_cuts(f, {20, 40, 60}, 5))
        EXPECT_NEAR(table_value(*loaded.table, s.theta_i, s.phi, s.theta_r), s.f, 2e-6 * s.f);
    EXPECT_NE(outcome.out.find("one sample left out, 147 samples: median"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("one incident angle left out, 147 samples: median"), std::string::npos);
    EXPECT_NE(outcome.out.find("reciprocity error: rms"), std::string::npos);
    EXPECT_NE(folder.read("paint.brdf").find("# brdftab -cuts paint.txt"), std::string::npos);
    EXPECT_TRUE(folder.has("paint.svg"));
}

TEST(Brdftab, ColumnsAndCutsAreOne) {
    const Folder folder;
    const BrdfFunction f = gaussian_lobe(0.1, 0.3, 0.3);
    folder.write("cuts.txt", cuts_text(f, {20, 60}, 20));
    std::string columns = "value theta_r theta_i phi\n";
    for (const BrdfSample& s : test::measure_cuts(f, {20, 60}, 20)) {
        char line[100];
        std::snprintf(line, sizeof line, "%.9g %g %g %g\n", s.f, std::round(s.theta_r / degree),
                      std::round(s.theta_i / degree), std::round(s.phi / degree));
        columns += line;
    }
    folder.write("columns.txt", columns);
    ASSERT_EQ(run(folder,
                  "brdftab -cuts cuts.txt -o a.brdf && brdftab -o b.brdf columns.txt && "
                  "grep -v '#' a.brdf > a && grep -v '#' b.brdf > b && cmp a b")
                  .status,
              0);
}

TEST(Brdftab, TablesOfModelsLoadWithoutWarnings) {
    const Folder folder;
    for (const std::string model :
         {"-lambert 1", "-ward .2 .5 .3", "-ggx .2 .3 1.5 0", "-cox-munk 5 1.218 .0508",
          "-cox-munk 15 1.351 .0046", "-sandford-robertson .5 .3 .2 .3 -symmetrize -clamp-energy",
          "-beard-maxwell 1.5 0 .1 .2 .2 .01 17 57 -clamp-energy"}) {
        const Outcome outcome = run(folder, "brdftab -o model.brdf " + model);
        ASSERT_EQ(outcome.status, 0) << model << outcome.err;
        EXPECT_EQ(outcome.err, "") << model;
        const LoadedTable loaded = load_table(folder.path("model.brdf"));
        EXPECT_TRUE(loaded.warnings.empty()) << model;
        EXPECT_LE(largest_reflectance(*loaded.table), 1 + 1e-5) << model;
        EXPECT_LT(reciprocity_error(*loaded.table).largest, 1e-4) << model;
    }
}

TEST(Brdftab, ReportsRepairs) {
    const Folder folder;
    const Outcome outcome =
        run(folder, "brdftab -sandford-robertson .5 .3 .2 .3 -symmetrize -clamp-energy -n 10 12 10");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.out.find("reciprocity before -symmetrize: rms "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("energy: largest reflectance "), std::string::npos) << outcome.out;
    const Outcome bright = run(folder, "brdftab -ward .8 .8 .3");
    EXPECT_EQ(bright.err.find("brdftab: warning: the table reflects up to 1.39"), 0u) << bright.err;
}

TEST(Brdftab, PrintsTheSeasEmissivity) {
    const Folder folder;
    const Outcome outcome = run(folder, "brdftab -cox-munk 5 1.218 .0508");
    EXPECT_NE(outcome.out.find("0.956640"), std::string::npos) << outcome.out;
}

TEST(Brdftab, StatesBandsAndMakesOtherGrids) {
    const Folder folder;
    ASSERT_EQ(run(folder,
                  "brdftab -ward .1 .3 .4 -n 10 12 10 -band 8 9.5 -o a.brdf && "
                  "brdftab -table a.brdf -n 10 12 10 -o same.brdf && "
                  "brdftab -table a.brdf -n 19 24 19 -band 3 5 -o b.brdf && cat a.brdf b.brdf > both.brdf")
                  .status,
              0);
    const LoadedTable a = load_table(folder.path("a.brdf")), same = load_table(folder.path("same.brdf"));
    EXPECT_EQ(a.band, (WavelengthBand{8, 9.5}));
    EXPECT_EQ(same.band, a.band);
    EXPECT_TRUE(std::equal(a.table->values().begin(), a.table->values().end(), same.table->values().begin(),
                           same.table->values().end()));
    const LoadedTable b = load_table(folder.path("b.brdf"));
    EXPECT_EQ(b.band, (WavelengthBand{3, 5}));
    for (const double theta : {0.1, 0.7, 1.3})  // the coarse grid's nodes are among the fine one's
        EXPECT_NEAR(table_value(*b.table, theta, 3, 0.5), table_value(*a.table, theta, 3, 0.5), 1e-7);
    EXPECT_EQ(load_tables(folder.path("both.brdf")).size(), 2U);
    EXPECT_NE(run(folder, "brdftab -table both.brdf").err.find("another table"), std::string::npos);
}

TEST(Brdftab, ReportsTheErrorOfAModelsReflectance) {
    const Folder folder;
    EXPECT_NE(run(folder, "brdftab -ward 0 .5 .2").out.find("error of the reflectance: at most "),
              std::string::npos);
}

TEST(Brdftab, IsDeterministic) {
    const Folder folder;
    folder.write("paint.txt", cuts_text(gaussian_lobe(0.1, 0.3, 0.15), {20, 40, 60}, 10));
    EXPECT_EQ(run(folder,
                  "brdftab -cuts paint.txt -o a.brdf -plot a.svg > a && mv a.brdf b.brdf && "
                  "brdftab -cuts paint.txt -o a.brdf -plot b.svg > b && cmp a b && cmp a.svg b.svg && "
                  "grep -v '#' a.brdf > a && grep -v '#' b.brdf > b && cmp a b")
                  .status,
              0);
}

TEST(Brdftab, RefusesBadInputAndLeavesNothing) {
    const Folder folder;
    folder.write("empty.txt", "");
    folder.write("few.txt", "theta_i phi theta_r value\n20 180 20 1\n");
    folder.write("bad.txt", "theta_i phi theta_r value\n20 180 20 -1\n");
    const auto error = [&folder](const std::string& arguments) {
        const Outcome outcome = run(folder, "brdftab -o out.brdf -plot out.svg " + arguments);
        EXPECT_EQ(outcome.status, 1) << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        EXPECT_FALSE(folder.has("out.brdf"));
        EXPECT_FALSE(folder.has("out.svg"));
        return outcome.err;
    };
    EXPECT_EQ(error("empty.txt"),
              "brdftab: empty.txt:1: the file is empty (the first line names the columns)\n");
    EXPECT_EQ(error("few.txt"),
              "brdftab: few.txt: only 1 different geometries are measured (at least 4; for a Lambertian use "
              "-lambert)\n");
    EXPECT_EQ(error("bad.txt"),
              "brdftab: bad.txt:2: negative BRDF value -1 (-zero-negative takes such values for 0)\n");
    EXPECT_NE(error("missing.txt").find("missing.txt"), std::string::npos);
    EXPECT_NE(error("-merl empty.txt").find("empty.txt: the file is empty"), std::string::npos);
    EXPECT_NE(error("-lambert 2").find("reflectance must be between 0 and 1"), std::string::npos);
    EXPECT_NE(error("-lambert .5 -ward .1 .1 .1").find("the source is given by -lambert already"),
              std::string::npos);
    EXPECT_NE(error("-lambert .5 few.txt").find("two sources"), std::string::npos);
    EXPECT_NE(error("").find("give one file"), std::string::npos);
    EXPECT_NE(error("-lambert .5 -band 9 8").find("the shorter wavelength stands first"), std::string::npos);
    EXPECT_NE(error("-lambert .5 -band 0 8").find("lo must be above 0"), std::string::npos);
    EXPECT_NE(error("-n 1 2 3 -lambert .5").find("at least 2"), std::string::npos);
}

}  // namespace
}  // namespace infra::ir
