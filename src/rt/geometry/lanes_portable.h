// Eight floats at once, and four, as the compiler makes them of what the processor has.

struct Lanes {
    typedef float Half __attribute__((vector_size(16)));
    typedef std::int32_t HalfMask __attribute__((vector_size(16)));
    Half low, high;

    Lanes(const Half& l, const Half& h) : low(l), high(h) {}
    explicit Lanes(float v) : low{v, v, v, v}, high(low) {}
    static Lanes bytes(const std::uint8_t* eight) { return integers(eight); }
    static Lanes words(const std::uint16_t* eight) { return integers(eight); }
    void store(float* eight) const {
        std::memcpy(eight, &low, sizeof low);
        std::memcpy(eight + 4, &high, sizeof high);
    }

    Lanes times_plus(const Lanes& factor, const Lanes& sum) const {
        return {low * factor.low + sum.low, high * factor.high + sum.high};
    }
    Lanes magnitude() const { return {low < 0.0f ? -low : low, high < 0.0f ? -high : high}; }

    template <class Integer>
    static Lanes integers(const Integer* eight) {
        const auto half = [](const Integer* four) {
            return __builtin_convertvector((HalfMask{four[0], four[1], four[2], four[3]}), Half);
        };
        return {half(eight), half(eight + 4)};
    }
    static unsigned bits(const HalfMask& mask) {
#if defined(__SSE__)
        return static_cast<unsigned>(__builtin_ia32_movmskps(__builtin_bit_cast(Half, mask)));
#else
        return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
#endif
    }
};

inline Lanes operator*(const Lanes& a, const Lanes& b) { return {a.low * b.low, a.high * b.high}; }
inline Lanes operator-(const Lanes& a, const Lanes& b) { return {a.low - b.low, a.high - b.high}; }
inline Lanes min(const Lanes& a, const Lanes& b) {
    return {a.low < b.low ? a.low : b.low, a.high < b.high ? a.high : b.high};
}
inline Lanes max(const Lanes& a, const Lanes& b) {
    return {a.low > b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};
}
/// A bit for each lane where a <= b.
inline unsigned not_above(const Lanes& a, const Lanes& b) {
    return Lanes::bits(a.low <= b.low) | Lanes::bits(a.high <= b.high) << 4;
}

struct Quad {
    Lanes::Half value;

    Quad(const Lanes::Half& v) : value(v) {}
    static Quad load(const Lanes::Half& four) { return four; }
    static Quad load(const float* four) {
        Lanes::Half v;
        std::memcpy(&v, four, sizeof v);
        return v;
    }
    /// 2^(byte - 127) for each of four bytes; small powers of no meaning for bytes that are not exponents.
    static Quad powers(const std::uint8_t* four) {
        return __builtin_bit_cast(Lanes::Half, Lanes::HalfMask{four[0], four[1], four[2], four[3]} << 23);
    }
    float operator[](int i) const { return value[i]; }
    template <int axis>
    Lanes spread() const {
        return Lanes(value[axis]);
    }
    Quad times_minus(const Quad& factor, const Quad& less) const { return value * factor.value - less.value; }
    Quad permuted(const std::int32_t* order) const {
        return Lanes::Half{value[order[0]], value[order[1]], value[order[2]], value[order[3]]};
    }
};

inline Quad operator*(const Quad& a, const Quad& b) { return a.value * b.value; }
inline Quad operator-(const Quad& a, const Quad& b) { return a.value - b.value; }
