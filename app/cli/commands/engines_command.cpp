#include <fmt/format.h>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/input/all_engines.h"
#include "core/describe/field_values.h"
#include "core/lab/inverse/shadow_lines_opencl.h"
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

namespace {

int printDevices(const Console& console) {
    const std::vector<ComputeDevice> devices = listComputeDevices();
    if (devices.empty())
        console.out
            << "This machine has no OpenCL device: the processor does the drawing (--option device=-1)\n";
    for (std::size_t i = 0; i < devices.size(); ++i)
        console.out << fmt::format("--option device={}  {} ({}, {}{:.1f} GiB)\n", i, devices[i].name,
                                   devices[i].platform, devices[i].gpu ? "GPU, " : "",
                                   double(devices[i].memoryBytes) / double(1U << 30U));
    return exitOk;
}

}  // namespace

void addDevicesCommand(CLI::App& app, Run& run) {
    app.add_subcommand("devices", "List the OpenCL devices that the engine 'iam' can use")->callback([&run] {
        run = printDevices;
    });
}

}  // namespace noonmark::cli
