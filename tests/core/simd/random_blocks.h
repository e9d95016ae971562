#pragma once

#include <gtest/gtest.h>

#include <random>

#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/simd/instruction_set.h"

namespace noonmark {

/// Runs `check` with each instruction set of this machine in use, then restores the set.
inline void forEachInstructionSet(const auto& check) {
    const InstructionSet before = instructionSetInUse();
    for (const InstructionSet set : availableInstructionSets()) {
        SCOPED_TRACE(nameOf(set));
        ASSERT_TRUE(useInstructionSet(set));
        check();
    }
    ASSERT_TRUE(useInstructionSet(before));
}

using Random = std::mt19937;

inline float anyFrom(Random& random, float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
}

/// Cells of a block; one row is empty and one is full.
inline ReceiverBlocks::Masks anyMasks(Random& random) {
    ReceiverBlocks::Masks masks;
    for (auto& mask : masks) mask = std::uint16_t(random());
    masks[3] = 0;
    masks[4] = 0xFFFF;
    return masks;
}

}  // namespace noonmark
