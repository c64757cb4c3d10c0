// Pictures in memory and their files: RADIANCE's .hdr (RGBE, XYZE, spectral), float OpenEXR, and PNG for
// showing.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/spectra/channels.h"
#include "common/views/view.h"

namespace infra {

/// The information header: its lines in order, without the "#?RADIANCE" and FORMAT lines that the file format
/// owns.
class PictureHeader {
  public:
    std::vector<std::string> lines;

    /// Adds a line, "SOFTWARE= ...".
    void add(std::string line) { lines.push_back(std::move(line)); }
    /// Text after the last "NAME=", without blanks around it. Indented lines belong to earlier pictures and
    /// don't count.
    std::optional<std::string> value(std::string_view name) const;
    /// Product of all EXPOSURE lines: divide pixels by it to get radiance.
    double exposure() const;
    /// Product of all PIXASPECT lines.
    double pixel_aspect() const;
    /// Product of all COLORCORR lines.
    std::array<double, 3> color_correction() const;
    /// x and y chromaticities of red, green, blue and white.
    std::optional<std::array<double, 8>> primaries() const;
    /// The view after all view lines, set up; nothing when there is none or it is illegal.
    std::optional<View> view() const;
};

/// What the values of a picture mean.
enum class ColorSpace { rgb, xyz, spectrum };

/// Rows run from the top of the image to its bottom, pixels from left to right, channels are interleaved,
/// spectral ones from the longest wavelength to the shortest.
struct Picture {
    int width = 0;
    int height = 0;
    int channels = 3;
    ColorSpace space = ColorSpace::rgb;
    std::vector<float> pixels;
    PictureHeader header;
    std::optional<Channels> bands;  ///< of a spectral picture that tells them

    /// The channels of one pixel; column and row count from the upper left corner.
    std::span<const float> at(int column, int row) const {
        return std::span(pixels).subspan((std::size_t(row) * width + column) * channels, channels);
    }
    std::span<float> at(int column, int row) {
        return std::span(pixels).subspan((std::size_t(row) * width + column) * channels, channels);
    }
};

/// Divides by the exposure and colour correction of the header and drops those lines: values are radiance
/// afterwards.
void undo_exposure(Picture& picture);

/// Reads any picture: RADIANCE's and OpenEXR by our readers, others through OpenImageIO. throws Error for
/// missing, malformed or truncated ones.
Picture read_picture(const std::string& path);
/// Reads a layer of an OpenEXR file: the channels "layer.R" and so on, taken for R and so on.
///   throws  Error also if it has no such layer
Picture read_exr_layer(const std::string& path, const std::string& layer);
/// Reads RADIANCE's and OpenEXR only: for renderers, which would start a quarter of a second later if they
/// were linked with the library for all others.
Picture read_float_picture(const std::string& path);
/// Whether a file starts as one of those does. throws Error when it cannot be opened.
bool is_float_picture(const std::string& path);
/// Reads OpenEXR: the spectral channels of a file that has some, else R G B or X Y Z without alpha, else all.
Picture read_exr(const std::string& path);
/// Reads RADIANCE's format in all its forms: flat, old and new run lengths, rgbe, xyze, spectra, any scanline
/// order. `name` is for error messages.
Picture read_hdr(std::FILE* file, const std::string& name);

/// What is there of a picture whose program was stopped.
struct UnfinishedRows {
    Picture rows;    ///< the complete ones at the top; its height is their number, which may be 0
    int height = 0;  ///< of the whole picture
};
/// Reads a picture in RADIANCE's format that ends anywhere after its resolution line, or is whole.
///   throws  Error as read_hdr before that, and for scanlines in another order than from the top left
UnfinishedRows read_unfinished_hdr(std::FILE* file, const std::string& name);

/// Writes a .hdr picture from top to bottom, one scanline after another, to a stream that stays the caller's.
class HdrWriter {
  public:
    /// Writes the header, FORMAT line and resolution.
    ///   channels  more than 3 of a spectrum only; the header of one has its NCOMP and WAVELENGTH_SPLITS
    HdrWriter(std::FILE* file, const PictureHeader& header, int width, int height,
              ColorSpace space = ColorSpace::rgb, int channels = 3);
    /// values: `channels` a pixel, width pixels. throws Error when the device is full or more than `height`
    /// are written.
    void write_scanline(std::span<const float> values);
    /// Flushes and checks that all scanlines were written.
    void finish();

  private:
    void encode_scanline();

    std::FILE* file_;
    int width_;
    int rows_left_;
    int channels_;
    std::vector<std::uint8_t> pixels_, buffer_;
};
/// Writes all of a picture; one channel as grey, one with bands as RADIANCE's spectra, NCOMP and
/// WAVELENGTH_SPLITS included.
///   throws  Error for other numbers of channels than 1 and 3 without bands
void write_hdr(std::FILE* file, const Picture& picture);
/// The same, atomically.
void write_hdr(const std::string& path, const Picture& picture);

/// What an OpenEXR file says about itself, as string attributes of the same names; empty ones are left out.
struct ExrDescription {
    std::string program;   ///< command line
    std::string view;      ///< view options, as format_view
    std::string quantity;  ///< "radiance"
    std::string unit;      ///< "W.m-2.sr-1"
    std::string band;      ///< "8-12 um"
    std::string software;  ///< version
};
/// Pictures of the same size and channels that go into a file beside the main one. Their values are
/// interleaved: first all channels of the first layer, then those of the second.
struct ExrLayers {
    std::vector<std::string> names;
    const std::vector<float>& values;
};
/// Writes 32 bit float channels with ZIP compression, atomically: R G B or X Y Z for three channels, Y for
/// one, C000, C001... for others. The header's lines go into the attribute "radianceHeader".
///
/// A picture with bands has channels named after the middle of each, S0.8250,000nm, and the attributes
/// spectralLayoutVersion, emissiveUnits (Fichet, Pacanowski, Wilkie, "An OpenEXR Layout for Spectral Images",
/// JCGT 10 (2021)), bandLimits, all limits of the bands in nm, longest first, and channelValues, what the
/// value of a channel means.
///
/// Channels of layers are named "layer.R" and so on.
void write_exr(const std::string& path, const Picture& picture, const ExrDescription& description,
               const ExrLayers* layers = nullptr);

}  // namespace infra
