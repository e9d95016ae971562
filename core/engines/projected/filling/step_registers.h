#pragma once

#include "core/engines/projected/filling/step_lanes.h"
#include "core/simd/registers.h"

namespace noonmark {

/// Number of registers that hold the values of eight steps.
template <class Register>
inline constexpr std::size_t partsOfSteps = stepsTogether * sizeof(double) / bytesIn<Register>;
template <class Register>
inline constexpr std::size_t stepsAPart = stepsTogether / partsOfSteps<Register>;

/// Eight numbers, one per step. Results are the same to the last bit in registers of any width.
template <class Register>
struct EightDoubles {
    using Part = DoublesOf<Register>;
    static constexpr std::size_t parts = partsOfSteps<Register>;
    Part part[parts];

    EightDoubles() = default;
    // Adding 0 keeps the compiler from storing the numbers one at a time (GCC 12).
    [[gnu::always_inline]] inline explicit EightDoubles(double everywhere) {
        for (std::size_t i = 0; i < parts; ++i) part[i] = everywhere + Part{};
    }
    [[gnu::always_inline]] inline EightDoubles(const StepDoubles& from) {
        for (std::size_t i = 0; i < parts; ++i)
            part[i] = reinterpret_cast<const Part&>(from.values[i * stepsAPart<Register>]);
    }
    [[gnu::always_inline]] inline void store(StepDoubles& to) const {
        for (std::size_t i = 0; i < parts; ++i)
            reinterpret_cast<Part&>(to.values[i * stepsAPart<Register>]) = part[i];
    }

    [[gnu::always_inline]] friend inline EightDoubles operator+(const EightDoubles& a,
                                                                const EightDoubles& b) {
        EightDoubles made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = a.part[i] + b.part[i];
        return made;
    }
    [[gnu::always_inline]] friend inline EightDoubles operator-(const EightDoubles& a,
                                                                const EightDoubles& b) {
        EightDoubles made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = a.part[i] - b.part[i];
        return made;
    }
    [[gnu::always_inline]] friend inline EightDoubles operator*(const EightDoubles& a,
                                                                const EightDoubles& b) {
        EightDoubles made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = a.part[i] * b.part[i];
        return made;
    }
    [[gnu::always_inline]] friend inline EightDoubles operator+(double number, const EightDoubles& a) {
        EightDoubles made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = number + a.part[i];
        return made;
    }
    [[gnu::always_inline]] friend inline EightDoubles operator+(const EightDoubles& a, double number) {
        return number + a;
    }
    [[gnu::always_inline]] friend inline EightDoubles operator-(double number, const EightDoubles& a) {
        EightDoubles made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = number - a.part[i];
        return made;
    }
    [[gnu::always_inline]] friend inline EightDoubles operator-(const EightDoubles& a, double number) {
        EightDoubles made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = a.part[i] - number;
        return made;
    }
    [[gnu::always_inline]] friend inline EightDoubles operator*(const EightDoubles& a, double number) {
        EightDoubles made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = a.part[i] * number;
        return made;
    }
    [[gnu::always_inline]] friend inline EightDoubles operator-(const EightDoubles& a) {
        EightDoubles made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = -a.part[i];
        return made;
    }

    /// The minimum per step.
    [[gnu::always_inline]] friend inline EightDoubles least(const EightDoubles& a, const EightDoubles& b) {
        EightDoubles made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = b.part[i] < a.part[i] ? b.part[i] : a.part[i];
        return made;
    }
    /// The maximum per step.
    [[gnu::always_inline]] friend inline EightDoubles most(const EightDoubles& a, const EightDoubles& b) {
        EightDoubles made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = b.part[i] > a.part[i] ? b.part[i] : a.part[i];
        return made;
    }
    /// a where `number` is above 0, else b.
    [[gnu::always_inline]] friend inline EightDoubles whereAboveZero(const EightDoubles& number,
                                                                     const EightDoubles& a,
                                                                     const EightDoubles& b) {
        EightDoubles made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = number.part[i] > 0 ? a.part[i] : b.part[i];
        return made;
    }
    /// a where `number` is not below the limit, else b.
    [[gnu::always_inline]] friend inline EightDoubles whereAtLeast(double limit, const EightDoubles& number,
                                                                   const EightDoubles& a,
                                                                   const EightDoubles& b) {
        EightDoubles made;
        for (std::size_t i = 0; i < parts; ++i)
            made.part[i] = number.part[i] >= limit ? a.part[i] : b.part[i];
        return made;
    }
};

/// The minimum over all steps.
template <class Register>
[[gnu::always_inline]] inline double leastOf(const EightDoubles<Register>& numbers) {
    StepDoubles of;
    numbers.store(of);
    for (std::size_t apart = stepsTogether / 2; apart > 0; apart /= 2)
        for (std::size_t i = 0; i < apart; ++i) of[i] = of[i] < of[i + apart] ? of[i] : of[i + apart];
    return of[0];
}

/// One point per step.
template <class Register>
struct EightPoints {
    EightDoubles<Register> x, y;
    [[gnu::always_inline]] inline void store(StepPoints& to) const {
        x.store(to.x);
        y.store(to.y);
    }
    [[gnu::always_inline]] friend inline EightPoints operator+(glm::dvec2 point, const EightPoints& by) {
        return {point.x + by.x, point.y + by.y};
    }
    [[gnu::always_inline]] friend inline EightPoints operator-(const EightPoints& a, const EightPoints& b) {
        return {a.x - b.x, a.y - b.y};
    }
};

/// Whether a register has any bit set.
template <class Register>
[[gnu::always_inline]] inline bool anySetIn(const WordsOf<Register>& bits) {
    constexpr std::size_t bytes = bytesIn<Register>;
    if constexpr (bytes == 16) {
        return (bits[0] | bits[1]) != 0;
    } else {
        using Half = Registers<int(bytes / 2)>;
        WordsOf<Half> either;
        if constexpr (bytes == 64)
            either = __builtin_shufflevector(bits, bits, 0, 1, 2, 3) |
                     __builtin_shufflevector(bits, bits, 4, 5, 6, 7);
        else
            either = __builtin_shufflevector(bits, bits, 0, 1) | __builtin_shufflevector(bits, bits, 2, 3);
        return anySetIn<Half>(either);
    }
}

/// The same word of the rasters of eight steps.
template <class Register>
struct EightWords {
    using Part = WordsOf<Register>;
    static constexpr std::size_t parts = partsOfSteps<Register>;
    Part part[parts];

    EightWords() = default;
    [[gnu::always_inline]] inline EightWords(const StepWords& from) {
        for (std::size_t i = 0; i < parts; ++i)
            part[i] = reinterpret_cast<const Part&>(from.words[i * stepsAPart<Register>]);
    }
    [[gnu::always_inline]] inline void store(StepWords& to) const {
        for (std::size_t i = 0; i < parts; ++i)
            reinterpret_cast<Part&>(to.words[i * stepsAPart<Register>]) = part[i];
    }

    [[gnu::always_inline]] friend inline EightWords operator&(const EightWords& a, const EightWords& b) {
        EightWords made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = a.part[i] & b.part[i];
        return made;
    }
    [[gnu::always_inline]] friend inline EightWords operator|(const EightWords& a, const EightWords& b) {
        EightWords made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = a.part[i] | b.part[i];
        return made;
    }
    [[gnu::always_inline]] friend inline EightWords operator^(const EightWords& a, const EightWords& b) {
        EightWords made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = a.part[i] ^ b.part[i];
        return made;
    }
    [[gnu::always_inline]] friend inline EightWords operator~(const EightWords& a) {
        EightWords made;
        for (std::size_t i = 0; i < parts; ++i) made.part[i] = ~a.part[i];
        return made;
    }
};

/// Whether any bit is set.
template <class Register>
[[gnu::always_inline]] inline bool anySet(const EightWords<Register>& bits) {
    WordsOf<Register> either = bits.part[0];
    for (std::size_t i = 1; i < bits.parts; ++i) either |= bits.part[i];
    return anySetIn<Register>(either);
}

/// Whether all elements of `all` are above 0 and none of `none`.
template <class Register>
[[gnu::always_inline]] inline bool allAndNoneAboveZero(const EightDoubles<Register>& all,
                                                       const EightDoubles<Register>& none) {
    const WordsOf<Register> zero{}, ones = ~zero;
    WordsOf<Register> wrong{};
    for (std::size_t i = 0; i < all.parts; ++i) {
        wrong |= all.part[i] > 0 ? zero : ones;
        wrong |= none.part[i] > 0 ? ones : zero;
    }
    return !anySetIn<Register>(wrong);
}

}  // namespace noonmark
