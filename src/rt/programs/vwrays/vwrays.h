// vwrays: the rays of a view or picture, for rtrace.
#pragma once

namespace infra {

int vwrays(int argc, char** argv);

}  // namespace infra
