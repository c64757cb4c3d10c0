#include "rt/compile/data_cache.h"

#include "common/data/data_file.h"
#include "common/pictures/picture_table.h"
#include "common/raypath.h"
#include "common/text_file.h"
#include "rt/compile/modifier_table.h"
#include "rt/text/font.h"

namespace infra {
namespace {

std::string path_of(ModifierContext& context, std::string_view name, std::string_view kind) {
    const auto path = find_library_file(name);
    if (!path)
        throw context.error("cannot find " + std::string(kind) + " \"" + std::string(name) + "\"",
                            "looked for in RAYPATH");
    return *path;
}

std::shared_ptr<const DataTable> shared_table(ModifierContext& context, DataCache::Tables& tables,
                                              std::string_view name, std::string_view kind,
                                              DataTable (*read)(const std::string&)) {
    const std::string path = path_of(context, name, kind);
    auto& slot = tables[path];
    if (!slot) slot = std::make_shared<const DataTable>(read(path));
    return slot;
}

}  // namespace

std::shared_ptr<const DataTable> shared_data(ModifierContext& context, std::string_view name) {
    return shared_table(context, context.data.files, name, "data file", read_data_file);
}

std::shared_ptr<const DataTable> shared_picture(ModifierContext& context, std::string_view name) {
    return shared_table(context, context.data.color_pictures, name, "picture", read_color_table);
}

std::shared_ptr<const DataTable> shared_spectral_picture(ModifierContext& context, std::string_view name) {
    return shared_table(context, context.data.spectral_pictures, name, "spectral picture",
                        read_spectrum_table);
}

std::shared_ptr<const Font> shared_font(ModifierContext& context, std::string_view name) {
    const std::string path = path_of(context, name, "font");
    auto& slot = context.data.fonts[path];
    if (!slot) slot = std::make_shared<const Font>(read_text_file(path), path);
    return slot;
}

}  // namespace infra
