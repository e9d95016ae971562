// Numbers and words of eight steps in registers, for kernels; include after core/simd/kernel.h.
#if defined(NOONMARK_STEP_REGISTERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef NOONMARK_STEP_REGISTERS_INL_H
#undef NOONMARK_STEP_REGISTERS_INL_H
#else
#define NOONMARK_STEP_REGISTERS_INL_H
#endif

#include "core/engines/projected/filling/step_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {

using StepNumbers = LanesUpTo<double, stepsTogether>;
using StepBits = hn::RebindToUnsigned<StepNumbers>;
inline constexpr StepNumbers stepNumbers;
inline constexpr StepBits stepBits;
/// Steps per register, and registers for eight steps.
inline constexpr std::size_t stepsAPart = hn::MaxLanes(stepNumbers),
                             partsOfSteps = stepsTogether / stepsAPart;

/// Eight numbers, one per step.
struct EightDoubles {
    hn::Vec<StepNumbers> part[partsOfSteps];

    EightDoubles() = default;
    HWY_INLINE EightDoubles(double everywhere) {
        for (auto& numbers : part) numbers = hn::Set(stepNumbers, everywhere);
    }
    HWY_INLINE EightDoubles(const StepDoubles& from) {
        for (std::size_t i = 0; i < partsOfSteps; ++i)
            part[i] = hn::Load(stepNumbers, from.values + i * stepsAPart);
    }
    HWY_INLINE void store(StepDoubles& to) const {
        for (std::size_t i = 0; i < partsOfSteps; ++i)
            hn::Store(part[i], stepNumbers, to.values + i * stepsAPart);
    }

    /// operation(i) makes part i.
    template <class Operation>
    static HWY_INLINE EightDoubles make(const Operation& operation) {
        EightDoubles made;
        for (std::size_t i = 0; i < partsOfSteps; ++i) made.part[i] = operation(i);
        return made;
    }

    friend HWY_INLINE EightDoubles operator+(const EightDoubles& a, const EightDoubles& b) {
        return make([&](std::size_t i) HWY_ATTR { return hn::Add(a.part[i], b.part[i]); });
    }
    friend HWY_INLINE EightDoubles operator-(const EightDoubles& a, const EightDoubles& b) {
        return make([&](std::size_t i) HWY_ATTR { return hn::Sub(a.part[i], b.part[i]); });
    }
    friend HWY_INLINE EightDoubles operator*(const EightDoubles& a, const EightDoubles& b) {
        return make([&](std::size_t i) HWY_ATTR { return hn::Mul(a.part[i], b.part[i]); });
    }
    friend HWY_INLINE EightDoubles operator-(const EightDoubles& a) {
        return make([&](std::size_t i) HWY_ATTR { return hn::Neg(a.part[i]); });
    }
};

/// The minimum per step.
HWY_INLINE EightDoubles minimum(const EightDoubles& a, const EightDoubles& b) {
    return EightDoubles::make([&](std::size_t i) HWY_ATTR { return hn::Min(b.part[i], a.part[i]); });
}
/// The maximum per step.
HWY_INLINE EightDoubles maximum(const EightDoubles& a, const EightDoubles& b) {
    return EightDoubles::make([&](std::size_t i) HWY_ATTR { return hn::Max(b.part[i], a.part[i]); });
}
/// a where `number` is above 0, else b.
HWY_INLINE EightDoubles whereAboveZero(const EightDoubles& number, const EightDoubles& a,
                                       const EightDoubles& b) {
    return EightDoubles::make([&](std::size_t i) HWY_ATTR {
        return hn::IfThenElse(hn::Gt(number.part[i], hn::Zero(stepNumbers)), a.part[i], b.part[i]);
    });
}
/// a where `number` is not below the limit, else b.
HWY_INLINE EightDoubles whereAtLeast(double limit, const EightDoubles& number, const EightDoubles& a,
                                     const EightDoubles& b) {
    return EightDoubles::make([&](std::size_t i) HWY_ATTR {
        return hn::IfThenElse(hn::Ge(number.part[i], hn::Set(stepNumbers, limit)), a.part[i], b.part[i]);
    });
}

/// The minimum over all steps.
HWY_INLINE double minimumOf(const EightDoubles& numbers) {
    auto lowest = numbers.part[0];
    for (std::size_t i = 1; i < partsOfSteps; ++i) lowest = hn::Min(lowest, numbers.part[i]);
    return hn::GetLane(hn::MinOfLanes(stepNumbers, lowest));
}

/// Whether all elements of `all` are above 0 and none of `none`.
HWY_INLINE bool allAndNoneAboveZero(const EightDoubles& all, const EightDoubles& none) {
    const auto zero = hn::Zero(stepNumbers);
    auto right = hn::AndNot(hn::Gt(none.part[0], zero), hn::Gt(all.part[0], zero));
    for (std::size_t i = 1; i < partsOfSteps; ++i)
        right = hn::And(right, hn::AndNot(hn::Gt(none.part[i], zero), hn::Gt(all.part[i], zero)));
    return hn::AllTrue(stepNumbers, right);
}

/// One point per step.
struct EightPoints {
    EightDoubles x, y;
    HWY_INLINE void store(StepPoints& to) const {
        x.store(to.x);
        y.store(to.y);
    }
    friend HWY_INLINE EightPoints operator+(const glm::dvec2& point, const EightPoints& by) {
        return {point.x + by.x, point.y + by.y};
    }
    friend HWY_INLINE EightPoints operator-(const EightPoints& a, const EightPoints& b) {
        return {a.x - b.x, a.y - b.y};
    }
};

/// Whether any bit is set.
HWY_INLINE bool anySet(hn::Vec<StepBits> bits) {
    return !hn::AllTrue(stepBits, hn::Eq(bits, hn::Zero(stepBits)));
}

/// The same word of the rasters of eight steps.
struct EightWords {
    hn::Vec<StepBits> part[partsOfSteps];

    EightWords() = default;
    HWY_INLINE EightWords(const StepWords& from) {
        for (std::size_t i = 0; i < partsOfSteps; ++i)
            part[i] = hn::Load(stepBits, from.words + i * stepsAPart);
    }
    HWY_INLINE void store(StepWords& to) const {
        for (std::size_t i = 0; i < partsOfSteps; ++i)
            hn::Store(part[i], stepBits, to.words + i * stepsAPart);
    }

    /// operation(i) makes part i.
    template <class Operation>
    static HWY_INLINE EightWords make(const Operation& operation) {
        EightWords made;
        for (std::size_t i = 0; i < partsOfSteps; ++i) made.part[i] = operation(i);
        return made;
    }

    friend HWY_INLINE EightWords operator&(const EightWords& a, const EightWords& b) {
        return make([&](std::size_t i) HWY_ATTR { return hn::And(a.part[i], b.part[i]); });
    }
    friend HWY_INLINE EightWords operator|(const EightWords& a, const EightWords& b) {
        return make([&](std::size_t i) HWY_ATTR { return hn::Or(a.part[i], b.part[i]); });
    }
    friend HWY_INLINE EightWords operator^(const EightWords& a, const EightWords& b) {
        return make([&](std::size_t i) HWY_ATTR { return hn::Xor(a.part[i], b.part[i]); });
    }
};

/// a without the bits of b.
HWY_INLINE EightWords without(const EightWords& a, const EightWords& b) {
    return EightWords::make([&](std::size_t i) HWY_ATTR { return hn::AndNot(b.part[i], a.part[i]); });
}

/// The bits that are set at any of the steps, spread over a register.
HWY_INLINE hn::Vec<StepBits> joinParts(const EightWords& steps) {
    auto joined = steps.part[0];
    for (std::size_t i = 1; i < partsOfSteps; ++i) joined = hn::Or(joined, steps.part[i]);
    return joined;
}
HWY_INLINE bool anySet(const EightWords& steps) { return anySet(joinParts(steps)); }

/// The bits that are set at any of the steps.
HWY_INLINE std::uint64_t joinSteps(const EightWords& steps) {
    alignas(64) std::uint64_t words[stepsAPart];
    hn::Store(joinParts(steps), stepBits, words);
    std::uint64_t joined = 0;
    for (const std::uint64_t word : words) joined |= word;
    return joined;
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
