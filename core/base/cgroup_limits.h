#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

namespace noonmark {

/// What schedulers and containers allow a process through control groups of Linux. Nothing: no limit.
struct CgroupLimits {
    std::optional<double> processors;  ///< time on so many processors
    std::optional<std::uint64_t> memoryBytes;
};

/// The strictest limits of this process' control groups and those above them, versions 2 and 1. `own`: lists
/// the groups of the process; `mounted`: where their files are. None where there are no control groups.
/// Backend: cgroup_limits_linux.cpp.
CgroupLimits readCgroupLimits(const std::filesystem::path& own = "/proc/self/cgroup",
                              const std::filesystem::path& mounted = "/sys/fs/cgroup");

/// Memory that programs can still take without swapping, bytes: MemAvailable of Linux. Nothing if the system
/// does not provide it.
std::optional<std::uint64_t> measureAvailableMemory(const std::filesystem::path& meminfo = "/proc/meminfo");

/// For work whose need of memory is known only afterwards.
class MemoryWatch {
public:
    explicit MemoryWatch(std::filesystem::path meminfo = "/proc/meminfo")
        : meminfo_(std::move(meminfo)), before_(measureAvailableMemory(meminfo_)) {}
    /// Whether less than a quarter of the memory that was free at first is left. Some 20 us.
    [[nodiscard]] bool isShort() const;

private:
    std::filesystem::path meminfo_;
    std::optional<std::uint64_t> before_;
};

/// Limits the threads of all parallel work during its lifetime. Backend: thread_limit_tbb.cpp.
class ThreadLimit {
public:
    explicit ThreadLimit(std::size_t threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

/// Threads for a limit of processors, at least 1; nothing without a limit. 1.5 processors are 2 threads.
std::optional<std::size_t> countThreads(const CgroupLimits& limits);

}  // namespace noonmark
