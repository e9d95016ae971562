#pragma once

// The folder core/simd is the one place that knows instruction sets. A kernel is written once, in a source
// file that ends in _hwy.cpp, and compiled for each set with Google Highway (kernel.h); this file says which
// of them is in use. All sets give the same bits, so the choice changes times only.

#include <atomic>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace noonmark {

/// The sets that kernels are compiled for, in ascending order for each kind of processor. Processors by
/// Intel and AMD have the first three, processors by ARM the last.
enum class InstructionSet {
    sse4,    ///< SSE4.2: registers of 16 bytes; every processor since 2011
    avx2,    ///< registers of 32 bytes
    avx512,  ///< AVX-512 F, BW, CD, DQ and VL: registers of 64 bytes
    neon,    ///< registers of 16 bytes
};

/// "sse4", "avx2", "avx512", "neon": as in the environment variable NOONMARK_ISA.
std::string_view nameOf(InstructionSet set);

/// The sets of this processor, ascending; empty on a processor too old for any kernel.
std::vector<InstructionSet> availableInstructionSets();

/// The set in use: the last of availableInstructionSets() unless another one was chosen.
InstructionSet instructionSetInUse();

/// Chooses the set that kernels use from now on. Error (ErrorKind::unsupported) if this processor lacks it.
/// Not while an engine runs.
Result<void> useInstructionSet(InstructionSet set);

/// Chooses the set named by the environment variable NOONMARK_ISA, if there is one. Programs call it once, as
/// they start. Error (ErrorKind::input) for an unknown name; ErrorKind::unsupported if the processor lacks
/// that set, or has none that Noonmark was built for.
Result<void> useInstructionSetOfEnvironment();

namespace simd {
/// Index of the set in use in a kernel's table (kernel.h).
extern std::atomic<unsigned> tableIndex;
}  // namespace simd

}  // namespace noonmark
