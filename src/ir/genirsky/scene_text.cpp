#include "ir/genirsky/scene_text.h"

#include "common/format.h"

namespace infra::ir {
namespace {

std::string number(double value) { return formatted("%.9g", value); }

/// Numbers, ten a line, with their count before them.
std::string counted(const std::vector<double>& numbers, std::size_t first_line = Dome::rows) {
    std::string text = std::to_string(numbers.size());
    std::size_t in_line = Dome::rows - first_line;
    for (const double value : numbers) {
        text += in_line++ % Dome::rows == 0 ? "\n" : " ";
        text += number(value);
    }
    return text + "\n";
}

std::string counted(const std::vector<std::string>& words) {
    return std::to_string(words.size()) + " " + join_command(words) + "\n";
}

std::string source_text(const std::string& modifier, const std::string& name, const Vec3& direction,
                        double angle_deg) {
    return modifier + " source " + name + "\n0\n0\n4 " + number(direction.x) + " " + number(direction.y) +
           " " + number(direction.z) + " " + number(angle_deg) + "\n";
}

std::string pattern_text(const Request& request, const std::vector<Dome>& domes) {
    const bool sea = request.subject == Subject::sea;
    const std::string function = sea ? "sea" : "sky";
    std::vector<std::string> words;
    std::vector<double> numbers;
    if (!request.channels) {
        words = {function + "br", sea                      ? "skyfuncs/hemisea.cal"
                                  : domes[0].has_azimuth() ? "skyfuncs/hemisky.cal"
                                                           : "skyfuncs/elevsky.cal"};
    } else {
        words = {function + (domes[0].has_azimuth() ? "_dome" : "_elev"), "skyfuncs/spectral.cal"};
        numbers = {request.channels->longest_nm(), request.channels->shortest_nm(),
                   static_cast<double>(request.channels->count())};
    }
    for (const std::string& word : request.frame.transform()) words.push_back(word);
    for (const Dome& dome : domes) numbers.insert(numbers.end(), dome.values.begin(), dome.values.end());
    const std::string type = request.channels ? "specfunc" : "brightfunc";
    return "void " + type + " " + request.name + "_table\n" + counted(words) + "0\n" +
           counted(numbers, request.channels ? 3 : Dome::rows);
}

}  // namespace

std::string dome_text(const Request& request, const std::vector<Dome>& domes) {
    std::vector<Dome> tables = domes;
    if (request.subject == Subject::sea)  // hemisea.cal has azimuth always
        for (Dome& dome : tables) dome = dome.with_azimuth();
    const std::string table = request.name + "_table", glow = request.name + "_glow";
    const Vec3 direction = request.subject == Subject::sea ? -request.frame.up() : request.frame.up();
    return pattern_text(request, tables) + "\n" + table + " glow " + glow + "\n0\n0\n4 1 1 1 0\n\n" +
           source_text(glow, request.name, direction, 180);
}

std::string sun_text(const Request& request, const std::vector<double>& radiances) {
    const std::string light = request.name + "_light";
    std::string text, modifier = "void", value = number(radiances[0]);
    if (request.channels) {
        modifier = request.name + "_spectrum";
        value = "1";
        // a spectrum's numbers stand for steps around wavelengths from the first to the last
        std::vector<double> numbers{request.channels->center_nm(0),
                                    request.channels->center_nm(request.channels->count() - 1)};
        numbers.insert(numbers.end(), radiances.begin(), radiances.end());
        text = "void spectrum " + modifier + "\n0\n0\n" + counted(numbers, 2) + "\n";
    }
    text += modifier + " light " + light + "\n0\n0\n3 " + value + " " + value + " " + value + "\n\n";
    return text + source_text(light, request.name, request.sun.direction, 2 * request.sun.half_angle_deg);
}

}  // namespace infra::ir
