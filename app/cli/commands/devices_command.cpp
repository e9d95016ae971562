#include <fmt/format.h>

#include <ostream>

#include "app/cli/base/command.h"
#include "core/engines/inverse/shadow_lines_opencl.h"

namespace noonmark::cli {

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
