#pragma once

#include <cstdint>

namespace noonmark {

/// Sets limits on this process before it reads an untrusted file: address space, processor time, no files
/// written, no other processes started, few open files. The process ends when its parent does, and exits with
/// exitOutOfMemory when memory runs out. Under the sanitizers, which reserve more address space than there is
/// memory, memory is not limited. Backend: own_limits_posix.cpp.
void limitThisProcess(std::uint64_t memoryBytes, std::uint64_t cpuSeconds);

/// Lowers the memory limit when more is known about the file; never raises it.
void limitMemory(std::uint64_t memoryBytes);

}  // namespace noonmark
