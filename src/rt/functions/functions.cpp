#include "rt/functions/functions.h"

#include <algorithm>

#include "cal/ray_library.h"
#include "common/format.h"
#include "rt/compile/modifier_table.h"
#include "rt/tracer.h"

namespace infra {

FunctionSet::FunctionSet(ModifierContext& context, std::size_t first, std::size_t count, std::size_t file)
    : scale_(1), reals_(context.reals()), where_(context.scene.location(context.id)) {
    const auto strings = context.strings();
    owner_ =
        std::string(infra::name(context.scene.type(context.id))) + " \"" + std::string(context.name()) + "\"";
    const std::size_t needed = std::max(file + 1, first + count);
    if (strings.size() < needed)
        throw context.error(
            formatted("%zu string arguments where at least %zu are needed", strings.size(), needed));

    Location start = where_;
    if (start.file.empty()) start.file = owner_;
    context_ = context.functions.load_function_file(strings[file], start);
    for (std::size_t i = 0; i < count; ++i)
        expressions_.push_back(context.functions.compile(strings[first + i], start, context_));

    std::vector<std::string_view> words(strings.begin() + static_cast<std::ptrdiff_t>(needed), strings.end());
    const auto begin = std::find_if(words.begin(), words.end(), is_transform_option);
    words.erase(words.begin(), begin);
    if (!words.empty()) {
        if (parse_transform(std::span<const std::string_view>(words), from_local_) != words.size())
            throw context.error("bad transform", "options such as -t x y z, -rx angle, -s factor");
        to_local_ = from_local_.inverse();
        scale_ = to_local_.magnification();
    }
}

int FunctionSet::arity(const ModifierContext& context, std::size_t argument) const {
    return context.functions.function_arity(context.strings()[argument], context_);
}

void FunctionSet::add_function(ModifierContext& context, std::size_t argument, int argument_count) {
    const std::string name(context.strings()[argument]);
    const int needed = arity(context, argument);
    if (needed == 0) throw context.error("undefined function \"" + name + "\"");
    if (needed > argument_count)
        throw context.error(formatted("function \"%s\" takes %d arguments, here it is given %d", name.c_str(),
                                      needed, argument_count));
    functions_.push_back(context.functions.compile_function(name, argument_count, where_, context_));
}

bool FunctionSet::evaluate(Tracer& tracer, const Interaction& at, double* values) const {
    FunctionCall call(*this, tracer, at);
    call.expressions(values);
    return call.ok();
}

FunctionCall::FunctionCall(const FunctionSet& set, Tracer& tracer, const Interaction& at)
    : set_(set),
      at_(at),
      evaluator_(tracer.evaluator()),
      host_{this, channel_value, set.reals_, set.owner_, &set.where_},
      faults_(evaluator_.fault_count()) {
    evaluator_.next_clock();
}

void FunctionCall::expressions(double* values) {
    try {
        for (const cal::ExprId expression : set_.expressions_)
            *values++ = evaluator_.evaluate(expression, host_);
    } catch (const Error& error) {
        fail(error);
    }
}

double FunctionCall::call(std::size_t function, std::span<const double> arguments) {
    try {
        return evaluator_.evaluate(set_.functions_[function], arguments, host_);
    } catch (const Error& error) {
        fail(error);
    }
}

void FunctionCall::fail(const Error& error) const {
    if (!error.where().file.empty()) throw error;
    throw host_.error(error.message(), error.hint());
}

// Component `i` of a direction in local coordinates.
double FunctionCall::local_direction(const Vec3& v, int i) const {
    const auto& m = set_.to_local_.matrix;
    return (v.x * m[0][i] + v.y * m[1][i] + v.z * m[2][i]) / set_.scale_;
}

double FunctionCall::channel_value(const void* self, int number) {
    const FunctionCall& view = *static_cast<const FunctionCall*>(self);
    const Interaction& at = view.at_;
    const auto& m = view.set_.to_local_.matrix;
    const double scale = view.set_.scale_;
    if (number < 1) throw Error("illegal channel number $" + std::to_string(number), "a ray has $1 to $27");
    if (number < cal::surface_normal) return view.local_direction(at.ray->direction, number - 1);
    if (number < cal::intersection_point)
        return view.local_direction(at.normal, number - cal::surface_normal);
    if (number < cal::total_distance) {
        const int i = number - cal::intersection_point;
        return at.point.x * m[0][i] + at.point.y * m[1][i] + at.point.z * m[2][i] + m[3][i];
    }
    if (number == cal::total_distance) return (at.ray->path_before + at.distance) * scale;
    if (number == cal::ray_dot) return std::clamp(at.cosine, -1.0, 1.0);
    if (number == cal::world_scale) return scale;
    if (number < cal::world_i) return m[3][number - cal::world_origin];
    if (number < cal::world_j) return m[0][number - cal::world_i] / scale;
    if (number < cal::world_k) return m[1][number - cal::world_j] / scale;
    if (number < cal::shadow_distance) return m[2][number - cal::world_k] / scale;
    if (number == cal::shadow_distance) return (at.distance + at.ray->shadow_before) * scale;
    if (number == cal::local_u || number == cal::local_v)
        return 0;  // only meshes have coordinates of their own
    throw Error("illegal channel number $" + std::to_string(number), "a ray has $1 to $27");
}

}  // namespace infra
