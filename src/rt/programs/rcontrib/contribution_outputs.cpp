#include "rt/programs/rcontrib/contribution_outputs.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "common/error.h"
#include "common/format.h"
#include "scene/info_header.h"

namespace infra {
namespace {

struct FileCloser {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

[[noreturn]] void fail(const std::string& what) {
    throw Error(what + ": " + std::strerror(errno), {}, Severity::system);
}

std::string quoted(const OutputTarget& target) {
    return target.name.empty() ? "the standard output" : "'" + target.name + "'";
}

}  // namespace

ContributionOutputs::ContributionOutputs(const RcontribSettings& settings, std::vector<OutputTarget> targets,
                                         std::string header_start, const Channels& channels)
    : settings_(settings),
      targets_(std::move(targets)),
      header_start_(std::move(header_start)),
      pixel_format_(format_name(settings.output, for_channels({OutputColor::Kind::spectrum}, channels))),
      format_(settings.output, channels.count()),
      files_(targets_.size(), nullptr) {}

ContributionOutputs::~ContributionOutputs() {
    for (std::size_t i = 0; i < files_.size(); ++i) {
        if (!files_[i] || files_[i] == stdout) continue;
        if (targets_[i].is_command())
            pclose(files_[i]);
        else
            std::fclose(files_[i]);
    }
}

std::string ContributionOutputs::size_line(const OutputTarget& target) const {
    const bool is_picture = target.size == 1 && target.width > 0 && target.height > 0;
    return is_picture ? formatted("-Y %8d +X %8d\n", target.height, target.width) : "";
}

std::string ContributionOutputs::header(const OutputTarget& target) const {
    if (!settings_.header) return size_line(target);
    std::string text = header_start_;
    const bool named = !target.name.empty();
    if (target.names_modifier || (named && target.size == 1)) text += "MODIFIER=" + target.modifier + "\n";
    if (target.names_bin) text += formatted("BIN=%d\n", target.bin);
    if (target.height > 0) text += formatted("NROWS=%d\n", target.height * std::max(target.width, 1));
    if (target.width <= 0 || target.size > 1) text += formatted("NCOLS=%zu\n", target.size);
    if (settings_.output == NumberFormat::floats || settings_.output == NumberFormat::doubles)
        text += formatted("BigEndian=%d\n", std::endian::native == std::endian::big ? 1 : 0);
    return text + "FORMAT=" + pixel_format_ + "\n\n" + size_line(target);
}

void ContributionOutputs::open(std::size_t i) {
    const OutputTarget& target = targets_[i];
    if (target.name.empty())
        files_[i] = stdout;
    else if (target.is_command())
        files_[i] = popen(target.name.c_str() + 1, "w");
    else
        files_[i] = std::fopen(target.name.c_str(), "w");
    if (!files_[i]) fail("cannot open " + quoted(target) + " for writing");
    const std::string text = header(target);
    std::fwrite(text.data(), 1, text.size(), files_[i]);
    if (settings_.flush_interval() > 0) std::fflush(files_[i]);
}

void ContributionOutputs::open() {
    if (opened_) return;
    opened_ = true;
    std::fflush(nullptr);  // commands must not write our bytes again
    for (std::size_t i = 0; i < targets_.size(); ++i)
        if (!files_[i]) open(i);
}

void ContributionOutputs::write(std::span<const std::string> texts) {
    open();
    for (std::size_t i = 0; i < texts.size(); ++i)
        if (std::fwrite(texts[i].data(), 1, texts[i].size(), files_[i]) != texts[i].size())
            fail("cannot write " + quoted(targets_[i]));
}

void ContributionOutputs::flush() {
    for (std::size_t i = 0; i < files_.size(); ++i)
        if (files_[i] && std::fflush(files_[i]) != 0) fail("cannot write " + quoted(targets_[i]));
}

void ContributionOutputs::close() {
    flush();
    for (std::size_t i = 0; i < files_.size(); ++i) {
        std::FILE* const file = std::exchange(files_[i], nullptr);
        if (!file || file == stdout) continue;
        if (!targets_[i].is_command()) {
            if (std::fclose(file) != 0) fail("cannot write " + quoted(targets_[i]));
        } else if (const int status = pclose(file); status != 0) {
            throw Error(formatted("the command %s failed", quoted(targets_[i]).c_str()), {},
                        Severity::system);
        }
    }
}

void ContributionOutputs::check_recoverable(const OutputTarget& target) const {
    if (!target.is_file())
        throw Error("cannot recover from " + quoted(target), "-r needs files, given with -o");
}

// To where the values begin.
void ContributionOutputs::skip_header(std::FILE* file, const OutputTarget& target) const {
    if (settings_.header) {
        const std::optional<InfoHeader> found = read_info_header(file);
        if (!found || split_words(found->format()) != split_words(pixel_format_))
            throw Error("'" + target.name + "' is no output of this kind",
                        "its format is not " + pixel_format_);
    }
    const std::string wanted = size_line(target);
    if (wanted.empty()) return;
    std::string line;
    for (int c = std::getc(file); c != EOF; c = std::getc(file)) {
        line.push_back(static_cast<char>(c));
        if (c == '\n') break;
    }
    if (line != wanted) throw Error("'" + target.name + "' has another resolution than -x and -y say");
}

std::uint64_t ContributionOutputs::resume(const WarningSink& warn) {
    if (settings_.output == NumberFormat::text)
        throw Error("cannot recover ASCII output", "-ff, -fd or -fc write records of a fixed size");
    std::vector<File> files;
    std::vector<long> begins;
    std::optional<std::uint64_t> least;
    for (const OutputTarget& target : targets_) {
        check_recoverable(target);
        File file(std::fopen(target.name.c_str(), "rb+"));
        if (!file) warn("missing recover file '" + target.name + "'");
        struct stat status {};
        if (!file || fstat(fileno(file.get()), &status) != 0 || status.st_size == 0) {
            least = 0;
            break;
        }
        skip_header(file.get(), target);
        begins.push_back(std::ftell(file.get()));
        const auto bytes = static_cast<std::uint64_t>(std::max(0L, long(status.st_size) - begins.back()));
        const std::uint64_t records = bytes / (target.size * format_.spectrum_bytes());
        least = std::min(least.value_or(records), records);
        files.push_back(std::move(file));
    }
    if (least.value_or(0) == 0) {
        warn("no previous data to recover");
        return 0;
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::uint64_t bytes = *least * targets_[i].size * format_.spectrum_bytes();
        const long end = begins[i] + static_cast<long>(bytes);
        if (ftruncate(fileno(files[i].get()), end) != 0 || std::fseek(files[i].get(), end, SEEK_SET) != 0)
            fail("cannot go on with '" + targets_[i].name + "'");
        files_[i] = files[i].release();
    }
    return *least;
}

bool ContributionOutputs::reload(std::span<double> sums, const WarningSink& warn) const {
    bool found = false;
    std::vector<double> spectrum(sums.size() == 0 ? 0 : static_cast<std::size_t>(format_.channels()));
    for (const OutputTarget& target : targets_) {
        check_recoverable(target);
        const File file(std::fopen(target.name.c_str(), "rb"));
        if (!file) {
            warn("missing reload file '" + target.name + "'");
            continue;
        }
        skip_header(file.get(), target);
        std::size_t taken = 0;
        for (const OutputTarget::Range& range : target.ranges)
            for (std::size_t i = 0; i < range.count; ++i, ++taken) {
                if (!format_.read(file.get(), spectrum)) {
                    if (taken == 0) break;  // an empty file
                    throw Error("missing data in '" + target.name + "'");
                }
                found = true;
                for (std::size_t c = 0; c < spectrum.size(); ++c)
                    sums[(range.first + i) * spectrum.size() + c] += spectrum[c];
            }
    }
    return found;
}

}  // namespace infra
