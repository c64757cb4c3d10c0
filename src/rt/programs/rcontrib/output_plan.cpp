#include "rt/programs/rcontrib/output_plan.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "common/error.h"
#include "common/format.h"

namespace infra {
namespace {

void append(OutputTarget& target, std::size_t spectrum) {
    ++target.size;
    if (!target.ranges.empty() && target.ranges.back().first + target.ranges.back().count == spectrum)
        ++target.ranges.back().count;
    else
        target.ranges.push_back({spectrum, 1});
}

class Planner {
  public:
    Planner(const RcontribSettings& settings, const WarningSink& warn) : settings_(settings), warn_(warn) {}

    void add(const TrackedModifier& modifier, int bins) {
        int first = 0;
        if (modifier.output && settings_.output == NumberFormat::color)
            while (is_taken_picture(modifier, first)) ++first;
        for (int i = 0; i < bins; ++i) append(target(modifier, first + i), spectra_++);
    }

    std::vector<OutputTarget> take() { return std::move(targets_); }

  private:
    bool is_taken_picture(const TrackedModifier& modifier, int bin) const {
        const OutputName name = output_name(*modifier.output, modifier.name, bin);
        const auto known = by_name_.find(name.text);
        if (!name.names_bin || known == by_name_.end()) return false;
        const OutputTarget& target = targets_[known->second];
        return target.width > 0 && target.height > 0;
    }

    OutputTarget& target(const TrackedModifier& modifier, int bin) {
        const OutputName name =
            modifier.output ? output_name(*modifier.output, modifier.name, bin) : OutputName{};
        if (modifier.output && name.text.empty()) throw Error("empty output name in -o");
        const auto [known, is_new] = by_name_.try_emplace(name.text, targets_.size());
        if (!is_new) {
            OutputTarget& same = targets_[known->second];
            if (same.is_file() && settings_.output == NumberFormat::color && same.width > 0 &&
                same.height > 0 && same.size == 1)
                warn_("output '" + name.text + "' is not a valid picture: it has several values a pixel");
            return same;
        }
        OutputTarget& made = targets_.emplace_back();
        made.name = name.text;
        made.modifier = modifier.name;
        made.bin = bin;
        made.names_modifier = name.names_modifier;
        made.names_bin = name.names_bin;
        // Of several records the size is that of the whole; files of one have that which was given before -m.
        const bool one_record = settings_.accumulate == 0 && modifier.output;
        made.width = one_record ? modifier.width : settings_.width;
        made.height = one_record ? modifier.height : settings_.height;
        if (made.is_file() && !settings_.force && !settings_.recover && access(made.name.c_str(), F_OK) == 0)
            throw Error("cannot open '" + made.name + "' for writing: it exists",
                        "-fo writes over it, -r goes on where it ends", Severity::system);
        return made;
    }

    const RcontribSettings& settings_;
    const WarningSink& warn_;
    std::vector<OutputTarget> targets_;
    std::map<std::string, std::size_t> by_name_;
    std::size_t spectra_ = 0;
};

}  // namespace

OutputName output_name(const std::string& specification, const std::string& modifier, int bin) {
    OutputName name;
    for (std::size_t i = 0; i < specification.size(); ++i) {
        if (specification[i] != '%') {
            name.text += specification[i];
            continue;
        }
        const std::size_t begin = i++;
        while (i < specification.size() && std::isdigit(static_cast<unsigned char>(specification[i]))) ++i;
        const char kind = i < specification.size() ? specification[i] : '\0';
        const std::string width = specification.substr(begin + 1, i - begin - 1);
        const bool is_bin = kind != '\0' && std::string_view("dioxX").find(kind) != std::string_view::npos;
        const bool twice = (kind == 's' && name.names_modifier) || (is_bin && name.names_bin);
        if ((kind != '%' && kind != 's' && !is_bin) || twice || width.size() > 3)
            throw Error("bad output format '" + specification + "'",
                        "%s stands for the modifier, %d for the bin, each once");
        if (kind == '%') {
            name.text += '%';
        } else if (kind == 's') {
            name.names_modifier = true;
            const std::size_t least = width.empty() ? 0 : static_cast<std::size_t>(std::stoi(width));
            if (modifier.size() < least) name.text.append(least - modifier.size(), ' ');
            name.text += modifier;
        } else {
            name.names_bin = true;
            const std::string format = "%" + width + kind;
            name.text += formatted(format.c_str(), bin);
        }
    }
    return name;
}

std::vector<OutputTarget> plan_outputs(const RcontribSettings& settings, const std::vector<BinRule>& bins,
                                       const WarningSink& warn) {
    Planner planner(settings, warn);
    for (std::size_t i = 0; i < settings.modifiers.size(); ++i)
        planner.add(settings.modifiers[i], bins[i].count);
    return planner.take();
}

}  // namespace infra
