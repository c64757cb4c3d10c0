// Adds up what the surfaces of some modifiers contribute to a ray, bin by bin. One per thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cal/evaluator.h"
#include "rt/programs/rcontrib/bin_functions.h"
#include "rt/tracer.h"

namespace infra {

/// What all threads share: which surface belongs to which modifier, and where its bins are.
class ContributionPlan {
  public:
    ContributionPlan(const RcontribSettings& settings, const BinFunctions& bins, const CompiledScene& scene);

    const RcontribSettings& settings() const { return settings_; }
    const BinFunctions& bins() const { return bins_; }
    const CompiledScene& scene() const { return scene_; }
    const AirPath* air() const { return air_; }

    /// Number of the modifier among those of the settings, -1: none of them.
    int modifier_of(int surface) const {
        return of_finish_[static_cast<std::size_t>(scene_.surface(surface).finish)];
    }
    /// Where a modifier's values begin; bins follow one another, each of a number a channel.
    std::size_t first_value(int modifier) const { return first_[static_cast<std::size_t>(modifier)]; }
    std::size_t value_count() const { return first_.back(); }
    /// Modifiers that no surface has.
    std::vector<std::string> unused() const;

  private:
    const RcontribSettings& settings_;
    const BinFunctions& bins_;
    const CompiledScene& scene_;
    const AirPath* air_;
    std::vector<std::int32_t> of_finish_;
    std::vector<std::size_t> first_;  ///< by modifier, and the end
};

class ContributionSums final : public RayObserver {
  public:
    explicit ContributionSums(const ContributionPlan& plan);

    void observe(const Interaction& at) override;
    bool watches(int surface) const override { return plan_.modifier_of(surface) >= 0; }
    void begin_sum() override { open_sums_.push_back(pending_bins_.size()); }
    void end_sum(double factor) override;

    /// The sums since the last clear(), ContributionPlan::value_count() of them.
    std::span<const double> values() const { return values_; }
    void clear();

    /// Contributions to bins that do not exist: how many, and one of them.
    std::uint64_t misplaced_count() const { return misplaced_count_; }
    const std::string& misplaced_modifier() const { return plan_.settings().modifiers[misplaced_].name; }
    double misplaced_bin() const { return misplaced_bin_; }
    /// Domain errors of the expressions.
    std::uint64_t fault_count() const;
    std::string last_fault() const;

  private:
    int bin_of(int modifier, const Interaction& at);
    void add(std::size_t first, const double* value);

    const ContributionPlan& plan_;
    std::vector<cal::Evaluator> evaluators_;  // as the plan's programs
    std::size_t channels_;
    std::vector<double> values_;
    std::vector<std::size_t> open_sums_;     // begun and not ended: how much was pending then
    std::vector<std::size_t> pending_bins_;  // first value of each
    std::vector<double> pending_values_;
    std::uint64_t misplaced_count_ = 0;
    std::size_t misplaced_ = 0;
    double misplaced_bin_ = 0;
};

}  // namespace infra
