#include "common/pictures/exr_info.h"

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <ImfTestFile.h>

#include <algorithm>
#include <string_view>

#include "common/error.h"

namespace infra {
namespace {

constexpr std::string_view stored_lines = "radianceHeader";

void add_lines(std::vector<std::string>& lines, std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(one_line(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

ExrInfo info_of(const Imf::Header& header) {
    ExrInfo info;
    const auto& window = header.dataWindow();
    info.width = window.max.x - window.min.x + 1;
    info.height = window.max.y - window.min.y + 1;
    if (const auto* lines = header.findTypedAttribute<Imf::StringAttribute>(stored_lines.data()))
        add_lines(info.lines, lines->value());
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
        if (!text || attribute.name() == stored_lines) continue;
        const std::string line = one_line(attribute.name() + std::string("=") + text->value());
        if (std::ranges::count(info.lines, line) == 0) info.lines.push_back(line);  // VIEW stands in both
    }
    std::string names = "channels=";
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
        names += std::string(" ") + channel.name();
    info.lines.push_back(one_line(names));
    return info;
}

}  // namespace

bool is_exr_file(const std::string& path) { return Imf::isOpenExrFile(path.c_str()); }

ExrInfo read_exr_info(const std::string& path) {
    try {
        return info_of(Imf::InputFile(path.c_str(), 1).header());
    } catch (const std::exception& problem) {
        throw Error(Location{path}, "cannot read picture: " + one_line(problem.what()));
    }
}

}  // namespace infra
