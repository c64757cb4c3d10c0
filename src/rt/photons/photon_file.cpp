#include "rt/photons/photon_file.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

#include "common/error.h"
#include "common/format.h"
#include "scene/byte_reader.h"

namespace infra {
namespace {

constexpr const char* file_kind = "photon map";
constexpr std::size_t longest_line = 1 << 16;
constexpr const char* version = "3.1k";
constexpr std::size_t record_bytes = 27;
constexpr std::size_t source_number_bytes = 2;
constexpr std::size_t records_at_once = 4096;

constexpr std::string_view format_key = "FORMAT=";
constexpr std::string_view format_start = "Radiance_";
constexpr std::string_view tree_end = "_kdT_Photon_Map";
constexpr std::string_view paged_end = "_OOC_Photon_Map";
constexpr std::string_view kind_words[photon_kinds] = {"Global", "PreComp", "Caustic",
                                                       "Volume", "Direct",  "Contrib"};

[[noreturn]] void reject_format(const std::string& path, const std::string& format) {
    if (format.ends_with(paged_end))
        throw Error(Location{path}, "photons in an octree of pages are not supported",
                    "make the map with a mkpmap that keeps them in a kd-tree, RADIANCE's default");
    throw Error(Location{path}, format.empty() ? "this is no photon map"
                                               : "this is no photon map but a file of format " + format);
}

PhotonKind read_kind(ByteReader& in) {
    std::string format;
    std::string line = in.line(longest_line);
    if (!line.starts_with("#?")) in.fail("this is no photon map");
    for (; !line.empty(); line = in.line(longest_line))
        if (line.starts_with(format_key)) {
            format = line.substr(format_key.size());
            format.erase(format.find_last_not_of(" \r\t") + 1);
        }
    for (std::size_t kind = 0; kind < photon_kinds; ++kind)
        if (format == std::string(format_start) + std::string(kind_words[kind]) + std::string(tree_end))
            return static_cast<PhotonKind>(kind);
    reject_format(in.name(), format);
}

std::uint32_t unsigned_at(const unsigned char* bytes) {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 |
           bytes[3];
}

/// ByteReader::real() without its calls.
float real_at(const unsigned char* bytes) {
    const auto mantissa = static_cast<std::int32_t>(unsigned_at(bytes));
    if (mantissa == 0) return 0.0f;
    const double middle = static_cast<double>(mantissa) + (mantissa < 0 ? -0.5 : 0.5);
    const auto exponent = static_cast<std::uint64_t>(1023 + static_cast<std::int8_t>(bytes[4]));
    return static_cast<float>(middle * (1.0 / 0x7fffffff) * std::bit_cast<double>(exponent << 52));
}

Photon photon_at(const unsigned char* bytes) {
    Photon photon;
    for (std::size_t i = 0; i < 3; ++i) photon.position[i] = real_at(bytes + 5 * i);
    std::memcpy(photon.direction.data(), bytes + 15, 3);
    std::memcpy(photon.flux.data(), bytes + 18, 4);
    photon.flags = bytes[26];
    return photon;
}

void read_photons(ByteReader& in, PhotonMap& map) {
    std::vector<unsigned char> buffer(record_bytes * records_at_once);
    for (std::size_t first = 0; first < map.size(); first += records_at_once) {
        const std::size_t count = std::min(records_at_once, map.size() - first);
        in.bytes(buffer.data(), record_bytes * count);
        for (std::size_t i = 0; i < count; ++i) {
            const Photon photon = photon_at(&buffer[record_bytes * i]);
            if (photon.axis() > 2)
                in.fail_damaged(formatted("photon %zu divides space along no axis", first + i + 1));
            map.place(first + i, photon);
        }
    }
}

/// Bytes from here to the end, or nothing for what is no plain file.
std::optional<std::uint64_t> bytes_in(std::FILE* file) {
    if (fseeko(file, 0, SEEK_END) != 0) return {};
    const auto end = ftello(file);
    if (end < 0 || fseeko(file, 0, SEEK_SET) != 0) return {};
    return static_cast<std::uint64_t>(end);
}

}  // namespace

PhotonMap read_photon_map(const std::string& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) throw Error("cannot open photon map \"" + path + "\": " + std::strerror(errno));
    const auto file_bytes = bytes_in(file.get());
    if (!file_bytes)
        throw Error(Location{path}, "a photon map cannot come from a pipe", "write it to a file first");
    ByteReader in(file.get(), path, file_kind);
    const PhotonKind kind = read_kind(in);
    if (const std::string found = in.string(64); found != version)
        throw Error(Location{path}, "photon maps of version \"" + found + "\" are not supported",
                    std::string("this program reads ") + version);
    const std::int64_t count = in.integer(8);
    if (count <= 0 || static_cast<std::uint64_t>(count) > PhotonMap::most_photons)
        in.fail_damaged(formatted("%lld photons", static_cast<long long>(count)));
    constexpr int before_spread = 3 + 6 + 3;  // mean flux, bounds, mean place
    for (int i = 0; i < before_spread; ++i) in.real();
    const double spread2 = in.real();
    if (spread2 < 0) in.fail_damaged("a negative mean square distance");
    const std::uint64_t primary_rays = static_cast<std::uint32_t>(in.integer(4));
    const std::uint64_t needed =
        primary_rays * source_number_bytes + static_cast<std::uint64_t>(count) * record_bytes;
    // Before any memory is asked for
    if (*file_bytes < needed) in.fail("truncated photon map");
    for (std::uint64_t i = 0; i < primary_rays; ++i) in.integer(source_number_bytes);
    PhotonMap map(kind, static_cast<std::size_t>(count), spread2);
    read_photons(in, map);
    return map;
}

}  // namespace infra
