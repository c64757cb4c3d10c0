// Writing float OpenEXR pictures.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include "common/atomic_file.h"
#include "common/error.h"
#include "common/format.h"
#include "common/pictures/picture.h"
#include "common/pictures/spectral_exr.h"
#include "common/pictures/spectral_header.h"

namespace infra {
namespace {

constexpr const char* channel_values =
    "number of bands x radiance in the channel's band: the mean of the channels is the radiance in the whole "
    "range, a channel over their number that in its band";

std::string channel_name(const Picture& picture, int channel) {
    if (picture.bands) return spectral_channel_name(picture.bands->center_nm(channel));
    if (picture.channels == 1) return "Y";
    if (picture.channels == 3)
        return std::string(1, picture.space == ColorSpace::xyz ? "XYZ"[channel] : "RGB"[channel]);
    return formatted("C%03d", channel);
}

/// Ends of all bands in nm, longest first.
std::string band_limits(const Channels& bands) {
    std::string text = formatted("%.10g", bands.longest_nm());
    for (int c = 0; c < bands.count(); ++c) text += formatted(" %.10g", bands.lower_nm(c));
    return text;
}

Imf::Header exr_header(const Picture& picture, const ExrDescription& description) {
    const float width_over_height = static_cast<float>(1 / picture.header.pixel_aspect());
    Imf::Header header(picture.width, picture.height, width_over_height);
    header.compression() = Imf::ZIP_COMPRESSION;
    const auto describe = [&header](const char* name, const std::string& text) {
        if (!text.empty()) header.insert(name, Imf::StringAttribute(text));
    };
    describe("program", description.program);
    describe("VIEW", description.view);
    describe("quantity", description.quantity);
    describe("unit", description.unit);
    describe("band", description.band);
    describe("software", description.software);
    PictureHeader radiance_header = picture.header;
    if (picture.bands) {
        set_channel_lines(radiance_header, *picture.bands);
        describe("spectralLayoutVersion", "1.0");
        if (description.unit == "W.m-2.sr-1") describe("emissiveUnits", "W.m^-2.sr^-1");
        describe("bandLimits", band_limits(*picture.bands));
        describe("channelValues", channel_values);
    }
    std::string lines;
    for (const std::string& line : radiance_header.lines) lines += line + "\n";
    describe("radianceHeader", lines);
    return header;
}

}  // namespace

void write_exr(const std::string& path, const Picture& picture, const ExrDescription& description,
               const ExrLayers* layers) {
    if (picture.width < 1 || picture.height < 1 || picture.channels < 1)
        throw Error(Location{path}, "a picture needs at least one pixel");
    AtomicFile file(path);
    file.close();
    try {
        Imf::Header header = exr_header(picture, description);
        Imf::FrameBuffer frame;
        const auto add_channel = [&](const std::string& name, const float* first,
                                     std::size_t values_a_pixel) {
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
            char* base = reinterpret_cast<char*>(const_cast<float*>(first));
            const std::size_t stride = sizeof(float) * values_a_pixel;
            frame.insert(name, Imf::Slice(Imf::FLOAT, base, stride, stride * picture.width));
        };
        const std::size_t channels = picture.channels;
        for (std::size_t c = 0; c < channels; ++c)
            add_channel(channel_name(picture, static_cast<int>(c)), &picture.pixels[c], channels);
        const std::size_t layer_count = layers ? layers->names.size() : 0;
        for (std::size_t i = 0; i < layer_count * channels; ++i)
            add_channel(
                layers->names[i / channels] + "." + channel_name(picture, static_cast<int>(i % channels)),
                &layers->values[i], layer_count * channels);
        Imf::OutputFile output(file.part_path().c_str(), header, 1);
        output.setFrameBuffer(frame);
        output.writePixels(picture.height);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& problem) {
        throw Error(Location{path}, std::string("cannot write OpenEXR picture: ") + problem.what(), {},
                    Severity::system);
    }
    file.commit();
}

}  // namespace infra
