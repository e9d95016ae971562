#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/simd/instruction_set.h"

namespace noonmark {

namespace {

constexpr const char* variable = "NOONMARK_ISA";

struct BuiltSet {
    InstructionSet set;
    std::string_view name;
    std::int64_t target;  // Highway's bit
};

/// In the order of the kernels' tables (kernel.h).
constexpr BuiltSet builtSets[] = {
#if HWY_ARCH_X86
    {InstructionSet::sse4, "sse4", HWY_SSE4},
    {InstructionSet::avx2, "avx2", HWY_AVX2},
    {InstructionSet::avx512, "avx512", HWY_AVX3},
#else
    {InstructionSet::neon, "neon", HWY_NEON},
#endif
};

// Every 64-bit processor by ARM has NEON.
bool hasSet([[maybe_unused]] const BuiltSet& built) {
#if HWY_ARCH_X86
    return (hwy::SupportedTargets() & built.target) != 0;
#else
    return true;
#endif
}

unsigned widestIndex() {
    unsigned widest = 0;
    for (unsigned i = 0; i < std::size(builtSets); ++i)
        if (hasSet(builtSets[i])) widest = i;
    return widest;
}

std::string listAvailable() {
    std::vector<std::string_view> names;
    for (const InstructionSet set : availableInstructionSets()) names.push_back(nameOf(set));
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

namespace simd {
std::atomic<unsigned> tableIndex = widestIndex();
}

std::string_view nameOf(InstructionSet set) {
    for (const BuiltSet& built : builtSets)
        if (built.set == set) return built.name;
    return "not built";
}

std::vector<InstructionSet> availableInstructionSets() {
    std::vector<InstructionSet> sets;
    for (const BuiltSet& built : builtSets)
        if (hasSet(built)) sets.push_back(built.set);
    return sets;
}

InstructionSet instructionSetInUse() { return builtSets[simd::tableIndex.load()].set; }

Result<void> useInstructionSet(InstructionSet set) {
    const auto* const found = std::ranges::find(builtSets, set, &BuiltSet::set);
    if (found == std::end(builtSets) || !hasSet(*found))
        return unsupported(fmt::format("This processor does not have the instruction set {}", nameOf(set)),
                           variable, fmt::format("Choose one of: {}", listAvailable()));
    simd::tableIndex = unsigned(found - builtSets);
    return {};
}

Result<void> useInstructionSetOfEnvironment() {
    if (availableInstructionSets().empty())
        return unsupported("Noonmark needs a processor with SSE4.2, as Intel and AMD make them since 2011");
    const char* const wanted = std::getenv(variable);
    if (wanted == nullptr || *wanted == '\0') return {};
    const auto* const found = std::ranges::find(builtSets, std::string_view(wanted), &BuiltSet::name);
    if (found == std::end(builtSets))
        return failure(fmt::format("There is no instruction set \"{}\"", wanted), variable,
                       fmt::format("Choose one of: {}", listAvailable()));
    return useInstructionSet(found->set);
}

}  // namespace noonmark
