#include "core/accumulate/shadow_lines_opencl.h"

#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_ENABLE_EXCEPTIONS
#include <fmt/format.h>

#include <CL/opencl.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/accumulate/lanes.h"
#include "generated/shadow_lines_cl.h"

namespace noonmark {

namespace {

std::vector<cl::Device> devicesOf(const cl::Platform& platform) {
    std::vector<cl::Device> devices;
    try {
        platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
    } catch (const cl::Error&) {
        devices.clear();  // a platform without devices says so by failing
    }
    return devices;
}

bool isGpu(const cl::Device& device) { return device.getInfo<CL_DEVICE_TYPE>() == CL_DEVICE_TYPE_GPU; }

// PoCL keeps compiled kernels in a folder and ends the process where it cannot make one.
void giveKernelCacheAHome() {
    if (std::getenv("POCL_CACHE_DIR") != nullptr) return;
    std::error_code error;
    const auto folder = std::filesystem::temp_directory_path(error) / "noonmark-kernels";
    if (!error) std::filesystem::create_directories(folder, error);
    if (!error) ::setenv("POCL_CACHE_DIR", folder.c_str(), 0);
}

std::vector<cl::Device> allDevices() {
    giveKernelCacheAHome();
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

ComputeDevice described(const cl::Device& device) {
    return {device.getInfo<CL_DEVICE_NAME>(),
            cl::Platform(device.getInfo<CL_DEVICE_PLATFORM>()).getInfo<CL_PLATFORM_NAME>(), isGpu(device),
            device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>(), device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>()};
}

template <class T>
cl::Buffer readOnly(const cl::Context& context, const std::vector<T>& values) {
    return {context, CL_MEM_READ_ONLY | CL_MEM_USE_HOST_PTR, values.size() * sizeof(T),
            const_cast<T*>(values.data())};
}

std::vector<cl_int2> stretchesOf(const Lanes& lanes) {
    std::vector<cl_int2> stretches;
    for (int lane = 0; lane < lanes.count(); ++lane) {
        const auto [first, end] = lanes.stretch(lane);
        stretches.push_back({{first, end}});
    }
    return stretches;
}

class OpenClDrawer final : public ShadowLineDrawer {
public:
    explicit OpenClDrawer(const cl::Device& device)
        : device_(device), context_(device), queue_(context_, device) {
        cl::Program program(context_, std::string(shadowLinesKernel));
        program.build(std::vector<cl::Device>{device}, "-cl-fp32-correctly-rounded-divide-sqrt");
        kernel_ = cl::Kernel(program, "draw_lanes");
    }

    Result<void> draw(const Grid& grid, const ShadowSources& sources, const ShadowMotion& motion,
                      std::span<ShadowMask> masks, std::stop_token stop) override {
        if (stop.stop_requested()) return cancelled();
        const std::size_t largest = device_.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
        const std::size_t needed = std::max(sources.heightM.size() * sizeof(float), masks.size_bytes());
        if (needed > largest)
            return failure(fmt::format("The map needs {} MB in one piece and the device allows {} MB",
                                       needed >> 20U, largest >> 20U),
                           device_.getInfo<CL_DEVICE_NAME>(), "Choose larger cells or a smaller region");
        try {
            run(grid, sources, motion, masks);
        } catch (const cl::Error& error) {
            return failure(fmt::format("OpenCL failed in {} (code {})", error.what(), error.err()),
                           device_.getInfo<CL_DEVICE_NAME>(), "Choose another device, or the processor");
        }
        return {};
    }

    [[nodiscard]] std::string describe() const override {
        return "lines drawn by OpenCL on " + device_.getInfo<CL_DEVICE_NAME>();
    }

private:
    void run(const Grid& grid, const ShadowSources& sources, const ShadowMotion& motion,
             std::span<ShadowMask> masks) {
        const Lanes lanes(grid, motion.shift);
        const StepTable table(motion.fraction);
        const std::vector<cl_int2> stretches = stretchesOf(lanes);
        const double cellsPerMetre = (lanes.alongX() ? motion.shift.x : motion.shift.y) / grid.cellM;
        cl::Buffer out(context_, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, masks.size_bytes(), masks.data());
        const cl::Buffer heights = readOnly(context_, sources.heightM);
        const cl::Buffer bend = readOnly(context_, lanes.bend());
        const cl::Buffer stretch = readOnly(context_, stretches);
        const cl::Buffer buildings = readOnly(context_, sources.building);
        const cl::Buffer before = readOnly(context_, table.before);
        cl_uint argument = 0;
        const auto set = [&](const auto& value) { kernel_.setArg(argument++, value); };
        set(heights), set(buildings), set(sources.levels), set(grid.columns), set(grid.rows);
        set(int(lanes.alongX())), set(lanes.firstLane()), set(bend), set(stretch);
        set(float(std::abs(cellsPerMetre))), set(sources.steepestM), set(int(cellsPerMetre < 0));
        set(before), set(out);
        queue_.enqueueNDRangeKernel(kernel_, cl::NullRange, cl::NDRange(std::size_t(lanes.count())));
        // Mapping brings the masks back where the device keeps its own copy, and costs nothing where it does
        // not.
        void* mapped = queue_.enqueueMapBuffer(out, CL_TRUE, CL_MAP_READ, 0, masks.size_bytes());
        queue_.enqueueUnmapMemObject(out, mapped);
        queue_.finish();
    }

    cl::Device device_;
    cl::Context context_;
    cl::CommandQueue queue_;
    cl::Kernel kernel_;
};

}  // namespace

std::vector<ComputeDevice> computeDevices() {
    std::vector<ComputeDevice> list;
    for (const cl::Device& device : allDevices()) list.push_back(described(device));
    return list;
}

Result<std::unique_ptr<ShadowLineDrawer>> makeOpenClDrawer(int device) {
    const std::vector<cl::Device> devices = allDevices();
    if (devices.empty())
        return failure("There is no OpenCL on this machine", "OpenCL",
                       "Lines are drawn on the processor instead; installing pocl-opencl-icd would give one");
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
