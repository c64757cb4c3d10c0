#include "common/version.h"

namespace infra {

const char* version_string() { return "Infradiance " INFRA_VERSION; }

}  // namespace infra
