#include "rt/sources/light_relay.h"

#include "rt/tracer.h"

namespace infra {

const LightSource* image_aimed_at(const Tracer& tracer, const Interaction& at) {
    if (at.ray->aimed_source < 0) return nullptr;
    const LightSource& source = tracer.scene().source(at.ray->aimed_source);
    return source.is_virtual() && source.surface == at.surface ? &source : nullptr;
}

}  // namespace infra
