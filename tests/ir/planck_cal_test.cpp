// lib/planck.cal against the library.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "cal/evaluator.h"
#include "cal/library.h"
#include "cal/ray_library.h"
#include "common/format.h"
#include "common/planck/planck.h"

namespace infra::ir {
namespace {

double value_of(const std::string& expression) {
    cal::Library library = cal::make_ray_library();
    const std::string context = library.load_function_file("planck.cal", {});
    const cal::ExprId id = library.compile(expression, {}, context);
    return cal::Evaluator(library.link()).evaluate(id, cal::Host{});
}

constexpr std::array<std::pair<double, double>, 8> bands = {
    {{3, 5}, {8, 12}, {8, 14}, {0.2, 1000}, {9.99, 10}, {3.7, 4.2}, {100, 1000}, {0.2, 0.4}}};

TEST(PlanckCal, AgreesWithTheLibrary) {
    for (const auto& [lo, hi] : bands) {
        for (const double kelvin : {150.0, 250.0, 300.0, 600.0, 3000.0}) {
            const std::string arguments = formatted("%.17g,%.17g,%.17g)", kelvin, lo, hi);
            const double radiance = band_radiance(kelvin, lo, hi);
            EXPECT_NEAR(value_of("planck_band(" + arguments) / radiance, 1, 1e-9) << arguments;
            EXPECT_NEAR(value_of("planck_slope(" + arguments) / band_radiance_slope(kelvin, lo, hi), 1, 1e-9)
                << arguments;
            EXPECT_NEAR(value_of("planck_um(" + formatted("%.17g,%.17g)", kelvin, lo)) /
                            spectral_radiance(kelvin, lo),
                        1, 1e-9);
            EXPECT_NEAR(value_of("planck_temperature(" + formatted("%.17g,%.17g,%.17g)", radiance, lo, hi)),
                        kelvin, 1e-6)
                << arguments;
        }
    }
}

TEST(PlanckCal, GivesTheValidationTable) {
    EXPECT_NEAR(value_of("planck_band(250,3,5)"), 0.21703, 5.1e-6);
    EXPECT_NEAR(value_of("planck_band(300,8,12)"), 38.50042, 5.1e-6);
    EXPECT_NEAR(value_of("planck_band(350,8,14)"), 106.44447, 5.1e-6);
    EXPECT_NEAR(value_of("planck_fraction(2898)"), 0.250106, 5.1e-7);
    EXPECT_NEAR(value_of("planck_fraction(10000)"), 0.914157, 5.1e-7);
    EXPECT_NEAR(value_of("planck_fraction(1e5)"), blackbody_fraction(1e5), 1e-12);
}

TEST(PlanckCal, FindsTemperaturesFarFromItsStart) {
    for (const double kelvin : {20.0, 5772.0, 50000.0})
        EXPECT_NEAR(
            value_of(formatted("planck_temperature(%.17g,8,12)", band_radiance(kelvin, 8, 12))) / kelvin, 1,
            1e-8);
}

}  // namespace
}  // namespace infra::ir
