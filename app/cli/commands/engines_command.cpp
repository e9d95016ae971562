#include <fmt/format.h>

#include <ostream>

#include "app/cli/base/command.h"
#include "app/input/all_engines.h"
#include "core/describe/field_checks.h"
#include "core/describe/value_text.h"
#include "core/simd/instruction_set.h"

namespace noonmark::cli {

namespace {

std::string optionLine(const Field& option) {
    return fmt::format("    --option {}={}  {}: {}\n", option.key, formatText(option.standard),
                       rangeText(option), option.help);
}

std::string describe(const EngineCapabilities& able) {
    std::string words = able.terrain ? "Takes terrain" : "Flat ground only";
    if (able.roofs) words += ", roofs";
    if (able.sets) words += ", months and weights in one run";
    if (able.attribution) words += ", contributions of buildings";
    if (able.stepMasks) words += ", timelines of places";
    if (able.cache) words += ", live edits";
    return words;
}

std::string listInstructionSets() {
    std::string names;
    for (const InstructionSet set : availableInstructionSets())
        names += fmt::format("{}{}", names.empty() ? "" : ", ", nameOf(set));
    return names;
}

int printEngines(const Console& console) {
    for (const auto& [info, make] : allEngines()) {
        console.out << fmt::format("{:<10} {}\n    {}\n    {}\n", info.key, info.name, info.about,
                                   describe(info.capabilities));
        for (const Field& option : info.options) console.out << optionLine(option);
    }
    console.out << fmt::format("Instruction sets of this processor: {}; in use: {}\n", listInstructionSets(),
                               nameOf(instructionSetInUse()));
    return exitOk;
}

}  // namespace

void addEnginesCommand(CLI::App& app, Run& run) {
    app.add_subcommand("engines", "List the engines and their options")->callback([&run] {
        run = printEngines;
    });
}

}  // namespace noonmark::cli
