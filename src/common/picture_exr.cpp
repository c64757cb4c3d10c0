// Writing float OpenEXR pictures.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include "common/atomic_file.h"
#include "common/error.h"
#include "common/format.h"
#include "common/picture.h"

namespace infra {
namespace {

std::string channel_name(int channel, int channels) {
    if (channels == 1) return "Y";
    if (channels == 3) return std::string(1, "RGB"[channel]);
    return formatted("C%03d", channel);
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
    std::string lines;
    for (const std::string& line : picture.header.lines) lines += line + "\n";
    describe("radianceHeader", lines);
    return header;
}

}  // namespace

void write_exr(const std::string& path, const Picture& picture, const ExrDescription& description) {
    if (picture.width < 1 || picture.height < 1 || picture.channels < 1)
        throw Error(Location{path}, "a picture needs at least one pixel");
    AtomicFile file(path);
    file.close();
    try {
        Imf::Header header = exr_header(picture, description);
        Imf::FrameBuffer frame;
        const std::size_t pixel_stride = sizeof(float) * picture.channels;
        for (int c = 0; c < picture.channels; ++c) {
            const std::string name = channel_name(c, picture.channels);
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
            char* base = reinterpret_cast<char*>(const_cast<float*>(picture.pixels.data() + c));
            frame.insert(name, Imf::Slice(Imf::FLOAT, base, pixel_stride, pixel_stride * picture.width));
        }
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
