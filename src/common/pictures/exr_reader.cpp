// Reading OpenEXR pictures. Its headers stay in here.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <utility>

#include "common/error.h"
#include "common/pictures/picture.h"
#include "common/pictures/spectral_exr.h"
#include "common/pictures/spectral_header.h"

namespace infra {
namespace {

constexpr long long most_values = 1LL << 30;
constexpr int rows_at_once = 64;

/// The lines that write_exr stored, and what the file says of its values as lines BAND=, QUANTITY=, UNIT=.
PictureHeader stored_header(const Imf::Header& file) {
    const auto text_of = [&](const char* attribute) {
        const auto* found = file.findTypedAttribute<Imf::StringAttribute>(attribute);
        return found ? found->value() : std::string();
    };
    PictureHeader header;
    const std::string lines = text_of("radianceHeader");
    for (std::size_t start = 0; start < lines.size();) {
        const std::size_t end = std::min(lines.find('\n', start), lines.size());
        header.add(lines.substr(start, end - start));
        start = end + 1;
    }
    for (const auto& [attribute, name] :
         {std::pair{"band", "BAND"}, {"quantity", "QUANTITY"}, {"unit", "UNIT"}}) {
        const std::string text = text_of(attribute);
        if (!text.empty() && header.value(name) != text) header.add(std::string(name) + "= " + text);
    }
    return header;
}

std::vector<std::string> channel_names(const Imf::Header& file) {
    std::vector<std::string> names;
    for (auto channel = file.channels().begin(); channel != file.channels().end(); ++channel) {
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
            throw Error("luminance and chroma channels are not supported");
        names.emplace_back(channel.name());
    }
    return names;
}

/// Sets what the channels mean. returns the names of those to read, in order: spectral ones, colours or
/// grey without an alpha channel, or all.
std::vector<std::string> chosen_channels(Picture& picture, const std::vector<std::string>& names) {
    picture.space = ColorSpace::rgb;
    const std::vector<SpectralChannel> spectral = spectral_channels(names);
    if (!spectral.empty()) {
        std::vector<std::string> chosen;
        for (const SpectralChannel& channel : spectral) chosen.push_back(names[channel.index]);
        picture.space = ColorSpace::spectrum;
        picture.bands = channels_of(picture.header, static_cast<int>(chosen.size()));
        if (!picture.bands) picture.bands = bands_around(spectral);
        return chosen;
    }
    const auto has_all = [&](const std::vector<std::string>& wanted) {
        return std::ranges::all_of(wanted, [&](const auto& name) { return std::ranges::count(names, name); });
    };
    if (const std::vector<std::string> rgb = {"R", "G", "B"}; has_all(rgb)) return rgb;
    if (const std::vector<std::string> xyz = {"X", "Y", "Z"}; has_all(xyz)) {
        picture.space = ColorSpace::xyz;
        return xyz;
    }
    if (const std::vector<std::string> grey = {"Y"}; has_all(grey)) return grey;
    if (names.size() != 1 && names.size() != 3) picture.space = ColorSpace::spectrum;
    return names;
}

/// "sky, sea": the layers that a file's channels are in.
std::string layer_list(const std::vector<std::string>& names) {
    std::string list;
    std::string last;
    for (const std::string& name : names) {
        const std::string layer = name.substr(0, name.find('.'));
        if (layer.size() == name.size() || layer == "S0" || layer == last) continue;
        list += (list.empty() ? "" : ", ") + layer;
        last = layer;
    }
    return list.empty() ? "none" : list;
}

/// The channels of a layer without its name; all for an empty one.
std::vector<std::string> layer_channels(const std::vector<std::string>& names, const std::string& prefix) {
    std::vector<std::string> own;
    for (const std::string& name : names)
        if (name.starts_with(prefix)) own.push_back(name.substr(prefix.size()));
    if (own.empty())
        throw Error("it has no layer \"" + prefix.substr(0, prefix.size() - 1) +
                    "\"; layers: " + layer_list(names));
    return own;
}

void read_pixels(Imf::InputFile& file, const std::vector<std::string>& names, Picture& picture) {
    const auto& window = file.header().dataWindow();
    const std::size_t pixel = names.size(), row = pixel * static_cast<std::size_t>(picture.width);
    std::vector<float> block;
    for (int y = 0; y < picture.height; y += rows_at_once) {  // grows with what the file really holds
        const int rows = std::min(rows_at_once, picture.height - y);
        block.assign(row * static_cast<std::size_t>(rows), 0.0f);
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < names.size(); ++c)
            frame.insert(names[c],
                         Imf::Slice::Make(Imf::FLOAT, block.data() + c, {window.min.x, window.min.y + y},
                                          picture.width, rows, sizeof(float) * pixel, sizeof(float) * row));
        file.setFrameBuffer(frame);
        file.readPixels(window.min.y + y, window.min.y + y + rows - 1);
        picture.pixels.insert(picture.pixels.end(), block.begin(), block.end());
    }
}

Picture read(const std::string& path, const std::string& layer_prefix) {
    Imf::InputFile file(path.c_str(), 1);
    const auto& window = file.header().dataWindow();
    Picture picture;
    picture.width = window.max.x - window.min.x + 1;
    picture.height = window.max.y - window.min.y + 1;
    picture.header = stored_header(file.header());
    std::vector<std::string> names =
        chosen_channels(picture, layer_channels(channel_names(file.header()), layer_prefix));
    for (std::string& name : names) name = layer_prefix + name;
    picture.channels = static_cast<int>(names.size());
    if (1LL * picture.width * picture.height > most_values / std::max(picture.channels, 1))
        throw Error("it is larger than we can hold");
    read_pixels(file, names, picture);
    return picture;
}

}  // namespace

Picture read_exr(const std::string& path) { return read_exr_layer(path, ""); }

Picture read_exr_layer(const std::string& path, const std::string& layer) {
    try {
        return read(path, layer.empty() ? "" : layer + ".");
    } catch (const std::exception& problem) {
        throw Error(Location{path}, "cannot read picture: " + one_line(problem.what()));
    }
}

}  // namespace infra
