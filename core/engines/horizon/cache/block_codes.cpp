#include "core/engines/horizon/cache/block_codes.h"

#include <algorithm>
#include <cstring>

#include "core/simd/simd_lanes.h"

namespace noonmark {

namespace {

constexpr int side = ReceiverBlocks::side;

/// A row of a block.
using Shorts16 = std::int16_t __attribute__((vector_size(32), may_alias));

// Vectors are passed by reference: functions compiled for several instruction sets cannot pass them by value.
#define NOONMARK_INTO_EVERY [[gnu::always_inline]] inline

NOONMARK_INTO_EVERY void load(const HorizonCode* codes, Shorts16& line) {
    std::memcpy(&line, codes, sizeof line);
}

NOONMARK_INTO_EVERY void store(const Shorts16& line, HorizonCode* codes) {
    std::memcpy(codes, &line, sizeof line);
}

constexpr Shorts16 bits{1,   2,   4,    8,    16,   32,   64,    128,
                        256, 512, 1024, 2048, 4096, 8192, 16384, std::int16_t(-32768)};

// Lanes are 0 or -1. Each lane is reduced to a bit of its own, and the quarters are combined.
NOONMARK_INTO_EVERY std::uint16_t maskOf(const Shorts16& lanes) {
    const Shorts16 set = lanes & bits;
    std::uint64_t words[4];
    std::memcpy(words, &set, sizeof words);
    std::uint64_t all = words[0] | words[1] | words[2] | words[3];
    all |= all >> 32U;
    return std::uint16_t(all | all >> 16U);
}

template <class Ask>
NOONMARK_INTO_EVERY void findLanes(const HorizonCode* a, const HorizonCode* b,
                                   const ReceiverBlocks::Masks& masks, ReceiverBlocks::Masks& found,
                                   const Ask& ask) {
    for (int line = 0; line < side; ++line) {
        Shorts16 x, y, lanes;
        load(a + line * side, x);
        load(b + line * side, y);
        ask(x, y, lanes);
        found[std::size_t(line)] = std::uint16_t(maskOf(lanes) & masks[std::size_t(line)]);
    }
}

// Interleaves rows i and i + 8 into rows 2i and 2i + 1; applied four times this transposes the block.
NOONMARK_INTO_EVERY void weave(const Shorts16* from, Shorts16* to) {
    for (int i = 0; i < side / 2; ++i) {
        const Shorts16 &a = from[i], &b = from[i + side / 2];
        to[2 * i] = __builtin_shufflevector(a, b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
        to[2 * i + 1] =
            __builtin_shufflevector(a, b, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
    }
}

}  // namespace

NOONMARK_EVERY_ISA
HorizonCode findLowest(const HorizonCode* codes, const ReceiverBlocks::Masks& masks) {
    const Shorts16 highest = Shorts16{} + std::int16_t(steepnessLevels / 2);
    Shorts16 low = highest;
    for (int line = 0; line < side; ++line) {
        Shorts16 of;
        load(codes + line * side, of);
        const Shorts16 asked = bits & std::int16_t(masks[std::size_t(line)]);
        of = asked != 0 ? of : highest;
        low = of < low ? of : low;
    }
    HorizonCode lowest = low[0];
    for (int i = 1; i < side; ++i) lowest = std::min(lowest, HorizonCode(low[i]));
    return lowest;
}

NOONMARK_EVERY_ISA
void setOthers(const ReceiverBlocks::Masks& masks, HorizonCode code, BlockCodes& codes) {
    const Shorts16 others = Shorts16{} + code;
    for (int line = 0; line < side; ++line) {
        Shorts16 of;
        load(codes.values + line * side, of);
        const Shorts16 asked = bits & std::int16_t(masks[std::size_t(line)]);
        store(asked != 0 ? of : others, codes.values + line * side);
    }
}

NOONMARK_EVERY_ISA
void transpose(const HorizonCode* from, BlockCodes& to) {
    Shorts16 a[side], b[side];
    for (int line = 0; line < side; ++line) load(from + line * side, a[line]);
    weave(a, b);
    weave(b, a);
    weave(a, b);
    weave(b, a);
    for (int line = 0; line < side; ++line) store(a[line], to.values + line * side);
}

NOONMARK_EVERY_ISA
void raise(const HorizonCode* others, BlockCodes& codes) {
    for (int line = 0; line < side; ++line) {
        Shorts16 a, b;
        load(others + line * side, a);
        load(codes.values + line * side, b);
        store(a > b ? a : b, codes.values + line * side);
    }
}

NOONMARK_EVERY_ISA
void findDifferences(const HorizonCode* a, const HorizonCode* b, const ReceiverBlocks::Masks& masks,
                     ReceiverBlocks::Masks& differ) {
    const auto ask =
        [](const Shorts16& x, const Shorts16& y, Shorts16& lanes) __attribute__((always_inline)) {
        lanes = x != y;
    };
    findLanes(a, b, masks, differ, ask);
}

NOONMARK_EVERY_ISA
void findEqual(const HorizonCode* a, const HorizonCode* b, const ReceiverBlocks::Masks& masks,
               ReceiverBlocks::Masks& equal) {
    const auto ask =
        [](const Shorts16& x, const Shorts16& y, Shorts16& lanes) __attribute__((always_inline)) {
        lanes = (x == y) & (x != noHorizon);
    };
    findLanes(a, b, masks, equal, ask);
}

#undef NOONMARK_INTO_EVERY

}  // namespace noonmark
