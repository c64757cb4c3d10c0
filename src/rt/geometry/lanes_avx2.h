// Eight floats at once, and four, in AVX2's registers. Include it within a namespace whose code is for AVX2.

struct Lanes {
    __m256 value;

    Lanes(__m256 v) : value(v) {}
    explicit Lanes(float v) : value(_mm256_set1_ps(v)) {}
    static Lanes bytes(const std::uint8_t* eight) {
        const __m128i raw = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(eight));
        return _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(raw));
    }
    static Lanes words(const std::uint16_t* eight) {
        const __m128i raw = _mm_loadu_si128(reinterpret_cast<const __m128i*>(eight));
        return _mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(raw));
    }
    void store(float* eight) const { _mm256_store_ps(eight, value); }

    Lanes times_plus(const Lanes& factor, const Lanes& sum) const {
        return _mm256_fmadd_ps(value, factor.value, sum.value);
    }
    Lanes magnitude() const { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), value); }
};

inline Lanes operator*(const Lanes& a, const Lanes& b) { return _mm256_mul_ps(a.value, b.value); }
inline Lanes operator-(const Lanes& a, const Lanes& b) { return _mm256_sub_ps(a.value, b.value); }
inline Lanes min(const Lanes& a, const Lanes& b) { return _mm256_min_ps(a.value, b.value); }
inline Lanes max(const Lanes& a, const Lanes& b) { return _mm256_max_ps(a.value, b.value); }
/// A bit for each lane where a <= b.
inline unsigned not_above(const Lanes& a, const Lanes& b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.value, b.value, _CMP_LE_OQ)));
}

struct Quad {
    __m128 value;

    Quad(__m128 v) : value(v) {}
    static Quad load(const float* four) { return _mm_loadu_ps(four); }
    static Quad load(const BvhRay::Four& four) { return four; }
    /// 2^(byte - 127) for each of four bytes; small powers of no meaning for bytes that are not exponents.
    static Quad powers(const std::uint8_t* four) {
        std::int32_t raw;
        std::memcpy(&raw, four, sizeof raw);
        return _mm_castsi128_ps(_mm_slli_epi32(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(raw)), 23));
    }
    float operator[](int i) const { return value[i]; }
    template <int axis>
    Lanes spread() const {
        return _mm256_broadcastss_ps(_mm_shuffle_ps(value, value, axis * 0x55));
    }
    Quad times_minus(const Quad& factor, const Quad& less) const {
        return _mm_fmsub_ps(value, factor.value, less.value);
    }
    Quad permuted(const std::int32_t* order) const {
        return _mm_permutevar_ps(value, _mm_loadu_si128(reinterpret_cast<const __m128i*>(order)));
    }
};

inline Quad operator*(const Quad& a, const Quad& b) { return _mm_mul_ps(a.value, b.value); }
inline Quad operator-(const Quad& a, const Quad& b) { return _mm_sub_ps(a.value, b.value); }
