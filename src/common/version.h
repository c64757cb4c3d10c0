// The version that -version prints and that picture headers carry.
#pragma once

namespace infra {

/// For example "Infradiance 0.1.0".
const char* version_string();

}  // namespace infra
