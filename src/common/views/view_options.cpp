#include "common/views/view_options.h"

#include <string>

#include "common/format.h"

namespace infra {

void add_view_options(OptionTable& table, View& view) {
    View* const v = &view;
    table
        .attached(
            "-vt", "",
            [v](const OptionValues& given) {
                const auto type = given.attached.size() == 1 ? view_type_of(given.attached[0]) : std::nullopt;
                if (!type) given.reject("unknown view type", "the types are v l c h a s, as in -vtv");
                v->type = *type;
            },
            "view type: v perspective, l parallel, c cylindrical, h hemispherical, a angular, s planisphere")
        .shown([v] { return formatted("-vt%c", static_cast<char>(v->type)); })
        .remark([v] { return std::string("view type ") + view_type_name(v->type); });
    table.vec3("-vp", &v->point, "view point");
    table
        .custom(
            "-vd", "fff",
            [v](const OptionValues& given) {
                v->direction = {given.real(0), given.real(1), given.real(2)};
                v->distance = 1;
            },
            "view direction")
        .named("x y z")
        .shown([v] { return formatted("-vd %f %f %f", v->direction.x, v->direction.y, v->direction.z); });
    table.vec3("-vu", &v->up, "view up");
    table.real("-vh", &v->horizontal, "view horizontal size");
    table.real("-vv", &v->vertical, "view vertical size");
    table.real("-vo", &v->fore, "view fore clipping plane");
    table.real("-va", &v->aft, "view aft clipping plane");
    table.real("-vs", &v->shift, "view shift");
    table.real("-vl", &v->lift, "view lift");
    table
        .custom(
            "-vf", "s", [v](const OptionValues& given) { read_view_file(given.text(0), *v); },
            "view file or picture")
        .named("file");
}

}  // namespace infra
