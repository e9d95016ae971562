#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/study/study.h"

namespace noonmark {

/// Estimates the peak memory of a study, bytes, from the sizes of its parts; within some 30 % for the ray
/// engine. O(parts).
std::uint64_t estimateMemory(const City& city, const StudySettings& settings,
                             const EngineList& engines = coreEngines());

/// Memory that programs can still take without swapping, bytes: MemAvailable of Linux. Nothing if the system
/// does not provide it.
std::optional<std::uint64_t> measureAvailableMemory(const std::filesystem::path& meminfo = "/proc/meminfo");

/// Error, stating the memory needed, if the study exceeds settings.memoryLimit (0: 3/4 of what is available).
Result<void> checkMemory(const City& city, const StudySettings& settings,
                         const EngineList& engines = coreEngines());

}  // namespace noonmark
