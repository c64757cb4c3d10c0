// Data files, pictures and fonts by file: primitives that name the same file share its table.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "common/data/data_table.h"

namespace infra {

class Font;
class ModifierContext;

struct DataCache {
    using Tables = std::map<std::string, std::shared_ptr<const DataTable>, std::less<>>;

    Tables files;
    Tables color_pictures;
    Tables spectral_pictures;
    std::map<std::string, std::shared_ptr<const Font>, std::less<>> fonts;
};

/// The table of a data file, found through RAYPATH.
///   throws  Error at the primitive for a file not found, in the file for what is wrong with it
std::shared_ptr<const DataTable> shared_data(ModifierContext& context, std::string_view name);

/// A picture over u, v and its three colours; see common/pictures/picture_table.h.
std::shared_ptr<const DataTable> shared_picture(ModifierContext& context, std::string_view name);

/// A spectral picture over u, v and wavelength.
std::shared_ptr<const DataTable> shared_spectral_picture(ModifierContext& context, std::string_view name);

/// A font (text/font.h), found and refused as data files are.
std::shared_ptr<const Font> shared_font(ModifierContext& context, std::string_view name);

}  // namespace infra
