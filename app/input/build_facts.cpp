#include "app/input/build_facts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/version.h"
#include "core/simd/instruction_set.h"

namespace noonmark {

namespace {

std::string instructionSetsText() {
    std::vector<std::string_view> names;
    for (const InstructionSet set : availableInstructionSets()) names.push_back(nameOf(set));
    if (names.empty()) return "none that this processor has";
    return fmt::format("{} on this processor, in use: {}", fmt::join(names, ", "),
                       nameOf(instructionSetInUse()));
}

}  // namespace

std::string buildFactsText() {
    const BuildFacts& facts = buildFacts();
    return fmt::format(
        "Noonmark {} of {}\n"
        "Commit: {}\n"
        "Built: {} for {}, {}\n"
        "Libraries: {}\n"
        "Instruction sets: {}\n"
        "Licence: GPL-3.0-or-later",
        version(), facts.releaseDate, sourceCommit(), facts.buildType, facts.system, facts.compiler,
        facts.libraries, instructionSetsText());
}

}  // namespace noonmark
