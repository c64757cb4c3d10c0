// Everything that OpenImageIO does for us: reading foreign pictures and writing PNG. Its headers stay in
// here.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "common/atomic_file.h"
#include "common/error.h"
#include "common/pictures/image8.h"
#include "common/pictures/picture.h"

namespace infra {
namespace {

Picture read_foreign(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) {
        OIIO::geterror();  // names the plugins it tried, and would be printed at the end
        throw Error(Location{path}, "cannot read picture: it is not a picture, or damaged",
                    ".hdr, .exr, PNG, JPEG or TIFF");
    }
    const OIIO::ImageSpec& spec = input->spec();
    Picture picture;
    picture.width = spec.width;
    picture.height = spec.height;
    picture.channels = spec.nchannels;
    if (picture.channels != 1 && picture.channels != 3) picture.space = ColorSpace::spectrum;
    if (spec.image_bytes() > (std::uint64_t(1) << 36)) throw Error(Location{path}, "picture is too large");
    picture.pixels.resize(std::size_t(spec.width) * spec.height * spec.nchannels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, picture.pixels.data()))
        throw Error(Location{path}, "cannot read picture: " + input->geterror());
    return picture;
}

}  // namespace

Picture read_picture(const std::string& path) {
    return is_float_picture(path) ? read_float_picture(path) : read_foreign(path);
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
