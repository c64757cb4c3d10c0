#include "rt/functions.h"

#include <algorithm>

#include "cal/ray_library.h"
#include "rt/modifier_table.h"
#include "rt/tracer.h"

namespace infra {
namespace {

/// What channels are computed from.
struct LocalView {
    const Interaction* at;
    const Transform* to_local;
    double scale;
};

// Component `i` of a direction in local coordinates.
double local_direction(const LocalView& view, const Vec3& v, int i) {
    const auto& m = view.to_local->matrix;
    return (v.x * m[0][i] + v.y * m[1][i] + v.z * m[2][i]) / view.scale;
}

double channel_value(const void* self, int number) {
    const LocalView& view = *static_cast<const LocalView*>(self);
    const Interaction& at = *view.at;
    const auto& m = view.to_local->matrix;
    if (number < 1) throw Error("illegal channel number $" + std::to_string(number), "a ray has $1 to $27");
    if (number < cal::surface_normal) return local_direction(view, at.ray->direction, number - 1);
    if (number < cal::intersection_point)
        return local_direction(view, at.normal, number - cal::surface_normal);
    if (number < cal::total_distance) {
        const int i = number - cal::intersection_point;
        return at.point.x * m[0][i] + at.point.y * m[1][i] + at.point.z * m[2][i] + m[3][i];
    }
    if (number == cal::total_distance) return (at.ray->path_before + at.distance) * view.scale;
    if (number == cal::ray_dot) return std::clamp(at.cosine, -1.0, 1.0);
    if (number == cal::world_scale) return view.scale;
    if (number < cal::world_i) return m[3][number - cal::world_origin];
    if (number < cal::world_j) return m[0][number - cal::world_i] / view.scale;
    if (number < cal::world_k) return m[1][number - cal::world_j] / view.scale;
    if (number < cal::shadow_distance) return m[2][number - cal::world_k] / view.scale;
    if (number == cal::shadow_distance) return (at.distance + at.ray->shadow_before) * view.scale;
    if (number == cal::local_u || number == cal::local_v)
        return 0;  // only meshes have coordinates of their own
    throw Error("illegal channel number $" + std::to_string(number), "a ray has $1 to $27");
}

}  // namespace

FunctionSet::FunctionSet(ModifierContext& context, std::size_t first, std::size_t count, std::size_t file)
    : scale_(1), reals_(context.reals()), where_(context.scene.location(context.id)) {
    const auto strings = context.strings();
    owner_ =
        std::string(infra::name(context.scene.type(context.id))) + " \"" + std::string(context.name()) + "\"";
    if (strings.size() <= file) throw context.error("too few string arguments");

    Location start = where_;
    if (start.file.empty()) start.file = owner_;
    const std::string function_context = context.functions.load_function_file(strings[file], start);
    for (std::size_t i = 0; i < count; ++i)
        expressions_.push_back(context.functions.compile(strings[first + i], start, function_context));

    std::vector<std::string_view> words(strings.begin() + static_cast<std::ptrdiff_t>(file) + 1,
                                        strings.end());
    const auto begin = std::find_if(words.begin(), words.end(), is_transform_option);
    words.erase(words.begin(), begin);
    if (!words.empty()) {
        if (parse_transform(std::span<const std::string_view>(words), from_local_) != words.size())
            throw context.error("bad transform", "options such as -t x y z, -rx angle, -s factor");
        to_local_ = from_local_.inverse();
        scale_ = to_local_.magnification();
    }
}

bool FunctionSet::evaluate(Tracer& tracer, const Interaction& at, double* values) const {
    const LocalView view{&at, &to_local_, scale_};
    const cal::Host host{&view, channel_value, reals_, owner_, &where_};
    cal::Evaluator& evaluator = tracer.evaluator();
    evaluator.next_clock();
    const std::uint64_t faults = evaluator.fault_count();
    try {
        for (const cal::ExprId expression : expressions_) *values++ = evaluator.evaluate(expression, host);
    } catch (const Error& error) {
        if (!error.where().file.empty()) throw;
        throw host.error(error.message(), error.hint());
    }
    return evaluator.fault_count() == faults;
}

}  // namespace infra
