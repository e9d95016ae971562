#pragma once

#include <string>
#include <vector>

#include "core/lab/inverse/shadow_lines.h"

namespace noonmark {

/// An OpenCL device of this machine.
struct ComputeDevice {
    std::string name;      ///< "pthread-Intel(R) ..."
    std::string platform;  ///< "Portable Computing Language"
    bool gpu = false;
    std::uint64_t memoryBytes = 0;
    std::uint64_t largestBufferBytes = 0;
};

/// GPUs first, then the others, in the order in which the device option counts them; empty without OpenCL.
std::vector<ComputeDevice> listComputeDevices();

/// A drawer on device number `device` of listComputeDevices(). Error if there is no such device or its
/// compiler fails. Compiling takes about a second
/// the first time.
Result<std::unique_ptr<ShadowLineDrawer>> makeOpenClDrawer(int device);

}  // namespace noonmark
