#include "core/bench/peak_memory.h"

#include <malloc.h>

#include <fstream>
#include <string>

namespace noonmark::bench {

namespace {

// A line of /proc/self/status, in kB: "VmHWM:	  123456 kB".
std::optional<std::uint64_t> statusBytes(const std::string& name) {
    std::ifstream file("/proc/self/status");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(name + ":")) return 1024 * std::stoull(line.substr(name.size() + 1));
    return {};
}

// Writing 5 resets the peak to the current memory (proc(5), clear_refs).
bool resetPeak() {
    std::ofstream file("/proc/self/clear_refs");
    file << "5" << std::flush;
    return bool(file);
}

}  // namespace

std::optional<std::uint64_t> measurePeakMemory(const std::function<void()>& work) {
    malloc_trim(0);
    if (!resetPeak()) return {};
    const auto before = statusBytes("VmRSS");
    work();
    const auto peak = statusBytes("VmHWM");
    if (!before || !peak) return {};
    return *peak > *before ? *peak - *before : 0;
}

}  // namespace noonmark::bench
