// Means of random values with their standard errors, and what a test may expect of them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

namespace infra::test {

struct Estimate {
    double mean = 0;
    double error = 0;  ///< standard error of the mean
};

/// Adds up values (Welford's running mean and variance).
class Mean {
  public:
    void add(double value) {
        ++count_;
        const double step = value - mean_;
        mean_ += step / static_cast<double>(count_);
        squares_ += step * (value - mean_);
    }
    Estimate estimate() const {
        const auto n = static_cast<double>(count_);
        return {mean_, count_ > 1 ? std::sqrt(squares_ / (n - 1) / n) : 0.0};
    }

  private:
    long count_ = 0;
    double mean_ = 0, squares_ = 0;
};

/// Radiance is summed in single precision: so much, relative, is no noise and no fault.
inline constexpr double rounding = 5e-6;

/// Within `bar` (relative) of the closed form and within 4 standard errors of it.
inline void expect_close(const Estimate& estimate, double expected, double bar) {
    const double size = std::fabs(expected);
    EXPECT_NEAR(estimate.mean, expected, bar * size) << "standard error " << estimate.error;
    EXPECT_NEAR(estimate.mean, expected, 4 * estimate.error + rounding * size)
        << "standard error " << estimate.error;
    EXPECT_LE(4 * estimate.error, 2 * bar * size) << "too noisy to say anything";
}

/// Two estimates of one value, within 4 standard errors of their difference.
inline void expect_same(const Estimate& a, const Estimate& b) {
    EXPECT_NEAR(a.mean, b.mean, 4 * std::hypot(a.error, b.error) + rounding * std::fabs(a.mean))
        << "standard errors " << a.error << " and " << b.error;
}

}  // namespace infra::test
