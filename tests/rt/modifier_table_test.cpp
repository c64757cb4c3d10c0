// What every row of the modifier table has to keep, with an example of each type: a row without one fails.
#include "rt/compile/modifier_table.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "bsdf/bsdf_text.h"
#include "common/planck/planck.h"
#include "rt/materials/scattering.h"
#include "rt/materials/surface_material.h"
#include "scene_pieces.h"
#include "test_data.h"
#include "test_tables.h"

namespace infra {
namespace {

using enum PrimitiveType;

using test::degree;

struct Example {
    PrimitiveType type;
    std::string text;     ///< defines the modifier "m"
    double emission = 0;  ///< radiance that it sends out by itself
    double squeezed = 1;  ///< radiance behind it per radiance before it: the square of a body's index
};

std::vector<Example> examples(const test::TemporaryFolder& folder) {
    std::vector<Example> all = {
        {plastic, "void plastic m 0 0 5 .7 .5 .3 0 0"},
        {plastic, "void plastic m 0 0 5 .7 .5 .3 .05 0"},
        {plastic, "void plastic m 0 0 5 1 1 1 .3 .2"},
        {metal, "void metal m 0 0 5 .7 .5 .3 .9 0"},
        {metal, "void metal m 0 0 5 1 .5 .3 1 .3"},
        {trans, "void trans m 0 0 7 .9 .8 .7 .05 0 .5 .5"},
        {trans, "void trans m 0 0 7 1 1 1 .1 .2 .6 .4"},
        {plastic2, "void plastic2 m 4 1 .3 0 . 0 6 .5 .4 .3 .2 .1 .3"},
        {metal2, "void metal2 m 4 -Py Px .2 . 0 6 1 .6 .4 .9 .3 .05"},
        {trans2, "void trans2 m 4 0 1 0 . 0 8 .9 .8 .7 .1 .15 .3 .6 .5"},
        {ashik2, "void ashik2 m 4 1 .3 0 . 0 8 0 0 0 .5 .4 .3 20 150"},
        {glass, "void glass m 0 0 3 .96 .9 .8"},
        {glass, "void glass m 0 0 4 1 1 1 1.3"},
        {dielectric, "void dielectric m 0 0 5 1 1 1 1.5 0", 0, 2.25},
        {interface, "void interface m 0 0 8 1 1 1 1.6 1 1 1 1.25", 0, 1.28 * 1.28},
        {mist, "void mist m 0 0 0"},
        {antimatter, "void plastic other 0 0 5 .5 .5 .5 0 0 void antimatter m 1 other 0 0"},
        {light, "void light m 0 0 3 2 2 2", 2},
        {glow, "void glow m 0 0 4 2 2 2 0", 2},
        {glow, "void glow m 0 0 4 2 2 2 5", 2},
        {illum, "void illum m 0 0 3 2 2 2"},
        {illum, "void plastic shown 0 0 5 .5 .5 .5 0 0 void illum m 1 shown 0 3 2 2 2"},
        {spotlight, "void spotlight m 0 0 7 2 2 2 90 0 0 1", 2},
        {emissive, "void emissive m 0 0 3 2 2 2", 2},
        {emissive, "void plastic skin 0 0 5 .5 .5 .5 .1 .1 void emissive m 1 skin 0 3 2 2 2", 2},
        {thermal, "void thermal m 0 0 3 300 8 12", band_radiance(300, 8, 12)},
        {brightfunc, "void brightfunc half 2 if(Px,.5,1) . 0 0 half plastic m 0 0 5 1 1 1 0 0"},
        {colorfunc, "void colorfunc tint 4 .5 .6 Py*Py/(1+Py*Py) . 0 0 tint plastic m 0 0 5 1 1 1 0 0"},
        {texfunc, "void texfunc waves 4 .3*sin(9*Px) .2 0 . 0 0 waves plastic m 0 0 5 1 1 1 .2 .1"},
        {mixfunc,
         "void plastic a 0 0 5 1 1 1 0 0 void metal b 0 0 5 .5 .5 .5 1 0 void mixfunc m 4 a b .3 . 0 0"},
        {mixfunc, "void plastic a 0 0 5 1 1 1 0 0 void mixfunc m 4 a void .5 . 0 0"},
        {mirror, "void mirror m 0 0 3 .9 .8 .7"},
        {mirror, "void plastic shown 0 0 5 .5 .5 .5 .1 .1 void mirror m 1 shown 0 3 .9 .8 .7"},
        {mirror, "void mirror m 1 void 0 3 1 1 1"},
        {prism1, "void prism1 m 5 .8 Dx+.3 Dy Dz . 0 0"},
        {prism2, "void prism2 m 9 .5 Dx+.3 Dy Dz .4 -Dx Dy Dz . 0 0"},
    };
    for (const char* type : {"plasfunc", "metfunc"})
        all.push_back(
            {*find_primitive_type(type), "void " + std::string(type) + " m 2 noneg . 0 4 .7 .5 .3 .2"});
    all.insert(
        all.end(),
        {{transfunc, "void transfunc m 2 abs . 0 6 .9 .8 .7 .1 .5 .5"},
         {BRTDfunc,
          "void BRTDfunc m 10 .1 .2 .3*RdotP .2 .1 if(Rdot,.1,.2) abs noneg 0 . 0 9 .1 .2 .3 .4 "
          ".2 .1 .05 .1 .15"},
         {WGMDfunc, "void WGMDfunc m 13 void .2 .1 .3 void 0 0 0 void 1 0 0 . 0 9 .5 .4 .3 .2 .3 .4 0 0 0"},
         {WGMDfunc,
          "void brightfunc dim 2 .5 . 0 0 dim WGMDfunc m 13 void .2 0 0 inherit .3 .1 .2 dim 0 1 0 . "
          "0 9 .3 .2 .1 .2 .3 .4 .1 .1 .1"}});
    const test::DataFiles data = test::write_data(folder);
    const std::string font = INFRA_SOURCE_DIR "/lib/helvet.fnt";
    const std::string white = " plastic m 0 0 5 1 1 1 0 0";
    const std::string both = "void plastic a 0 0 5 1 1 1 0 0 void metal b 0 0 5 .5 .5 .5 1 0 void ";
    all.insert(all.end(),
               {{brightdata, "void brightdata map 5 noop " + data.map + " . Px+1 Py 0 0 map" + white},
                {colordata, "void colordata map 9 red green blue " + data.map + " " + data.map + " " +
                                data.map + " . Px Py 0 0 map" + white},
                {colorpict,
                 "void colorpict map 7 clip_r clip_g clip_b " + data.picture + " . Px Py 0 0 map" + white},
                {spectrum, "void spectrum s 0 0 6 380 780 .5 .6 .5 .4 s" + white},
                {specfile, "void specfile s 1 " + data.spectrum + " 0 0 s" + white},
                {specfunc, "void specfunc s 2 clip . 0 2 400 700 s" + white},
                {specdata, "void specdata s 5 min " + data.spectra + " . Px Py 0 0 s" + white},
                {specpict, "void specpict s 5 min " + data.spectral_picture + " . Px Py 0 0 s" + white},
                {texdata, "void texdata bumps 9 red green blue " + data.map + " " + data.map + " " +
                              data.map + " . Px Py 0 0 bumps plastic m 0 0 5 1 1 1 .2 .1"},
                {plasdata, "void plasdata m 5 noop " + data.map + " . clip clip 0 4 .7 .5 .3 .2"},
                {metdata, "void metdata m 5 noop " + data.map + " . clip clip 0 4 .7 .5 .3 .2"},
                {transdata, "void transdata m 5 noop " + data.map + " . clip clip 0 6 .9 .8 .7 .1 .5 .5"},
                {mixdata, both + "mixdata m 7 a b noop " + data.map + " . Px Py 0 0"},
                {mixpict, both + "mixpict m 7 a b grey " + data.picture + " . Px Py 0 0"},
                {brighttext, "void brighttext t 3 " + font + " . AA 0 11 -1 1 0 1 0 0 0 -2 0 1 .5 t" + white},
                {colortext,
                 "void colortext t 3 " + font + " . AA 0 15 -1 1 0 1 0 0 0 -2 0 1 .5 .6 .2 .3 .9 t" + white},
                {mixtext, both + "mixtext m 5 a b " + font + " . AA 0 9 -1 1 0 1 0 0 0 -2 0"}});
    const auto reflection = test::disk_lobe(0.05, 0.8, 0.1), transmission = test::disk_lobe(0.02, 0.6, 0.2);
    test::write_file(folder / "matrix.xml", test::matrix_file(reflection, transmission));
    test::write_file(folder / "tree.xml", test::tree_file(4, reflection, transmission));
    test::write_file(folder / "holes.xml", test::matrix_file(reflection, test::disk_lobe(0.01, 3, 0.005)));
    all.insert(all.end(), {{BSDF, "void BSDF m 6 0 " + (folder / "matrix.xml") + " 0 1 .3 . 0 0"},
                           {BSDF, "void BSDF m 6 .2 " + (folder / "tree.xml") +
                                      " 0 1 .3 . 0 9 .1 .1 .1 .2 .1 0 .1 .1 .1"},
                           {aBSDF, "void aBSDF m 5 " + (folder / "holes.xml") + " 0 1 .3 . 0 0"}});
    for (const auto& table : test::write_tables(folder)) {
        all.push_back({nrlbrdf, "void nrlbrdf m 1 " + table.path + " 0 5 1 1 .5 4 .2"});
        all.push_back({nrlbrdf, "void nrlbrdf m 1 " + table.path + " 0 8 1 1 .5 4 .2 2 2 2", 2});
    }
    return all;
}

TEST(ModifierTable, HasARowOnceForEachTypeAndAllAreModifiers) {
    std::set<PrimitiveType> seen;
    for (const ModifierRow& row : modifier_table()) {
        EXPECT_TRUE(info(row.type).is_modifier()) << name(row.type);
        EXPECT_TRUE(seen.insert(row.type).second) << name(row.type) << " stands twice";
        EXPECT_EQ(find_modifier_row(row.type), &row);
    }
    EXPECT_EQ(find_modifier_row(sphere), nullptr);
}

TEST(ModifierTable, HasAnExampleForEachRow) {
    const test::TemporaryFolder folder;
    std::set<PrimitiveType> shown;
    for (const Example& example : examples(folder)) shown.insert(example.type);
    for (const ModifierRow& row : modifier_table())
        EXPECT_TRUE(shown.contains(row.type)) << name(row.type) << ": add an example to this test";
}

// In a surrounding of radiance 1 nothing but emission may bring more than 1 back, from either side.
TEST(EveryModifier, ReflectsAndTransmitsNoMoreThanItGets) {
    const test::TemporaryFolder folder;
    for (const Example& example : examples(folder)) {
        test::TracedScene scene(example.text + test::plate + test::surrounding(1), test::bounce_settings(4));
        for (const double angle : {0.0, 45.0, 60.0, 80.0, 85.0})
            for (const double side : {1.0, -1.0}) {
                const Vec3 to_viewer = test::direction(angle * degree, 0.4) * side;
                const auto seen = scene.mean_radiance(2000, Vec3{0.1, 0.2, 0} + to_viewer * 3.0, -to_viewer);
                EXPECT_LE(seen.mean, example.emission + example.squeezed + 3 * seen.error + test::rounding)
                    << example.text << " at " << angle << " deg, side " << side;
                EXPECT_GE(seen.mean, 0) << example.text;
            }
        EXPECT_EQ(scene.tracer().bad_values(), 0u) << example.text;
    }
}

TEST(EveryModifier, ShowsItsEmissionWhereNothingElseShines) {
    const test::TemporaryFolder folder;
    for (const Example& example : examples(folder)) {
        test::TracedScene scene(example.text + test::plate, test::bounce_settings(1));
        EXPECT_EQ(scene.radiance({0.1, 0.2, 3}, {0, 0, -1})[0], static_cast<float>(example.emission))
            << example.text;
    }
}

// VALIDATION V3: as warm as its surroundings, and with the emissivity that its reflection leaves, no material
// can be told from them.
TEST(EveryMaterial, OfOneTemperatureIsInvisibleInAFurnace) {
    const test::TemporaryFolder folder;
    const double black = band_radiance(300, 8, 12);
    int tested = 0;
    for (const Example& example : examples(folder)) {
        if (example.emission > 0 || example.type == illum) continue;
        SCOPED_TRACE(example.text);
        ++tested;
        test::TracedScene scene(example.text +
                                    "\nvoid thermal skin 1 m 0 3 300 8 12 skin sphere ball 0 0 4 0 0 0 .5\n"
                                    "void thermal wall 0 0 3 300 8 12 wall bubble room 0 0 4 0 0 0 2\n",
                                test::path_settings());
        const auto seen = scene.mean_radiance(8000, [](RandomStream& random) {
            const Vec3 origin = test::direction(std::acos(1 - 2 * random.uniform()), 6 * random.uniform());
            const Vec3 to = test::direction(std::acos(1 - 2 * random.uniform()), 6 * random.uniform());
            return test::RaySpec{origin, to * 0.45 - origin};
        });
        test::expect_close(seen, black, 1e-3);
    }
    EXPECT_GE(tested, 12);
}

// Light comes through them, though not straight and so without a part in what transparency decides.
bool only_diffuses_light(PrimitiveType type) { return type == transfunc || type == transdata; }

// The material of a scene's first surface, where it scatters.
const SurfaceMaterial* scattering_material(const CompiledScene& scene) {
    return dynamic_cast<const SurfaceMaterial*>(scene.finish(0).modifier);
}

TEST(EveryMaterial, EvaluatesToFiniteValuesAndOpaqueOnesToNoneBelow) {
    const test::TemporaryFolder folder;
    int tested = 0;
    for (const Example& example : examples(folder)) {
        test::TracedScene scene(example.text + test::plate, test::bounce_settings(1));
        const SurfaceMaterial* material = scattering_material(scene.compiled());
        if (!material) continue;
        ++tested;
        RandomStream random(1, 1);
        for (int n = 0; n < 500; ++n) {
            Ray ray(3);
            const Vec3 wo =
                test::direction(std::acos(random.uniform()), 2 * std::numbers::pi * random.uniform());
            ray.origin = wo;
            ray.direction = -wo;
            Interaction at(ray);
            at.distance = 1;
            at.point = {0, 0, 0};
            at.normal = {0, 0, 1};
            at.cosine = wo.z;
            at.surface = 0;
            Scattering scattering(at.perturbed_normal(), 3);
            material->scatter(scene.tracer(), at, false, scattering);
            const Vec3 wi =
                test::direction(std::acos(1 - 2 * random.uniform()), 2 * std::numbers::pi * random.uniform());
            Spectrum f(3);
            for (const double omega : {0.0, 1e-4, 0.1}) {
                scattering.eval(wi, omega, true, f);
                for (int c = 0; c < 3; ++c) {
                    EXPECT_TRUE(std::isfinite(f[c])) << example.text;
                    EXPECT_GE(f[c], 0.0f) << example.text;
                    const bool below =
                        wi.z < 0 && !material->traits()->transparent && !only_diffuses_light(example.type);
                    EXPECT_TRUE(!below || f[c] == 0.0f) << example.text << ": light from below";
                }
            }
        }
    }
    EXPECT_GE(tested, 10);
}

}  // namespace
}  // namespace infra
