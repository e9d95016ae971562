#include <fmt/format.h>

#include <ostream>

#include "app/cli/command.h"
#include "app/input/all_engines.h"

namespace noonmark::cli {

namespace {

std::string optionLine(const EngineOption& option) {
    const std::string unit = option.unit.empty() ? "" : fmt::format(" {}", option.unit);
    const std::string range = option.kind == OptionKind::yesNo
                                  ? "yes or no"
                                  : fmt::format("{:g} to {:g}{}", option.lowest, option.highest, unit);
    return fmt::format("    --option {}={}  {}: {}\n", option.key, formatOptionValue(option, option.usual),
                       range, option.about);
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

int printEngines(const Console& console) {
    for (const auto& [info, make] : allEngines()) {
        console.out << fmt::format("{:<10} {}\n    {}\n    {}\n", info.key, info.name, info.about,
                                   describe(info.capabilities));
        for (const EngineOption& option : info.options) console.out << optionLine(option);
    }
    return exitOk;
}

}  // namespace

void addEnginesCommand(CLI::App& app, Run& run) {
    app.add_subcommand("engines", "List the engines and their options")->callback([&run] {
        run = printEngines;
    });
}

}  // namespace noonmark::cli
