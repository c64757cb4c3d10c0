#include "ir/brdftab/sample_text.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/text.h"

namespace infra::ir {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

void SampleText::fail(std::string_view message, std::string_view hint) const {
    throw Error(Location{name_, std::max(line_, 1)}, message, hint);
}

bool SampleText::next_line() {
    while (!rest_.empty()) {
        const std::string_view whole = take_line(rest_);
        std::string line(whole.substr(0, whole.find('#')));
        ++line_;
        std::replace(line.begin(), line.end(), ',', ' ');
        words_ = split_words(line);
        if (!words_.empty()) return true;
    }
    return false;
}

double SampleText::number(const std::string& word, std::string_view what) const {
    double value = 0;
    if (!parse_real(word, value))
        fail(std::string(what) + ": expected a finite number, found \"" + word + "\"");
    return value;
}

double SampleText::polar_angle(const std::string& word, std::string_view what) const {
    const double degrees = number(word, what);
    if (!(degrees >= 0 && degrees <= 90))
        fail(std::string(what) + " = " + word + " deg is out of range",
             "0..90 deg; the other side of the normal has another azimuth");
    return degrees * pi / 180;
}

double SampleText::azimuth(const std::string& word, std::string_view what) const {
    const double degrees = number(word, what);
    if (!(degrees >= -360 && degrees <= 360))
        fail(std::string(what) + " = " + word + " deg is out of range", "-360..360 deg");
    return degrees * pi / 180;
}

void SampleText::add(double theta_i, double phi, double theta_r, const std::string& value) {
    double f = number(value, "value");
    if (f < 0) {
        if (!rules_.negative_is_zero)
            fail("negative BRDF value " + value, "-zero-negative takes such values for 0");
        f = 0;
        ++set_.negatives_zeroed;
    }
    set_.samples.push_back({theta_i, rules_.mirror_at_zero ? phi + pi : phi, theta_r, f, line_});
}

SampleSet SampleText::take() {
    if (set_.samples.empty()) fail("the file has no samples");
    return std::move(set_);
}

}  // namespace infra::ir
