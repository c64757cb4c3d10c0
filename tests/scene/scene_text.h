// Scenes from text, for the tests of this folder.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/rad_reader.h"

namespace infra::test {

inline Scene scene_of(std::string_view text, std::vector<std::string>* warnings = nullptr) {
    Scene scene;
    read_rad_text(scene, text, "test.rad", [&](std::string_view warning) {
        if (warnings != nullptr) warnings->emplace_back(warning);
    });
    return scene;
}

inline std::vector<std::string> strings_of(const Scene& scene, PrimitiveId id) {
    return {scene.strings(id).begin(), scene.strings(id).end()};
}

inline std::vector<double> reals_of(const Scene& scene, PrimitiveId id) {
    return {scene.reals(id).begin(), scene.reals(id).end()};
}

}  // namespace infra::test
