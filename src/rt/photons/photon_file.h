// Photon map files as RADIANCE's mkpmap writes them, with the photons in a kd-tree.
//
// A header of text lines, one of them FORMAT=Radiance_<kind>_kdT_Photon_Map, and an empty line. Then,
// big-endian (scene/byte_reader.h): the version "3.1k" and a zero byte; the number of photons [8 bytes]; the
// mean flux of a photon [3 floats of 5 bytes]; the least and greatest x, the same of y and z [6 floats]; the
// mean place [3 floats], and the mean square distance from it; the number of primary rays [4 bytes] and for
// each the number of its light source [2 bytes]; photons of 27 bytes in heap order, that is root first, the
// children of the i-th (from 1) at 2i and 2i+1: position [3 floats], normal times 127 [3 bytes], flux as RGBE
// [4 bytes], number of the primary ray [4 bytes], flags [1 byte: bits 0 and 1 the axis that divides the
// children, bit 2 caustic, above these the process it came from].
#pragma once

#include <string>

#include "rt/photons/photon_map.h"

namespace infra {

/// Reads a map.
///   throws  Error with the file's name when it cannot be read, is something else, or is damaged or cut off
PhotonMap read_photon_map(const std::string& path);

}  // namespace infra
