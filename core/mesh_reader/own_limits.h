#pragma once

#include <cstdint>

namespace noonmark {

/// Limits that this process sets itself before it looks at a file from a stranger: address space, processor
/// time, no file written, no other process started, few files open; it ends when the program that started it
/// does, and when memory runs out it ends with exitOutOfMemory. Under the sanitizers, which reserve more than
/// there is, memory has no limit. Backend: own_limits_posix.cpp.
void limitThisProcess(std::uint64_t memoryBytes, std::uint64_t cpuSeconds);

/// Lowers the limit of memory once more is known of the file; never raises it.
void limitMemory(std::uint64_t memoryBytes);

}  // namespace noonmark
