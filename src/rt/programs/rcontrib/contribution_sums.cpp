#include "rt/programs/rcontrib/contribution_sums.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "common/spectra/channels.h"
#include "rt/functions/hit_channel.h"
#include "rt/path_coefficient.h"

namespace infra {
namespace {

constexpr int unknown = -2;
const Transform world;  // leaves everything where it is

/// The variables of a bin are those of the hit in the scene's own coordinates.
double channel_value(const void* self, int number) {
    return hit_channel(*static_cast<const Interaction*>(self), world, 1, number);
}

}  // namespace

ContributionPlan::ContributionPlan(const RcontribSettings& settings, const BinFunctions& bins,
                                   const CompiledScene& scene)
    : settings_(settings),
      bins_(bins),
      scene_(scene),
      air_(settings.render.settings.irradiance || settings.immediate_irradiance ? nullptr : scene.air()),
      of_finish_(static_cast<std::size_t>(scene.finish_count()), unknown) {
    std::map<std::string_view, int> numbers;
    std::size_t values = 0;
    for (const TrackedModifier& modifier : settings.modifiers) {
        const std::size_t number = numbers.size();
        first_.push_back(values);
        values += static_cast<std::size_t>(bins.rules()[number].count) *
                  static_cast<std::size_t>(scene.channel_count());
        numbers.emplace(modifier.name, static_cast<int>(number));
    }
    first_.push_back(values);
    for (int i = 0; i < scene.surface_count(); ++i) {
        std::int32_t& number = of_finish_[static_cast<std::size_t>(scene.surface(i).finish)];
        if (number != unknown) continue;  // all surfaces of a finish have the same modifier
        const auto found = numbers.find(scene.modifier_name(i));
        number = found == numbers.end() ? -1 : found->second;
    }
}

std::vector<std::string> ContributionPlan::unused() const {
    std::vector<bool> used(settings_.modifiers.size(), false);
    for (const std::int32_t number : of_finish_)
        if (number >= 0) used[static_cast<std::size_t>(number)] = true;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (!used[i]) names.push_back(settings_.modifiers[i].name);
    return names;
}

ContributionSums::ContributionSums(const ContributionPlan& plan)
    : plan_(plan),
      evaluators_(plan.bins().programs().begin(), plan.bins().programs().end()),
      channels_(static_cast<std::size_t>(plan.scene().channel_count())),
      values_(plan.value_count(), 0.0) {}

void ContributionSums::observe(const Interaction& at) {
    if (!at.hit()) return;
    const int modifier = plan_.modifier_of(at.surface);
    if (modifier < 0) return;
    // On its way to a light source a ray counts for nothing else.
    const int aimed = at.ray->aimed_source;
    if (aimed >= 0 && plan_.scene().source(aimed).surface != at.surface) return;
    if (at.counted_elsewhere && !plan_.settings().contributions) return;
    Spectrum share = path_coefficient(at, plan_.air());
    if (plan_.settings().contributions) share *= at.radiance;
    double value[Channels::most];
    bool dark = true;
    for (std::size_t c = 0; c < channels_; ++c) {
        value[c] = double(share[static_cast<int>(c)]);
        dark = dark && value[c] == 0;
    }
    if (dark) return;
    const int bin = bin_of(modifier, at);
    if (bin >= 0) add(plan_.first_value(modifier) + static_cast<std::size_t>(bin) * channels_, value);
}

// Below 0: it belongs to none.
int ContributionSums::bin_of(int modifier, const Interaction& at) {
    const BinRule& rule = plan_.bins().rules()[static_cast<std::size_t>(modifier)];
    if (rule.program < 0) return 0;
    cal::Evaluator& evaluator = evaluators_[static_cast<std::size_t>(rule.program)];
    evaluator.next_clock();
    const cal::Host host{.self = &at, .channel = channel_value, .owner = "-b"};
    double bin;
    try {
        bin = evaluator.evaluate(rule.expression, host);
    } catch (const Error& error) {
        if (!error.where().file.empty()) throw;
        throw host.error(error.message(), error.hint());
    }
    if (!(bin > -0.5)) return -1;
    if (bin + 0.5 >= rule.count) {
        ++misplaced_count_;
        misplaced_ = static_cast<std::size_t>(modifier);
        misplaced_bin_ = std::floor(bin + 0.5);
        return -1;
    }
    return static_cast<int>(bin + 0.5);
}

void ContributionSums::add(std::size_t first, const double* value) {
    if (!open_sums_.empty()) [[unlikely]] {
        pending_bins_.push_back(first);
        pending_values_.insert(pending_values_.end(), value, value + channels_);
        return;
    }
    for (std::size_t c = 0; c < channels_; ++c) values_[first + c] += value[c];
}

void ContributionSums::end_sum(double factor) {
    const std::size_t begin = open_sums_.back();
    open_sums_.pop_back();
    for (std::size_t i = begin * channels_; i < pending_values_.size(); ++i) pending_values_[i] *= factor;
    if (!open_sums_.empty()) return;
    for (std::size_t i = 0; i < pending_bins_.size(); ++i)
        add(pending_bins_[i], &pending_values_[i * channels_]);
    pending_bins_.clear();
    pending_values_.clear();
}

void ContributionSums::clear() { std::ranges::fill(values_, 0.0); }

std::uint64_t ContributionSums::fault_count() const {
    std::uint64_t sum = 0;
    for (const cal::Evaluator& evaluator : evaluators_) sum += evaluator.fault_count();
    return sum;
}

std::string ContributionSums::last_fault() const {
    for (const cal::Evaluator& evaluator : evaluators_)
        if (evaluator.fault_count() > 0) return evaluator.last_fault();
    return {};
}

}  // namespace infra
