// Radiance, reflectance and the like in N channels, N chosen when a scene is loaded (3 unless the user says
// otherwise).
//
// Channels lie in lanes of four floats that the compiler keeps in vector registers. Unused lanes stay zero,
// so sums and maxima over whole lanes are right. A Spectrum of three channels costs one register; a wider one
// costs what it holds.
#pragma once

namespace infra {

class Spectrum {
  public:
    static constexpr int max_channels = 64;

    /// All channels equal to `value`. channels: 1..max_channels.
    explicit Spectrum(int channels, float value = 0.0f) : channels_(channels) {
        for_lanes([&](int l) { lane_[l] = Lane{}; });
        if (value != 0.0f) fill(value);
    }
    Spectrum(const Spectrum& other) : channels_(other.channels_) {
        for_lanes([&](int l) { lane_[l] = other.lane_[l]; });
    }
    Spectrum& operator=(const Spectrum& other) {
        channels_ = other.channels_;
        for_lanes([&](int l) { lane_[l] = other.lane_[l]; });
        return *this;
    }

    bool operator==(const Spectrum& other) const {
        for (int c = 0; c < channels_; ++c)
            if ((*this)[c] != other[c]) return false;
        return channels_ == other.channels_;
    }

    int channels() const { return channels_; }
    float operator[](int c) const { return lane_[c / 4][c % 4]; }
    void set(int c, float value) { lane_[c / 4][c % 4] = value; }
    void fill(float value) {
        for_lanes([&](int l) {
            const Bits in_use = Bits{0, 1, 2, 3} < channels_ - 4 * l;
            lane_[l] = reinterpret_cast<Lane>(reinterpret_cast<Bits>(Lane{} + value) & in_use);
        });
    }
    void clear() {
        for_lanes([&](int l) { lane_[l] = Lane{}; });
    }

    Spectrum& operator+=(const Spectrum& other) {
        for_lanes([&](int l) { lane_[l] += other.lane_[l]; });
        return *this;
    }
    Spectrum& operator-=(const Spectrum& other) {
        for_lanes([&](int l) { lane_[l] -= other.lane_[l]; });
        return *this;
    }
    Spectrum& operator*=(const Spectrum& other) {
        for_lanes([&](int l) { lane_[l] *= other.lane_[l]; });
        return *this;
    }
    Spectrum& operator*=(float factor) {
        for_lanes([&](int l) { lane_[l] *= factor; });
        return *this;
    }
    /// this += other * factor, the inner step of every sum over samples.
    void add_scaled(const Spectrum& other, float factor) {
        for_lanes([&](int l) { lane_[l] += other.lane_[l] * factor; });
    }
    /// this += a * b, channel by channel.
    void add_product(const Spectrum& a, const Spectrum& b) {
        for_lanes([&](int l) { lane_[l] += a.lane_[l] * b.lane_[l]; });
    }

    /// Whether no channel is infinite or not a number.
    bool finite() const {
        Lane sum{};  // x * 0 is 0 for finite x only
        for_lanes([&](int l) { sum += lane_[l] * 0.0f; });
        return (sum[0] + sum[1]) + (sum[2] + sum[3]) == 0.0f;
    }

    /// Largest channel, or 0 if all are negative: a ray's weight.
    float maximum() const {
        float largest = 0.0f;
        for (int c = 0; c < channels_; ++c) largest = (*this)[c] > largest ? (*this)[c] : largest;
        return largest;
    }
    float mean() const {
        float sum = 0.0f;
        for (int c = 0; c < channels_; ++c) sum += (*this)[c];
        return sum / static_cast<float>(channels_);
    }
    /// Weight of a radiance in decisions (thresholds, adaptive sampling), never in results: RADIANCE's
    /// luminance weights for three channels, the mean for any other number.
    float brightness() const {
        if (channels_ != 3) return mean();
        return 0.265074126f * (*this)[0] + 0.670114631f * (*this)[1] + 0.064811243f * (*this)[2];
    }

  private:
    typedef float Lane __attribute__((vector_size(16)));
    typedef int Bits __attribute__((vector_size(16)));

    // The first lane is written out, for three channels have no other.
    template <class Step>
    void for_lanes(Step&& step) const {
        step(0);
        if (channels_ > 4) [[unlikely]]
            for (int l = 1; 4 * l < channels_; ++l) step(l);
    }

    int channels_;  // before the lanes, next to the first of them
    Lane lane_[max_channels / 4];
};

inline Spectrum operator*(Spectrum a, const Spectrum& b) { return a *= b; }
inline Spectrum operator*(Spectrum a, float factor) { return a *= factor; }

}  // namespace infra
