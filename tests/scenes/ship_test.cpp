// The frigate of scenes/ship: its plates are plane, its temperatures are those of a ship, and it renders.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "common/planck/planck.h"
#include "common/vec.h"
#include "programs/command.h"

namespace infra {
namespace {

using test::Folder;
using test::run;

const std::string scene = INFRA_SOURCE_DIR "/scenes/ship/";
const std::string python = "PYTHONDONTWRITEBYTECODE=1 python3 " + scene;

struct Plate {
    std::string part;
    double temperature = 0;     ///< kelvin
    std::vector<Vec3> corners;  ///< of a polygon, none of a cone
};

/// The plates of a .rad text that make_frigate.py wrote: `modifier type name 0 0 n numbers`.
std::vector<Plate> read_plates(const std::string& text) {
    std::map<std::string, double> temperatures;
    std::vector<Plate> plates;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string modifier, type, name, skipped;
        words >> modifier >> type >> name;
        if (modifier.starts_with('#')) continue;
        if (type == "thermal") {
            std::string material;
            words >> skipped >> material >> skipped >> skipped >> temperatures[name];
            continue;
        }
        std::size_t count = 0;
        words >> skipped >> skipped >> count;
        Plate plate{name.substr(0, name.find('.')), temperatures.at(modifier), {}};
        std::vector<double> numbers(count);
        for (double& number : numbers) words >> number;
        if (type == "polygon")
            for (std::size_t i = 0; i < count; i += 3)
                plate.corners.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
        plates.push_back(std::move(plate));
    }
    return plates;
}

/// The largest distance of a corner from the plane through the middle.
double warp(const std::vector<Vec3>& corners) {
    Vec3 normal{}, middle{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        normal += cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
        middle += corners[i] / static_cast<double>(corners.size());
    }
    double largest = 0;
    for (const Vec3& corner : corners)
        largest = std::max(largest, std::abs(dot(normalize(normal), corner - middle)));
    return largest;
}

/// One ship for all tests.
class Ship : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<Folder>();
        const auto made = run(*folder_, python + "make_frigate.py --panel 6 > frigate.rad");
        ASSERT_EQ(made.status, 0) << made.err;
        plates_ = read_plates(folder_->read("frigate.rad"));
        ASSERT_GT(plates_.size(), 500U);
    }
    static void TearDownTestSuite() { folder_.reset(); }

    std::vector<double> temperatures_of(const std::string& part) const {
        std::vector<double> found;
        for (const Plate& plate : plates_)
            if (plate.part == part) found.push_back(plate.temperature);
        EXPECT_FALSE(found.empty()) << part;
        return found;
    }
    double hottest(const std::string& part) const { return std::ranges::max(temperatures_of(part)); }

    inline static std::unique_ptr<Folder> folder_;
    inline static std::vector<Plate> plates_;
};

TEST_F(Ship, EveryPolygonIsPlane) {
    for (const Plate& plate : plates_)
        if (!plate.corners.empty()) {
            EXPECT_LT(warp(plate.corners), 1e-4) << plate.part;
        }
}

TEST_F(Ship, IsAsWarmAsAShip) {
    EXPECT_GT(hottest("uptake"), hottest("rim"));
    EXPECT_GT(hottest("rim"), hottest("funnel"));
    EXPECT_GT(hottest("funnel"), hottest("hull") + 30);
    for (const double kelvin : temperatures_of("waterline")) EXPECT_NEAR(kelvin, 286.5, 5);
    for (const Plate& plate : plates_) {
        EXPECT_GT(plate.temperature, 280) << plate.part;
        EXPECT_LT(plate.temperature, 600) << plate.part;
    }
}

TEST_F(Ship, IsWarmerTowardsTheSun) {
    double sunny = 0, shady = 0;
    int sunny_count = 0, shady_count = 0;
    for (const Plate& plate : plates_) {
        if (plate.part != "house" || std::abs(plate.corners[0].y) < 4) continue;
        (plate.corners[0].y < 0 ? sunny : shady) += plate.temperature;
        ++(plate.corners[0].y < 0 ? sunny_count : shady_count);
    }
    EXPECT_GT(sunny / sunny_count, shady / shady_count + 4);
}

TEST_F(Ship, RendersItsTemperatures) {
    const auto outcome =
        run(*folder_,
            "for name in paint deck; do brdftab -lambert .1 -n 4 4 4 -o $name.brdf > report || exit 1; done\n"
            "oconv " +
                scene +
                "materials.rad frigate.rad > ship.oct &&\n"
                "echo -7.6 0 60 0 0 -1 | rtrace -h -ab 1 -aa 0 -ad 64 -as 0 -ovm ship.oct");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    std::istringstream words(outcome.out);
    double radiance = 0;
    std::string rest, modifier;
    words >> radiance >> rest >> rest >> modifier;
    ASSERT_TRUE(modifier.starts_with("deck_paint_")) << outcome.out;  // down the uptake onto the exhaust gas
    const double kelvin = std::stod(modifier.substr(modifier.rfind('_') + 1));
    EXPECT_NEAR(kelvin, hottest("exhaust"), 1e-9);
    const double black = band_radiance(kelvin, 8, 12);
    EXPECT_GT(radiance, 0.9 * black * 0.999);  // the uptake's wall shines back on it
    EXPECT_LT(radiance, black);
}

TEST(ShipsSurroundings, SkyIsColdestAtTheZenith) {
    Folder folder;
    for (const std::string band : {"lwir", "mwir"}) {
        const auto sky = run(folder, python + "atmosphere.py " + band + " sky");
        std::istringstream numbers(sky.out);
        std::vector<double> values;
        for (double value; numbers >> value;) values.push_back(value);
        ASSERT_EQ(values.size(), 210U) << sky.err;
        const double air = band == "lwir" ? band_radiance(288, 8, 12) : band_radiance(288, 3, 5);
        for (std::size_t row = 0; row < 210; row += 10) {
            EXPECT_LT(values[row], 0.6 * air);
            EXPECT_GT(values[row + 9], 0.98 * air);
            EXPECT_LT(values[row + 9], 1.4 * air);  // haze scatters sunlight into it
        }
    }
}

TEST(ShipsSurroundings, ScenesAndAirAreRead) {
    Folder folder;
    const auto outcome = run(folder, python + "atmosphere.py mwir path > path.air &&" + python +
                                         "make_sea.py --band 3 5 > sea.rad && " + python +
                                         "make_plume.py > plume.rad &&\n"
                                         "for kind in calm gust; do brdftab -lambert .1 -n 4 4 4 -o "
                                         "sea_$kind.brdf > report || exit 1; done\n"
                                         "oconv sea.rad plume.rad > sea.oct &&\n"
                                         "echo 0 -2000 30 0 1 -.015 | RAYPATH=" +
                                         scene + ": rtrace -h -mp path.air -ab 1 -aa 0 -ad 16 -as 0 sea.oct");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NEAR(std::stod(outcome.out), band_radiance(287, 3, 5), 0.15);
}

}  // namespace
}  // namespace infra
