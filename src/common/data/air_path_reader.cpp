// The text of an air path file.
#include <cmath>

#include "common/data/air_path.h"
#include "common/error.h"
#include "common/format.h"
#include "common/parse_number.h"
#include "common/text.h"
#include "common/text_file.h"

namespace infra {

namespace {

constexpr double rounding = 1e-6;  // relative, of numbers in a file

}  // namespace

class AirPathReader {
  public:
    AirPathReader(AirPath& target, const std::string& name) : out_(target), place_{name, 0} {}

    void read(std::string_view text) {
        while (!text.empty()) {
            const std::string_view line = take_line(text);
            ++place_.line;
            if (line.starts_with("#%"))
                read_directive(split_words(line.substr(2)));
            else
                read_row(split_words(line.substr(0, line.find('#'))));
        }
        if (out_.bands_.empty() || out_.bands_[0].size() < 2)
            throw Error(place_, "no rows", "a row is a distance, a transmittance and a path radiance");
    }

  private:
    double number(const std::string& word) const {
        double value;
        if (!parse_real(word, value)) throw Error(place_, "\"" + word + "\" is not a number");
        return value;
    }

    void read_directive(const std::vector<std::string>& words) {
        std::vector<double>& edges_um = out_.edges_um_;
        if (words.empty() || words[0] != "bands" || words.size() < 3)
            throw Error(place_, "unknown directive", "\"#% bands 8 10 12\" states the edges of bands in um");
        if (!edges_um.empty() || !out_.bands_.empty())
            throw Error(place_, "bands must be stated once and before the rows");
        for (std::size_t i = 1; i < words.size(); ++i) {
            edges_um.push_back(number(words[i]));
            if (edges_um[i - 1] <= (i > 1 ? edges_um[i - 2] : 0))
                throw Error(place_, "edges of bands must be above 0 and increase");
        }
    }

    void read_row(const std::vector<std::string>& words) {
        if (words.empty()) return;
        const std::size_t bands = out_.edges_um_.empty() ? 1 : out_.edges_um_.size() - 1;
        if (words.size() != 1 + 2 * bands)
            throw Error(place_, formatted("expected %zu columns, found %zu", 1 + 2 * bands, words.size()),
                        "a row is a distance, then a transmittance and a path radiance for every band");
        if (out_.bands_.empty()) out_.bands_.assign(bands, {{0, 0, 0}});
        const double distance = number(words[0]);
        for (std::size_t k = 0; k < bands; ++k)
            add_node(out_.bands_[k], distance, number(words[1 + 2 * k]), number(words[2 + 2 * k]));
    }

    void add_node(std::vector<AirPath::Node>& nodes, double distance, double tau, double radiance) const {
        if (distance == 0 && nodes.size() == 1) {
            if (tau != 1 || radiance != 0)
                throw Error(place_, "at distance 0 transmittance is 1 and path radiance 0");
            return;
        }
        if (!(distance > nodes.back().distance))
            throw Error(place_,
                        formatted("distance %g does not come after %g", distance, nodes.back().distance));
        if (!(tau > 0 && tau <= 1))
            throw Error(place_, formatted("transmittance %g is not within 0..1", tau),
                        "0 itself is not taken: give a small number");
        const double depth = -std::log(tau);
        if (depth < nodes.back().depth)
            throw Error(place_, formatted("transmittance %g is larger than nearer by", tau));
        if (radiance < 0) throw Error(place_, formatted("path radiance %g is negative", radiance));
        const AirPath::Node& nearer = nodes.back();
        if (radiance < -std::expm1(-nearer.depth) * nearer.source * (1 - rounding))
            throw Error(place_, formatted("path radiance %g is smaller than nearer by", radiance),
                        "what the nearer air sends comes on top of the farther air's");
        if (depth == 0 && radiance > 0)
            throw Error(place_, "path radiance without absorption", "scattering reduces transmittance too");
        const double source = depth > 0 ? radiance / -std::expm1(-depth) : 0.0;
        // Before the first absorption there is no source function: it starts as it is there.
        if (nodes.back().depth == 0)
            for (AirPath::Node& node : nodes) node.source = source;
        nodes.push_back({distance, depth, source});
    }

    AirPath& out_;
    Location place_;
};

AirPath AirPath::read(const std::string& path, const Channels& channels) {
    return parse(read_text_file(path), path == "-" ? "standard input" : path, channels);
}

AirPath AirPath::parse(std::string_view text, const std::string& name, const Channels& channels) {
    AirPath result(channels);
    AirPathReader(result, name).read(text);
    result.share_bands(channels, name);
    return result;
}

}  // namespace infra
