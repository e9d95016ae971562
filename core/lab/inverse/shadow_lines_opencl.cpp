#include "core/lab/inverse/shadow_lines_opencl.h"

#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_ENABLE_EXCEPTIONS
#include <fmt/format.h>

#include <CL/opencl.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/base/process.h"
#include "core/base/working_files.h"
#include "generated/shadow_lines_cl.h"

namespace noonmark {

namespace {

std::vector<cl::Device> devicesOf(const cl::Platform& platform) {
    std::vector<cl::Device> devices;
    try {
        platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
    } catch (const cl::Error&) {
        devices.clear();  // a platform without devices reports this as an error
    }
    return devices;
}

bool isGpu(const cl::Device& device) { return device.getInfo<CL_DEVICE_TYPE>() == CL_DEVICE_TYPE_GPU; }

// PoCL caches compiled kernels in a folder, and terminates the process if it cannot create one.
void createKernelCacheFolder() {
    if (std::getenv("POCL_CACHE_DIR") != nullptr) return;
    std::error_code error;
    const auto folder =
        std::filesystem::temp_directory_path(error) / fmt::format("noonmark-kernels-{}", userId());
    // Kernels are programs: nobody else may put one there.
    if (!error && makeOwnFolder(folder)) ::setenv("POCL_CACHE_DIR", folder.c_str(), 0);
}

std::vector<cl::Device> allDevices() {
    createKernelCacheFolder();
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error&) {
        return {};
    }
    std::vector<cl::Device> devices;
    for (const cl::Platform& platform : platforms)
        for (const cl::Device& device : devicesOf(platform)) devices.push_back(device);
    std::stable_partition(devices.begin(), devices.end(), isGpu);
    return devices;
}

ComputeDevice describeDevice(const cl::Device& device) {
    return {device.getInfo<CL_DEVICE_NAME>(),
            cl::Platform(device.getInfo<CL_DEVICE_PLATFORM>()).getInfo<CL_PLATFORM_NAME>(), isGpu(device),
            device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>(), device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>()};
}

// Work items that share a lane. A region has about a thousand lanes, and a graphics card wants many more work
// items; on a processor each would find the runs again. One warp or wavefront a lane: its items stay
// together.
std::size_t itemsALane(const cl::Device& device) { return isGpu(device) ? 32 : 1; }

template <class T>
std::size_t bytesOf(const std::vector<T>& values) {
    return values.size() * sizeof(T);
}

template <class T>
cl::Buffer readOnly(const cl::Context& context, const std::vector<T>& values) {
    return {context, CL_MEM_READ_ONLY | CL_MEM_USE_HOST_PTR, bytesOf(values), const_cast<T*>(values.data())};
}

class OpenClDrawer final : public ShadowLineDrawer {
public:
    explicit OpenClDrawer(const cl::Device& device)
        : device_(device), items_(itemsALane(device)), context_(device), queue_(context_, device) {
        cl::Program program(context_, std::string(shadowLinesKernel));
        const std::string options = fmt::format("-cl-fp32-correctly-rounded-divide-sqrt -D ITEMS={}", items_);
        program.build(std::vector<cl::Device>{device}, options.c_str());
        kernel_ = cl::Kernel(program, "draw_lanes");
    }

    Result<void> draw(const LinePass& pass, const LaneSources& sources, LaneMasks& masks) override {
        const std::size_t largest = device_.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
        const std::size_t needed = std::max(bytesOf(sources.heightM), bytesOf(masks.masks));
        if (needed > largest)
            return failure(fmt::format("The map needs {} MB in one piece and the device allows {} MB",
                                       needed >> 20U, largest >> 20U),
                           device_.getInfo<CL_DEVICE_NAME>(), "Choose larger cells or a smaller region");
        try {
            run(pass, sources, masks);
        } catch (const cl::Error& error) {
            return failure(fmt::format("OpenCL failed in {} (code {})", error.what(), error.err()),
                           device_.getInfo<CL_DEVICE_NAME>(), "Choose another device, or the processor");
        }
        return {};
    }

    // Drawing blocks one at a time would leave most of a device idle.
    [[nodiscard]] int blocksAtOnce(int blocks) const override { return blocks; }

    [[nodiscard]] std::string describe() const override {
        return "lines drawn by OpenCL on " + device_.getInfo<CL_DEVICE_NAME>();
    }

private:
    void run(const LinePass& pass, const LaneSources& sources, LaneMasks& masks) {
        const std::size_t bytes = bytesOf(masks.masks);
        cl::Buffer out(context_, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, bytes, masks.masks.data());
        const cl::Buffer heights = readOnly(context_, sources.heightM);
        const cl::Buffer buildings = readOnly(context_, sources.building);
        const cl::Buffer before = readOnly(context_, pass.table.before);
        cl_uint argument = 0;
        const auto set = [&](const auto& value) { kernel_.setArg(argument++, value); };
        set(heights), set(buildings), set(sources.levels), set(sources.majors);
        set(pass.rule.cellsPerMetre), set(pass.rule.steepestM), set(int(pass.reversed)), set(before),
            set(out);
        const std::size_t lanes = masks.masks.size() / std::size_t(masks.majors);
        queue_.enqueueNDRangeKernel(kernel_, cl::NullRange, cl::NDRange(lanes * items_),
                                    items_ == 1 ? cl::NullRange : cl::NDRange(items_));
        // Mapping copies the masks back if the device has its own copy, and costs nothing otherwise.
        void* mapped = queue_.enqueueMapBuffer(out, CL_TRUE, CL_MAP_READ, 0, bytes);
        queue_.enqueueUnmapMemObject(out, mapped);
        queue_.finish();
    }

    cl::Device device_;
    std::size_t items_;
    cl::Context context_;
    cl::CommandQueue queue_;
    cl::Kernel kernel_;
};

}  // namespace

std::vector<ComputeDevice> listComputeDevices() {
    std::vector<ComputeDevice> list;
    for (const cl::Device& device : allDevices()) list.push_back(describeDevice(device));
    return list;
}

Result<std::unique_ptr<ShadowLineDrawer>> makeOpenClDrawer(int device) {
    const std::vector<cl::Device> devices = allDevices();
    if (devices.empty())
        return failure("There is no OpenCL on this machine", "OpenCL",
                       "Leave out the OpenCL device, or install pocl-opencl-icd");
    if (device < 0 || device >= int(devices.size()))
        return failure(fmt::format("There is no OpenCL device {}", device), "OpenCL",
                       fmt::format("Choose 0 to {}", devices.size() - 1));
    try {
        return std::make_unique<OpenClDrawer>(devices[std::size_t(device)]);
    } catch (const cl::Error& error) {
        return failure(
            fmt::format("The device cannot be used: {} failed (code {})", error.what(), error.err()),
            devices[std::size_t(device)].getInfo<CL_DEVICE_NAME>(),
            "Choose another device, or the processor");
    }
}

}  // namespace noonmark
