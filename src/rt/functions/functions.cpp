#include "rt/functions/functions.h"

#include <algorithm>

#include "cal/ray_library.h"
#include "common/format.h"
#include "rt/compile/modifier_table.h"
#include "rt/functions/hit_channel.h"
#include "rt/tracer.h"

namespace infra {

FunctionSet::FunctionSet(ModifierContext& context, std::size_t first, std::size_t count, std::size_t file)
    : reals_(context.reals()), where_(context.scene.location(context.id)) {
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
    for (std::size_t i = 0; i < count; ++i) add_expression(context, first + i);

    std::vector<std::string_view> words(strings.begin() + static_cast<std::ptrdiff_t>(needed), strings.end());
    const auto begin = std::find_if(words.begin(), words.end(), is_transform_option);
    words.erase(words.begin(), begin);
    if (!words.empty()) {
        if (parse_transform(std::span<const std::string_view>(words), from_local_) != words.size())
            throw context.error("bad transform", "options such as -t x y z, -rx angle, -s factor");
        to_local_ = from_local_.inverse();
    }
}

void FunctionSet::add_expression(ModifierContext& context, std::size_t argument) {
    Location start = where_;
    if (start.file.empty()) start.file = owner_;
    expressions_.push_back(context.functions.compile(context.strings()[argument], start, context_));
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

FunctionCall::FunctionCall(const FunctionSet& set, Tracer& tracer, const Interaction& at,
                           const MaterialVariables* variables)
    : set_(set),
      at_(at),
      to_local_(&set.to_local_),
      variables_(variables),
      evaluator_(tracer.evaluator()),
      host_{this, channel_value, set.reals_, set.owner_, &set.where_},
      faults_(evaluator_.fault_count()) {
    evaluator_.next_clock();
    if (at.placement) [[unlikely]]
        place(tracer.scene().geometry());
}

void FunctionCall::place(const Geometry& geometry) {
    Placement placement;
    if (geometry.modifier_placement(at_.placement, placement))
        to_local_ = &placed_.emplace(placement.to_inside() * set_.to_local_);
}

Vec3 FunctionSet::to_scene(const Tracer& tracer, const Interaction& at, const Vec3& v) const {
    Placement placement;
    if (!at.placement || !tracer.scene().geometry().modifier_placement(at.placement, placement))
        return turned(v);
    return placement.direction_outside(turned(v));
}

double FunctionSet::length_in_scene(const Tracer& tracer, const Interaction& at, double length) const {
    const double scaled = length * from_local_.magnification();
    Placement placement;
    if (!at.placement || !tracer.scene().geometry().modifier_placement(at.placement, placement))
        return scaled;
    return placement.scale() * scaled;
}

void FunctionCall::expressions(double* values) {
    for (std::size_t n = 0; n < set_.expressions_.size(); ++n) *values++ = expression(n);
}

double FunctionCall::expression(std::size_t n) {
    try {
        return evaluator_.evaluate(set_.expressions_[n], host_);
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
    const auto& m = to_local_->matrix;
    return (v.x * m[0][i] + v.y * m[1][i] + v.z * m[2][i]) / to_local_->magnification();
}

double FunctionCall::material_value(int number) const {
    if (number < cal::perturbed_dot)
        return local_direction(variables_->normal, number - cal::perturbed_normal);
    if (number == cal::perturbed_dot) return variables_->cosine;
    return variables_->color[number - cal::material_color];
}

double FunctionCall::channel_value(const void* self, int number) {
    const FunctionCall& view = *static_cast<const FunctionCall*>(self);
    if (number >= cal::perturbed_normal && number < cal::light_direction && view.variables_)
        return view.material_value(number);
    if (number >= cal::light_direction && number < cal::light_direction + 3 && view.light_direction_)
        return view.local_direction(*view.light_direction_, number - cal::light_direction);
    const double side = view.variables_ && view.variables_->tells_sides && view.at_.flipped ? -1 : 1;
    return hit_channel(view.at_, *view.to_local_, side, number);
}

}  // namespace infra
