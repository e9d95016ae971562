#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "core/base/cgroup_limits.h"

namespace noonmark {

namespace {

namespace fs = std::filesystem;

std::string firstWords(const fs::path& file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
}

std::optional<double> numberIn(const std::string& text) {
    std::istringstream words(text);
    double number = 0;
    if (words >> number) return number;
    return std::nullopt;  // "max", or no such file
}

template <class Value>
void tighten(std::optional<Value>& limit, Value other) {
    limit = limit ? std::min(*limit, other) : other;
}

// "200000 100000": microseconds of processor time in each period of so many microseconds; "max 100000".
void takeProcessors(CgroupLimits& limits, const std::string& quota, const std::string& period) {
    const auto allowed = numberIn(quota), every = numberIn(period);
    if (allowed && every && *allowed > 0 && *every > 0) tighten(limits.processors, *allowed / *every);
}

// Version 1 states a number of nearly 2^63 where there is no limit.
void takeMemory(CgroupLimits& limits, const std::string& text) {
    constexpr double unlimited = 1e18;
    if (const auto bytes = numberIn(text); bytes && *bytes > 0 && *bytes < unlimited)
        tighten(limits.memoryBytes, std::uint64_t(*bytes));
}

void takeVersion2(CgroupLimits& limits, const fs::path& group) {
    std::istringstream processors(firstWords(group / "cpu.max"));
    std::string quota, period;
    processors >> quota >> period;
    takeProcessors(limits, quota, period);
    takeMemory(limits, firstWords(group / "memory.max"));
}

void takeVersion1(CgroupLimits& limits, const fs::path& group) {
    takeProcessors(limits, firstWords(group / "cpu.cfs_quota_us"), firstWords(group / "cpu.cfs_period_us"));
    takeMemory(limits, firstWords(group / "memory.limit_in_bytes"));
}

// A group is limited by those above it. In a container the path may be the host's and not exist here.
template <class Take>
void takeUpwards(CgroupLimits& limits, const fs::path& mounted, const std::string& group, const Take& take) {
    fs::path path = fs::path(group).relative_path();
    while (true) {
        take(limits, path.empty() ? mounted : mounted / path);
        if (path.empty()) return;
        path = path.parent_path();
    }
}

}  // namespace

// Lines: "0::/group" of version 2, "4:memory:/group" or "3:cpu,cpuacct:/group" of version 1.
CgroupLimits readCgroupLimits(const fs::path& own, const fs::path& mounted) {
    CgroupLimits limits;
    std::ifstream stream(own);
    for (std::string line; std::getline(stream, line);) {
        const auto first = line.find(':');
        const auto second = first == line.npos ? line.npos : line.find(':', first + 1);
        if (second == line.npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const std::string group = line.substr(second + 1);
        if (controllers.empty()) {
            takeUpwards(limits, mounted, group, takeVersion2);
            continue;
        }
        std::istringstream names(controllers);
        for (std::string name; std::getline(names, name, ',');)
            if (name == "cpu" || name == "memory") {
                std::error_code ignored;
                const fs::path joint = mounted / controllers;
                takeUpwards(limits, fs::exists(joint, ignored) ? joint : mounted / name, group, takeVersion1);
            }
    }
    return limits;
}

std::optional<std::uint64_t> measureAvailableMemory(const std::filesystem::path& meminfo) {
    std::ifstream file(meminfo);
    std::string key;
    std::uint64_t kibibytes = 0;
    std::string rest;
    while (file >> key >> kibibytes && std::getline(file, rest))
        if (key == "MemAvailable:") return kibibytes * 1024;
    return std::nullopt;
}

bool MemoryWatch::isShort() const {
    const auto now = before_ ? measureAvailableMemory(meminfo_) : std::nullopt;
    return now && *now < *before_ / 4;
}

std::optional<std::size_t> countThreads(const CgroupLimits& limits) {
    if (!limits.processors) return std::nullopt;
    return std::size_t(std::max(1.0, std::ceil(*limits.processors)));
}

}  // namespace noonmark
