#include "cal/ray_library.h"

namespace infra::cal {
namespace {

struct ChannelName {
    const char* name;
    int number;
};

// Known before any file is read, so that a rayinit.cal that does not define them, such as RADIANCE's, serves
// as well.
constexpr ChannelName channel_names[] = {
    {"Dx", 1},   {"Dy", 2},   {"Dz", 3},    {"Nx", 4},   {"Ny", 5},   {"Nz", 6},   {"Px", 7},     {"Py", 8},
    {"Pz", 9},   {"T", 10},   {"Rdot", 11}, {"S", 12},   {"Tx", 13},  {"Ty", 14},  {"Tz", 15},    {"Ix", 16},
    {"Iy", 17},  {"Iz", 18},  {"Jx", 19},   {"Jy", 20},  {"Jz", 21},  {"Kx", 22},  {"Ky", 23},    {"Kz", 24},
    {"Ts", 25},  {"Lu", 26},  {"Lv", 27},   {"NxP", 28}, {"NyP", 29}, {"NzP", 30}, {"RdotP", 31}, {"CrP", 32},
    {"CgP", 33}, {"CbP", 34}, {"DxA", 35},  {"DyA", 36}, {"DzA", 37},
};

}  // namespace

Library make_ray_library() {
    Library library(ray_builtins());
    for (const ChannelName& channel : channel_names) library.define_channel(channel.name, channel.number);
    library.load_file("rayinit.cal");
    return library;
}

}  // namespace infra::cal
