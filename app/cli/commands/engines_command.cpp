#include <fmt/format.h>

#include <ostream>

#include "app/cli/command.h"
#include "app/input/all_engines.h"

namespace noonmark::cli {

namespace {

std::string optionLine(const EngineOption& option) {
    const std::string unit = option.unit.empty() ? "" : fmt::format(" {}", option.unit);
    return fmt::format("    --option {}={:g}  {:g} to {:g}{}: {}\n", option.key, option.usual, option.lowest,
                       option.highest, unit, option.about);
}

int printEngines(const Console& console) {
    for (const auto& [info, make] : allEngines()) {
        console.out << fmt::format("{:<10} {}\n    {}\n", info.key, info.name, info.about);
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
