#include "core/bench/machine.h"

#include <fmt/format.h>
#include <tbb/info.h>

#include <fstream>

namespace noonmark::bench {

namespace {

// Linux lists its processors in this file, as "model name : AMD EPYC 9B14".
std::string processorName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            if (const auto begin = line.find_first_not_of(" \t:", line.find(':')); begin != std::string::npos)
                return line.substr(begin);
    return "unknown processor";
}

}  // namespace

Machine detectMachine() { return {processorName(), tbb::info::default_concurrency()}; }

std::string describeMachine(const Machine& machine) {
    return fmt::format("{}, {} thread{}", machine.processor, machine.threads,
                       machine.threads == 1 ? "" : "s");
}

}  // namespace noonmark::bench
