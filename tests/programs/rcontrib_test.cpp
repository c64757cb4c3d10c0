// rcontrib from the outside: what surfaces of named modifiers contribute to rays. Figures marked as
// RADIANCE's were printed by its 6.1 for the same scene and options; others follow from the scene.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <sstream>
#include <vector>

#include "command.h"

namespace infra {
namespace {

using test::Folder;
using test::Outcome;

using Rows = std::vector<std::vector<double>>;

Rows rows_of(const std::string& text) {
    Rows rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::vector<double>& row = rows.emplace_back();
        for (double value; words >> value;) row.push_back(value);
    }
    return rows;
}

void expect_rows(const std::string& text, const Rows& expected, double relative) {
    const Rows found = rows_of(text);
    ASSERT_EQ(found.size(), expected.size()) << text;
    for (std::size_t r = 0; r < expected.size(); ++r) {
        ASSERT_EQ(found[r].size(), expected[r].size()) << text;
        for (std::size_t i = 0; i < expected[r].size(); ++i)
            EXPECT_NEAR(found[r][i], expected[r][i], relative * std::fabs(expected[r][i]))
                << "row " << r << " value " << i;
    }
}

/// A lamp, a sun and a sky over a floor, with a mirror that shows the lamp and a pane before it.
constexpr const char* court =
    "void light lum 0 0 3 10 20 30\n"
    "lum sphere lamp 0 0 4 0 0 5 .5\n"
    "void plastic paint 0 0 5 .5 .4 .3 .05 0\n"
    "paint ring floor 0 0 8 0 0 0 0 0 1 0 50\n"
    "void mirror mir 0 0 3 .8 .8 .8\n"
    "mir polygon mp 0 0 12 -5 6 0 5 6 0 5 6 6 -5 6 6\n"
    "void glass gl 0 0 3 .9 .8 .7\n"
    "gl polygon gp 0 0 12 -1 -1 2 1 -1 2 1 1 2 -1 1 2\n"
    "void glow sky_glow 0 0 4 1 1 1 0\n"
    "sky_glow source sky 0 0 4 0 0 1 180\n"
    "void light sun 0 0 3 1000 1000 900\n"
    "sun source sunny 0 0 4 1 .5 1 .5\n";
constexpr const char* court_rays =
    "0 0 3 .1 .2 -1\n"
    "2 1 3 .1 .2 -1\n"
    "0 3 1 0 1 -.1\n"
    "0 3 1 .5 -.5 .5\n";

/// Everything that sends rays in its own way: lobes of all kinds, textures, mixtures, mirrors, media.
constexpr const char* bazaar =
    "void light lum 0 0 3 10 20 30\n"
    "lum sphere lamp 0 0 4 0 0 4 .3\n"
    "void glow near 0 0 4 3 2 1 2\n"
    "near sphere bulb 0 0 4 2 2 .7 .2\n"
    "void plastic paint 0 0 5 .5 .4 .3 .1 .2\n"
    "void texfunc bump 4 .3*sin(5*Px) .3*cos(4*Py) 0 . 0 0\n"
    "bump plastic bumpy 0 0 5 .6 .4 .5 0 0\n"
    "bump plastic2 shiny 4 1 0 0 . 0 6 .3 .4 .5 .2 .1 .3\n"
    "void metal rough 0 0 5 .6 .5 .4 .9 .3\n"
    "void trans veil 0 0 7 .6 .7 .5 .1 .1 .5 .4\n"
    "void mixfunc mix 4 rough veil .5+.3*sin(7*Px) . 0 0\n"
    "void mirror mir 0 0 3 .8 .8 .7\n"
    "void glass gl 0 0 3 .9 .8 .7\n"
    "void dielectric di 0 0 5 .9 .8 .7 1.5 0\n"
    "void ashik2 ash 4 1 0 0 . 0 8 .2 .3 .4 .1 .1 .2 50 20\n"
    "void mist fog 1 lamp 0 7 .3 .5 .4 .8 .7 .6 .3\n"
    "paint polygon floor 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n"
    "bumpy polygon w1 0 0 12 -5 -5 0 -5 5 0 -5 5 3 -5 -5 3\n"
    "shiny polygon w2 0 0 12 5 -5 0 5 -5 3 5 5 3 5 5 0\n"
    "mix polygon w3 0 0 12 -5 5 0 5 5 0 5 5 3 -5 5 3\n"
    "mir polygon w4 0 0 12 -5 -5 0 -5 -5 3 3 -5 3 3 -5 0\n"
    "ash sphere s1 0 0 4 1 -1 .8 .5\n"
    "gl polygon pane 0 0 12 -2 -2 2 -2 2 2 2 2 2 2 -2 2\n"
    "di sphere s2 0 0 4 -2 0 .7 .5\n"
    "fog sphere cloud 0 0 4 -2 3 1 .8\n"
    "void brightfunc waves 2 1+.5*Dz+.3*sin(4*Dx) . 0 0\n"
    "waves glow sky_glow 0 0 4 1 1 2 0\n"
    "sky_glow source sky 0 0 4 0 0 1 180\n"
    "void glow gnd 0 0 4 .2 .2 .1 0\n"
    "gnd source ground 0 0 4 0 0 -1 180\n"
    "void light sun 0 0 3 1000 1000 900\n"
    "sun source sunny 0 0 4 1 .5 1 .5\n";
constexpr const char* bazaar_lights = " -m lum -m near -m sky_glow -m gnd -m sun ";

/// What rcontrib starts from and rtrace does not.
constexpr const char* same_as_rcontrib =
    " -dt 0 -dc .75 -dj .9 -ds .2 -dr 3 -dp 512 -ss 1 -st .02 -aa 0 -ar 256 -ad 350 -as 0 -ab 1 -lr -10 -lw "
    "2e-3 ";

struct Rcontrib : testing::Test {
    Folder folder;

    void scene(const std::string& text) {
        folder.write("scene.rad", text);
        const Outcome made = test::run(folder, "oconv -f scene.rad > scene.oct");
        ASSERT_EQ(made.status, 0) << made.err;
    }
    Outcome run(const std::string& program, const std::string& options, const std::string& rays) {
        folder.write("rays", rays);
        return test::run(folder, program + " " + options + " scene.oct < rays");
    }
    Outcome rcontrib(const std::string& options, const std::string& rays) {
        return run("rcontrib", options, rays);
    }
    std::string bazaar_rays() const {
        std::ostringstream rays;
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 4; ++j)
                rays << "0 -3.5 2.5 " << (i - 3.5) * .2 << " " << .25 + j * .25 << " " << j * .3 - .95
                     << "\n";
        return rays.str() + "0 -3.5 2.5 -.3 1 -.2\n0 -3.5 2.5 -.31 1 -.22\n";
    }

    /// The lights' contributions together are what rtrace sees, ray by ray, as both draw the same numbers.
    void expect_sum_of_contributions(const std::string& options) {
        const std::string rays = bazaar_rays();
        const Outcome parts = rcontrib("-h -w -V+ " + options + bazaar_lights, rays);
        const Outcome whole = run("rtrace", std::string("-h -w") + same_as_rcontrib + options, rays);
        ASSERT_EQ(parts.status, 0) << parts.err;
        ASSERT_EQ(whole.status, 0) << whole.err;
        Rows sums = rows_of(parts.out);
        for (std::vector<double>& row : sums) {
            std::vector<double> sum(3, 0.0);
            for (std::size_t i = 0; i < row.size(); ++i) sum[i % 3] += row[i];
            row = sum;
        }
        const Rows expected = rows_of(whole.out);
        ASSERT_EQ(sums.size(), expected.size());
        for (std::size_t r = 0; r < sums.size(); ++r)
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(sums[r][c], expected[r][c], 3e-6 * expected[r][c]) << options << " ray " << r;
    }
};

TEST_F(Rcontrib, follows_paths_to_lights_as_radiance_does) {
    scene(court);
    const std::string modifiers = "-h -ab 0 -dj 0 -m lum -m paint -m mir -m gl -m sky_glow -m sun";
    // RADIANCE's
    expect_rows(
        rcontrib("-V+ -i+ " + modifiers, court_rays).out,
        {{2.688721e-01, 4.812684e-01, 6.373035e-01, 3.087463e-01, 5.211426e-01, 6.731904e-01, 1.627205e-02,
          3.254410e-02, 4.881615e-02, 3.087463e-01, 5.211426e-01, 6.731904e-01, 0, 0, 0, 3.987426e-02,
          3.987426e-02, 3.588684e-02},
         {2.278570e-01, 4.557140e-01, 6.835710e-01, 2.677312e-01, 4.955883e-01, 7.194578e-01, 1.928459e-02,
          3.856918e-02, 5.785377e-02, 0, 0, 0, 0, 0, 0, 3.987426e-02, 3.987426e-02, 3.588684e-02},
         {1.171564e-01, 2.343127e-01, 3.514691e-01, 0, 0, 0, 1.171564e-01, 2.343127e-01, 3.514691e-01, 0, 0,
          0, 0, 0, 0, 0, 0, 0},
         {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0}},
        1e-5);
}

TEST_F(Rcontrib, gives_coefficients_or_what_arrives) {
    scene(court);
    // Down through nothing onto the floor: its mirror image of the sky and of the lamp.
    const std::string options = "-h -ab 0 -dj 0 -m sky_glow -m sun ";
    const Outcome coefficients = rcontrib(options, "2 1 3 .1 .2 -1");
    expect_rows(coefficients.out,
                {{5.041423e-02, 5.041423e-02, 5.041423e-02,  // RADIANCE's
                  5.921620e-06, 4.737296e-06, 3.552972e-06}},
                1e-5);
    const Outcome contributions = rcontrib("-V " + options, "2 1 3 .1 .2 -1");
    expect_rows(contributions.out,
                {{5.041423e-02, 5.041423e-02, 5.041423e-02,  //
                  5.921620e-03, 4.737296e-03, 3.197675e-03}},
                1e-5);
}

TEST_F(Rcontrib, knows_surfaces_by_the_names_that_radiance_does) {
    folder.write("part.rad", "void glow inner 0 0 4 1 2 3 0\ninner sphere p 0 0 4 0 0 0 1\n");
    folder.write("square.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nusemtl m1\nf 1 2 3\n");
    folder.write("square.rad", "void glow m1 0 0 4 1 1 1 0\n");
    ASSERT_EQ(
        test::run(folder, "oconv -f part.rad > part.oct && obj2mesh -a square.rad square.obj square.rtm")
            .status,
        0);
    scene(
        "void glow own 0 0 4 5 5 5 0\n"
        "void alias nick own\n"
        "void glow other 0 0 4 7 7 7 0\n"
        "void mixfunc mix 4 own other .25 . 0 0\n"
        "void brightfunc half 2 .5 . 0 0\n"
        "half glow dim 0 0 4 3 3 3 0\n"
        "void instance i1 5 part.oct -t 0 0 0 0 0\n"
        "own instance i2 5 part.oct -t 10 0 0 0 0\n"
        "void mesh k1 5 square.rtm -t 20 0 0 0 0\n"
        "own mesh k2 5 square.rtm -t 30 0 0 0 0\n"
        "nick sphere s1 0 0 4 40 0 0 1\n"
        "mix sphere s2 0 0 4 50 0 0 1\n"
        "dim sphere s3 0 0 4 60 0 0 1\n");
    std::string rays;
    for (int i = 0; i < 7; ++i) rays += std::to_string(10 * i) + ".5 -.1 3 0 0 -1\n";
    const auto seen = [&](const std::string& name) {
        std::string marks;
        for (const std::vector<double>& row : rows_of(rcontrib("-h -w -m " + name, rays).out))
            marks += row.at(0) == 1 ? '1' : row.at(0) == 0 ? '.' : '?';
        return marks;
    };
    EXPECT_EQ(seen("inner"), "1......");  // as RADIANCE
    EXPECT_EQ(seen("own"), ".1.1...");
    EXPECT_EQ(seen("m1"), "..1....");
    EXPECT_EQ(seen("nick"), "....1..");
    EXPECT_EQ(seen("mix"), ".....1.");
    EXPECT_EQ(seen("dim"), "......1");
    EXPECT_EQ(seen("other"), ".......");
    EXPECT_EQ(seen("half"), ".......");
}

TEST_F(Rcontrib, adds_up_to_what_rtrace_sees) {
    scene(bazaar);
    expect_sum_of_contributions("-ab 0");
    expect_sum_of_contributions("-ab 1 -ad 64");
    expect_sum_of_contributions("-ab 2 -ad 25 -lr 4 -lw 1e-4");
    expect_sum_of_contributions("-i+ -ab 1 -ad 64");
    expect_sum_of_contributions("-I+ -ab 1 -ad 64");
}

TEST_F(Rcontrib, gives_coefficients_of_radiances) {
    // Lights that look the same from everywhere.
    std::string even = bazaar;
    even.replace(even.find("waves glow sky_glow"), 5, "void");
    scene(even);
    const std::vector<double> radiances = {10, 20, 30, 3, 2, 1, 1, 1, 2, .2, .2, .1, 1000, 1000, 900};
    const std::string rays = bazaar_rays();
    for (const std::string options : {"-ab 0", "-ab 2 -ad 36", "-ab 1 -ad 64 -dv-", "-I+ -ab 1 -ad 64"}) {
        const Rows parts = rows_of(rcontrib("-h -w " + options + bazaar_lights, rays).out);
        const Rows whole =
            rows_of(run("rtrace", std::string("-h -w") + same_as_rcontrib + options, rays).out);
        ASSERT_EQ(parts.size(), whole.size());
        for (std::size_t r = 0; r < parts.size(); ++r)
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0;
                for (std::size_t i = c; i < radiances.size(); i += 3) sum += parts[r].at(i) * radiances[i];
                EXPECT_NEAR(sum, whole[r].at(c), 3e-6 * whole[r][c]) << options << " ray " << r;
            }
    }
}

TEST_F(Rcontrib, knows_the_weights_of_samples) {
    scene(bazaar);
    expect_sum_of_contributions("-ab 1 -ad 100 -ss 16");
    expect_sum_of_contributions("-ab 1 -ad 100 -gs 8");
}

TEST_F(Rcontrib, knows_what_media_take_and_scatter) {
    scene(bazaar);
    expect_sum_of_contributions("-ab 0 -ms .2");
    // A medium that fills all lets nothing through from infinity.
    expect_sum_of_contributions("-ab 1 -ad 36 -me .02 .03 .05 -ma .5 .4 .6 -mg .3 -ms 2");
}

TEST_F(Rcontrib, tells_bins_apart_by_the_hit) {
    scene(court);
    folder.write("halves.cal",
                 "{ which side of a plane through the origin }\n"
                 "nx = 1; ny = 0;\n"
                 "side = if(Px*nx + Py*ny, 1, 0);\n"
                 "Nsides : 2;\n");
    // Four places on the floor, one in each quadrant.
    const std::string rays = "3 3 1 0 0 -1 -3 3 1 0 0 -1 -3 -3 1 0 0 -1 3 -3 1 0 0 -1";
    const auto first_bins = [](const Outcome& result) {
        std::string marks;
        for (const std::vector<double>& row : rows_of(result.out))
            marks += row.at(0) == 1 ? '0' : row.at(3) == 1 ? '1' : '?';
        return marks + result.err;
    };
    const std::string start = "-h -ab 0 -f halves.cal ";
    EXPECT_EQ(first_bins(rcontrib(start + "-bn Nsides -b side -m paint", rays)), "1001");
    EXPECT_EQ(first_bins(rcontrib(start + "-bn Nsides -p nx=0,ny=1 -b side -m paint", rays)), "1100");
    EXPECT_EQ(first_bins(rcontrib(start + "-bn Nsides -p 'nx=-1; ny=+0' -b side -m paint", rays)), "0110");
    // Parameters belong to the modifiers that follow.
    EXPECT_EQ(first_bins(rcontrib(start + "-bn Nsides -b side -m paint -p nx=0,ny=1 -m gl", rays)), "1001");
    // Rounded to the nearest bin; those below -1/2 are left out.
    EXPECT_EQ(first_bins(rcontrib(start + "-bn 2 -b 'if(Px,.51,.49)' -m paint", rays)), "1001");
    EXPECT_EQ(first_bins(rcontrib(start + "-bn 2 -b 'if(Px,-.51,-.49)' -m paint", rays)), "?00?");
    const Outcome beyond = rcontrib(start + "-bn 2 -b 'if(Px,7,1)' -m paint", rays);
    EXPECT_EQ(first_bins(beyond),
              "?11?rcontrib: warning - 2 contributions ignored, their bins are not below -bn; one of them: "
              "bin 7 of "
              "'paint'\n");
}

TEST_F(Rcontrib, gives_bins_the_ray_as_radiance_does) {
    scene(court);
    // The expression's value goes through bins of a thousandth; RADIANCE's.
    const auto value = [&](const std::string& expression, const std::string& modifier,
                           const std::string& ray) {
        const Rows rows = rows_of(
            rcontrib("-h -w -ab 0 -dj 0 -bn 20001 -b '10000+1000*(" + expression + ")' -m " + modifier, ray)
                .out);
        for (std::size_t i = 0; i < rows.at(0).size(); i += 3)
            if (rows[0][i] != 0) return (static_cast<double>(i / 3) - 10000) / 1000;
        return -99.0;
    };
    const std::string onto_pane = "0 0 3 .6 0 -.8";
    EXPECT_EQ(value("Dx", "gl", onto_pane), .6);
    EXPECT_EQ(value("Dz", "gl", onto_pane), -.8);
    EXPECT_EQ(value("Px", "gl", onto_pane), .75);
    EXPECT_EQ(value("Pz", "gl", onto_pane), 2);
    EXPECT_EQ(value("T", "gl", onto_pane), 1.25);
    EXPECT_EQ(value("T", "paint", onto_pane), 3.75);  // from the eye, through the pane
    EXPECT_EQ(value("Ts", "paint", onto_pane), 2.5);
    EXPECT_EQ(value("Rdot", "paint", onto_pane), .8);
    EXPECT_EQ(value("Nz", "paint", onto_pane), 1);
    EXPECT_EQ(value("S", "paint", onto_pane), 1);
    EXPECT_EQ(value("Dz", "sun", "3 3 2 0 0 -1"), .667);  // the way of the shadow ray
}

TEST_F(Rcontrib, keeps_its_definitions_from_the_scene) {
    scene(
        "void brightfunc dim 2 shade . 0 0\n"
        "dim glow shine 0 0 4 1 1 1 0\n"
        "shine sphere ball 0 0 4 0 0 0 1\n");
    const std::string ray = "0 0 5 0 0 -1";
    // A name that ends in a back-quote is everybody's.
    expect_rows(rcontrib("-h -V -e 'shade`:.25;other=1' -b 'other*0' -bn 1 -m shine", ray).out,
                {{.25, .25, .25}}, 0);
    const Outcome apart = rcontrib("-h -V -e 'shade:.25' -m shine", ray);
    EXPECT_EQ(apart.status, 1);
    EXPECT_NE(apart.err.find("undefined variable \"shade\""), apart.err.npos) << apart.err;
}

TEST_F(Rcontrib, fills_bins_of_a_sky_by_their_projected_solid_angles) {
    scene(
        "void glow sky_glow 0 0 4 1 1 1 0\n"
        "sky_glow source sky 0 0 4 0 0 1 180\n");
    // Bands of 30 degrees of altitude from the horizontal sensor: pi (sin^2 b - sin^2 a).
    std::string rays;
    for (int i = 0; i < 200; ++i) rays += "0 0 0 0 0 1\n";
    const Outcome result =
        rcontrib("-h -I+ -c 200 -ab 1 -ad 400 -bn 3 -b 'floor(asin(Dz)/PI*6)' -m sky_glow", rays);
    ASSERT_EQ(rows_of(result.out).size(), 1u) << result.err;
    const std::vector<double> bins = rows_of(result.out)[0];
    // 80 000 rays, stratified: less noise than sqrt(p (1-p) / 80000) = 0.0018 of pi; four of those.
    const double shares[] = {.25, .5, .25};
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(bins[3 * i], std::numbers::pi * shares[i], std::numbers::pi * .007) << i;
    EXPECT_NEAR(bins[0] + bins[3] + bins[6], std::numbers::pi, 1e-5);
}

TEST_F(Rcontrib, gives_the_same_with_any_number_of_threads) {
    scene(bazaar);
    const std::string rays = bazaar_rays();
    for (const std::string records : {"-c 1", "-c 7", "-c 0"}) {
        const std::string options = "-h -w -fad -ab 1 -ad 64 " + records + bazaar_lights;
        const std::string one = rcontrib(options, rays).out;
        EXPECT_FALSE(one.empty());
        EXPECT_EQ(one, rcontrib("-n 3 " + options, rays).out) << records;
    }
}

TEST_F(Rcontrib, accumulates_rays) {
    scene(court);
    const std::string rays = "3 3 1 0 0 -1 3 3 1 0 0 1 3 3 1 0 0 1 3 3 1 0 0 1 3 3 1 0 0 -1";
    const std::string modifiers = " -ab 0 -m paint";
    expect_rows(rcontrib("-h -c 4" + modifiers, rays).out, {{.25, .25, .25}, {1, 1, 1}}, 0);
    EXPECT_EQ(rcontrib("-h -c 4" + modifiers, rays).err,
              "rcontrib: warning - partial accumulation in final record\n");
    expect_rows(rcontrib("-h -c 0" + modifiers, rays).out, {{2, 2, 2}}, 0);
    // A ray without a direction makes a record of nothing, or a part of one.
    expect_rows(rcontrib("-h" + modifiers, "3 3 1 0 0 -1 0 0 0 0 0 0").out, {{1, 1, 1}, {0, 0, 0}}, 0);
    expect_rows(rcontrib("-h -c 2" + modifiers, "3 3 1 0 0 -1 0 0 0 0 0 0").out, {{.5, .5, .5}}, 0);
    EXPECT_EQ(rcontrib("-h -c 0" + modifiers, "3 3 1 0 0 -1 0 0 0 0 0 0").err,
              "rcontrib: warning - dummy rays are ignored during accumulation\n");
    expect_rows(rcontrib("-h -c 0" + modifiers, "").out, {{0, 0, 0}}, 0);
}

TEST_F(Rcontrib, writes_headers_that_tell_rows_and_columns) {
    scene(court);
    const std::string rays = "3 3 1 0 0 -1 3 3 1 0 0 1";
    const Outcome text = rcontrib("-ab 0 -y 2 -bn 2 -b 'if(Dz,1,0)' -m paint -m gl", rays);
    EXPECT_NE(text.out.find("\nNCOMP=3\nNROWS=2\nNCOLS=4\nFORMAT=ascii\n\n1.0"), text.out.npos) << text.out;
    EXPECT_EQ(rcontrib("-fad -ab 0 -o %s_%02d.dat -bn 2 -b 'if(Dz,1,0)' -m paint", rays).status, 0);
    EXPECT_NE(folder.read("paint_01.dat")
                  .find("\nNCOMP=3\nMODIFIER=paint\nBIN=1\nNCOLS=1\nBigEndian=0\nFORMAT=double\n\n"),
              std::string::npos)
        << folder.read("paint_01.dat");
    EXPECT_EQ(rcontrib("-fac -x 1 -y 2 -ab 0 -o %s.hdr -m paint", rays).status, 0);
    const std::string picture = folder.read("paint.hdr");
    const std::string end =
        "\nNCOMP=3\nMODIFIER=paint\nNROWS=2\nFORMAT=32-bit_rle_rgbe\n\n-Y        2 +X        1\n"
        "\x80\x80\x80\x81";
    EXPECT_TRUE(picture.ends_with(end + std::string(4, '\0'))) << picture;
}

TEST_F(Rcontrib, writes_where_it_is_told) {
    scene(court);
    const std::string ray = "3 3 1 0 0 -1";
    const Outcome split =
        rcontrib("-h -ab 0 -m gl -o floor.txt -m paint -o '!cat > piped_%s.txt' -m mir -m sun", ray);
    EXPECT_EQ(split.status, 0) << split.err;
    expect_rows(split.out, {{0, 0, 0}}, 0);
    expect_rows(folder.read("floor.txt"), {{1, 1, 1}}, 0);
    expect_rows(folder.read("piped_mir.txt"), {rows_of(folder.read("piped_mir.txt")).at(0)}, 0);
    EXPECT_TRUE(folder.has("piped_sun.txt"));
    const Outcome again = rcontrib("-h -ab 0 -o floor.txt -m gl", ray);
    EXPECT_EQ(again.status, 2);
    EXPECT_EQ(
        again.err,
        "rcontrib: cannot open 'floor.txt' for writing: it exists (-fo writes over it, -r goes on where it "
        "ends)\n");
    expect_rows(folder.read("floor.txt"), {{1, 1, 1}}, 0);
    EXPECT_EQ(rcontrib("-h -ab 0 -fo+ -o floor.txt -m gl -m paint", ray).status, 0);
    expect_rows(folder.read("floor.txt"), {{0, 0, 0, 1, 1, 1}}, 0);
    const Outcome failed = rcontrib("-h -ab 0 -o '!cat > rest; exit 3' -m gl", ray);
    EXPECT_EQ(failed.status, 2);
    EXPECT_EQ(failed.err, "rcontrib: the command '!cat > rest; exit 3' failed\n");
}

TEST_F(Rcontrib, answers_each_ray_at_once_with_x_1) {
    scene(court);
    const Outcome result =
        test::run(folder,
                  "mkfifo in out; rcontrib -h -ab 0 -x 1 -m paint scene.oct < in > out & exec 3> in 4< out\n"
                  "echo 3 3 1 0 0 -1 >&3; read -r a <&4; echo 3 3 1 0 0 1 >&3; read -r b <&4\n"
                  "exec 3>&-; wait; echo $a $b");
    EXPECT_EQ(rows_of(result.out), (Rows{{1, 1, 1, 0, 0, 0}})) << result.err;
}

TEST_F(Rcontrib, goes_on_where_it_was_stopped) {
    scene(bazaar);
    const std::string rays = bazaar_rays();
    const std::string options = " -fad -ab 1 -ad 16 -c 2 -o %s.dat -m sky_glow -m sun";
    const std::string command = "rcontrib -w- -r" + options + " scene.oct < rays";
    ASSERT_EQ(rcontrib("-w-" + options, rays).status, 0);
    const std::string sky = folder.read("sky_glow.dat"), sun = folder.read("sun.dat");
    // One file has lost a record and a half, the other three. The headers name the command that made the
    // files.
    folder.write("sky_glow.dat", sky.substr(0, sky.size() - 36));
    folder.write("sun.dat", sun.substr(0, sun.size() - 72));
    const Outcome resumed = test::run(folder, command);
    EXPECT_EQ(resumed.status, 0) << resumed.err;
    EXPECT_EQ(folder.read("sky_glow.dat"), sky);
    EXPECT_EQ(folder.read("sun.dat"), sun);
    EXPECT_EQ(rcontrib("-r -y 17" + options, rays).err,
              "rcontrib: warning - output appears to be complete\n");
    EXPECT_EQ(rcontrib("-r -ff -m sun", rays).err,
              "rcontrib: cannot recover from the standard output (-r needs files, given with -o)\n");
    EXPECT_EQ(rcontrib("-r -o a.txt -m sun", rays).err,
              "rcontrib: cannot recover ASCII output (-ff, -fd or -fc write records of a fixed size)\n");
    EXPECT_EQ(rcontrib("-r -fac -o %s.dat -m sun", rays).err,
              "rcontrib: 'sun.dat' is no output of this kind (its format is not 32-bit_rle_rgbe)\n");
}

TEST_F(Rcontrib, adds_to_sums_of_earlier_runs) {
    scene(
        "void glow sky_glow 0 0 4 1 1 1 0\n"
        "sky_glow source sky 0 0 4 0 0 1 180\n");
    const std::string ray = "3 3 4 0 0 1";
    const std::string options =
        "-h -w -I+ -ab 1 -ad 64 -c 0 -r -o sum.txt -bn 2 -b 'if(Dx-.33,1,0)' -m sky_glow";
    std::vector<double> previous(2, 0.0);
    std::vector<double> added;
    for (int i = 0; i < 3; ++i) {
        ASSERT_EQ(rcontrib(options, ray).status, 0);
        const Rows sums = rows_of(folder.read("sum.txt"));
        ASSERT_EQ(sums.size(), 1u);
        EXPECT_NEAR(sums[0][0] + sums[0][3], (i + 1) * std::numbers::pi, 1e-5);
        added.push_back(sums[0][0] - previous[0]);
        previous = {sums[0][0], sums[0][3]};
    }
    EXPECT_GT(std::fabs(added[1] - added[0]) + std::fabs(added[2] - added[1]), 1e-3)
        << "the same noise again";
}

TEST_F(Rcontrib, carries_spectra) {
    scene(
        "void spectrum two 0 0 5 400 700 .2 .4 .8\n"
        "two glow shine 0 0 4 1 1 1 0\n"
        "shine sphere ball 0 0 4 0 0 0 1\n");
    const Outcome result = rcontrib("-cs 4 -cw 400 700 -V -m shine", "0 0 5 0 0 -1");
    EXPECT_NE(result.out.find("\nNCOMP=4\nWAVELENGTH_SPLITS="), result.out.npos) << result.out;
    const std::string numbers = result.out.substr(result.out.rfind("\n\n") + 2);
    const Rows rows = rows_of(numbers);
    ASSERT_EQ(rows.at(0).size(), 4u);
    EXPECT_GT(rows[0][0], rows[0][3]);  // longest wavelengths first
}

TEST_F(Rcontrib, refuses_what_makes_no_sense) {
    scene(court);
    const auto message = [&](const std::string& options) {
        const Outcome result = rcontrib(options, "3 3 1 0 0 -1");
        EXPECT_NE(result.status, 0) << options;
        return result.err;
    };
    EXPECT_EQ(message("-ab 0"), "rcontrib: missing required modifier argument (-m name or -M file)\n");
    EXPECT_EQ(message("-m gl -m gl"), "rcontrib: duplicate modifier 'gl'\n");
    EXPECT_EQ(message("-m void"),
              "rcontrib: cannot track 'void' modifier (surfaces without a modifier are not seen)\n");
    EXPECT_EQ(
        message("-b 1 -m gl"),
        "rcontrib: illegal non-zero constant for bin (1) (an expression of Dx, Px and their kin tells bins "
        "apart)\n");
    EXPECT_EQ(message("-b Dx -m gl"),
              "rcontrib: unspecified or illegal bin count for modifier 'gl' (give -bn before -m)\n");
    EXPECT_EQ(message("-o o%q -m gl"),
              "rcontrib: bad output format 'o%q' (%s stands for the modifier, %d for the bin, each once)\n");
    EXPECT_EQ(message("-p MF= -m gl"),
              "rcontrib: bad parameter list 'MF=' (names and numbers, as in -p MF=4,RHS=-1)\n");
    EXPECT_EQ(
        message("-ap map -m gl"),
        "rcontrib: command line error at '-ap': option is not supported (contribution photon maps (mkpmap "
        "-apC) are not read yet)\n");
    EXPECT_EQ(message("-y 3 -ab 0 -m gl"),
              "rcontrib: unexpected EOF on input (-x, -y and -c say how many rays there are to be)\n");
    EXPECT_NE(message("-b 'nosuch' -bn 2 -ab 0 -m paint").find("undefined variable \"nosuch"),
              std::string::npos);
    EXPECT_EQ(rcontrib("-ab 0 -m none", "").err, "rcontrib: warning - no surface has the modifier 'none'\n");
}

}  // namespace
}  // namespace infra
