#include "rt/programs/distributed/fingerprint.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>

#include "common/format.h"
#include "common/raypath.h"
#include "common/text_file.h"
#include "common/version.h"
#include "rt/programs/view_numbers.h"

namespace infra {
namespace {

/// Spreads every bit over all others.
/// source: SplitMix64, Steele, Lea & Flood, OOPSLA 2014
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15U;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31U);
}

bool is_file(const std::string& path) {
    struct stat status {};
    return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace

void Fingerprint::add_number(std::uint64_t number) { state_ = mixed(state_ ^ number); }

void Fingerprint::add_text(std::string_view bytes) {
    add_number(bytes.size());
    while (!bytes.empty()) {
        std::uint64_t number = 0;
        const std::size_t size = std::min(bytes.size(), sizeof number);
        std::memcpy(&number, bytes.data(), size);
        add_number(number);
        bytes.remove_prefix(size);
    }
}

void Fingerprint::add_view(const View& view) {
    const ViewNumbers numbers = numbers_of(view);
    add_text({reinterpret_cast<const char*>(numbers.data()), sizeof numbers});
}

void Fingerprint::add_file(const std::string& path) {
    constexpr std::size_t portion = 1 << 20;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) return;
    std::vector<char> bytes(portion);
    while (const std::size_t size = std::fread(bytes.data(), 1, portion, file.get()))
        add_text({bytes.data(), size});
}

void Fingerprint::add_files(std::vector<std::string> words) {
    std::vector<std::string> names;
    for (const std::string& word : words) {
        names.push_back(word);
        const std::vector<std::string> parts = split_words(word.starts_with('!') ? word.substr(1) : word);
        if (parts.size() > 1) names.insert(names.end(), parts.begin(), parts.end());
    }
    std::ranges::sort(names);
    names.erase(std::ranges::unique(names).begin(), names.end());
    for (const std::string& name : names) {
        if (name.empty()) continue;
        add_text(name);
        if (is_file(name))
            add_file(name);
        else if (const auto found = find_library_file(name); found && is_file(*found))
            add_file(*found);
    }
}

std::string Fingerprint::text() const {
    return formatted("%016llx", static_cast<unsigned long long>(state_));
}

Fingerprint fingerprint_of(const LoadedScene& loaded, const std::string& command,
                           const std::vector<std::string>& words) {
    Fingerprint fingerprint;
    fingerprint.add_text(version_string());
    fingerprint.add_text(command);
    for (const std::string& line : loaded.header) fingerprint.add_text(line);
    fingerprint.add_text({reinterpret_cast<const char*>(&loaded.cube), sizeof loaded.cube});
    std::vector<std::string> names = words;
    names.emplace_back("rayinit.cal");
    names.insert(names.end(), loaded.files.begin(), loaded.files.end());
    for (const ScenePart& part : loaded.scene->parts()) {
        const Scene& scene = part.text;
        names.insert(names.end(), scene.files().begin(), scene.files().end());
        for (PrimitiveId id = 0; id < scene.size(); ++id) {
            fingerprint.add_text(scene.name(id));
            for (const std::string_view text : scene.strings(id)) names.emplace_back(text);
        }
    }
    fingerprint.add_files(std::move(names));
    return fingerprint;
}

}  // namespace infra
