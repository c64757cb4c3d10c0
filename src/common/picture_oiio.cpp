// Everything that OpenImageIO does for us: reading foreign pictures and writing PNG. Its headers stay in
// here.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include "common/atomic_file.h"
#include "common/error.h"
#include "common/image8.h"
#include "common/picture.h"

namespace infra {
namespace {

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Whether the file starts as RADIANCE's do.
bool has_radiance_magic(std::FILE* file) {
    char magic[2] = {};
    const bool found = std::fread(magic, 1, 2, file) == 2 && magic[0] == '#' && magic[1] == '?';
    std::rewind(file);
    return found;
}

/// The lines that write_exr stored, and what the file says of its values as lines BAND=, QUANTITY=, UNIT=.
PictureHeader stored_header(const OIIO::ImageSpec& spec) {
    PictureHeader header;
    const std::string lines = spec.get_string_attribute("radianceHeader");
    for (std::size_t start = 0; start < lines.size();) {
        const std::size_t end = std::min(lines.find('\n', start), lines.size());
        header.add(lines.substr(start, end - start));
        start = end + 1;
    }
    for (const auto& [attribute, name] :
         {std::pair{"band", "BAND"}, {"quantity", "QUANTITY"}, {"unit", "UNIT"}}) {
        const std::string text = spec.get_string_attribute(attribute);
        if (!text.empty() && header.value(name) != text) header.add(std::string(name) + "= " + text);
    }
    return header;
}

Picture read_foreign(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) throw Error(Location{path}, "cannot read picture: " + OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    Picture picture;
    picture.width = spec.width;
    picture.height = spec.height;
    picture.channels = spec.nchannels;
    if (picture.channels != 1 && picture.channels != 3) picture.space = ColorSpace::spectrum;
    picture.header = stored_header(spec);
    if (spec.image_bytes() > (std::uint64_t(1) << 36)) throw Error(Location{path}, "picture is too large");
    picture.pixels.resize(std::size_t(spec.width) * spec.height * spec.nchannels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, picture.pixels.data()))
        throw Error(Location{path}, "cannot read picture: " + input->geterror());
    return picture;
}

}  // namespace

Picture read_picture(const std::string& path) {
    const FilePointer file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) throw Error("cannot open picture \"" + path + "\": " + std::strerror(errno));
    return has_radiance_magic(file.get()) ? read_hdr(file.get(), path) : read_foreign(path);
}

void write_png(const std::string& path, const Image8& image) {
    AtomicFile file(path);
    // Encoded in memory first: the library does not notice when a full device loses the last bytes.
    OIIO::Filesystem::IOVecOutput encoded;
    const auto output = OIIO::ImageOutput::create("png");
    const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
    if (!output || !output->set_ioproxy(&encoded) || !output->open(path, spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, image.pixels.data()) || !output->close()) {
        throw Error(Location{path},
                    "cannot write picture: " + (output ? output->geterror() : OIIO::geterror()), {},
                    Severity::system);
    }
    const std::vector<unsigned char>& bytes = encoded.buffer();
    std::fwrite(bytes.data(), 1, bytes.size(), file.stream());
    file.commit();
}

}  // namespace infra
