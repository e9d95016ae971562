#pragma once

#include <string>
#include <vector>

#include "core/engines/inverse/shadow_lines.h"

namespace noonmark {

/// One OpenCL device of this machine.
struct ComputeDevice {
    std::string name;      ///< "pthread-Intel(R) ..."
    std::string platform;  ///< "Portable Computing Language"
    bool gpu = false;
    std::uint64_t memoryBytes = 0;
    std::uint64_t largestBufferBytes = 0;
};

/// GPUs first, then the rest, in the order in which the user's choice counts them; empty where there is no
/// OpenCL.
std::vector<ComputeDevice> listComputeDevices();

/// The drawer on device number `device` of listComputeDevices(). Error where there is none, or its compiler
/// fails: the caller then draws on the processor and says so. Compiling takes about a second the first time.
Result<std::unique_ptr<ShadowLineDrawer>> makeOpenClDrawer(int device);

}  // namespace noonmark
