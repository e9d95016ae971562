#include "core/base/cgroup_limits.h"

#include <gtest/gtest.h>

#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

class ReadCgroupLimits : public testing::Test {
protected:
    void put(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories(folder.path(name).parent_path());
        (void)folder.file(name, text);
    }
    [[nodiscard]] CgroupLimits limits(const std::string& own) const {
        return readCgroupLimits(folder.file("cgroup", own), folder.path("mounted"));
    }
    tests::TemporaryFolder folder;
};

TEST_F(ReadCgroupLimits, OfVersion2AreTheStrictestOfAGroupAndThoseAboveIt) {
    put("mounted/slurm/cpu.max", "400000 100000\n");
    put("mounted/slurm/memory.max", "2000000000\n");
    put("mounted/slurm/job/cpu.max", "max 100000\n");
    put("mounted/slurm/job/memory.max", "3000000000\n");
    const CgroupLimits found = limits("0::/slurm/job\n");
    EXPECT_EQ(found.processors, 4.0);
    EXPECT_EQ(found.memoryBytes, 2000000000U);
    EXPECT_EQ(countThreads(found), 4U);
}

TEST_F(ReadCgroupLimits, InAContainerAreThoseOfTheMountedGroup) {
    put("mounted/cpu.max", "150000 100000\n");
    put("mounted/memory.max", "max\n");
    const CgroupLimits found = limits("0::/kubepods/pod1/of-the-host\n");
    EXPECT_EQ(found.processors, 1.5);
    EXPECT_FALSE(found.memoryBytes);
    EXPECT_EQ(countThreads(found), 2U);
}

TEST_F(ReadCgroupLimits, OfVersion1ComeFromTheFoldersOfTheirControllers) {
    put("mounted/cpu,cpuacct/job/cpu.cfs_quota_us", "50000\n");
    put("mounted/cpu,cpuacct/job/cpu.cfs_period_us", "100000\n");
    put("mounted/cpu,cpuacct/cpu.cfs_quota_us", "-1\n");
    put("mounted/cpu,cpuacct/cpu.cfs_period_us", "100000\n");
    put("mounted/memory/job/memory.limit_in_bytes", "1048576\n");
    put("mounted/memory/memory.limit_in_bytes", "9223372036854771712\n");
    const CgroupLimits found = limits("4:memory:/job\n3:cpu,cpuacct:/job\n1:name=systemd:/\n");
    EXPECT_EQ(found.processors, 0.5);
    EXPECT_EQ(found.memoryBytes, 1048576U);
    EXPECT_EQ(countThreads(found), 1U);
}

TEST_F(ReadCgroupLimits, AreNoneWhereFilesAreMissingOrHoldNoNumbers) {
    put("mounted/a/cpu.max", "much\n");
    put("mounted/a/memory.max", "");
    for (const char* own : {"", "0::/a\n", "rubbish\n", "::\n", "4:memory\n"}) {
        const CgroupLimits found = limits(own);
        EXPECT_FALSE(found.processors) << own;
        EXPECT_FALSE(found.memoryBytes) << own;
    }
    EXPECT_FALSE(countThreads({}));
}

TEST(AvailableMemory, IsReadFromTheSystem) {
    const tests::TemporaryFolder folder;
    const auto file = folder.file(
        "meminfo", "MemTotal:       24000000 kB\nMemFree: 7 kB\nMemAvailable:    2048 kB\nBuffers: 1 kB\n");
    EXPECT_EQ(measureAvailableMemory(file), 2048U * 1024U);
    EXPECT_EQ(measureAvailableMemory(folder.file("old", "MemTotal: 5 kB\n")), std::nullopt);
    EXPECT_EQ(measureAvailableMemory(folder.path("missing")), std::nullopt);
}

TEST(MemoryWatch, IsShortWhereAQuarterIsLeft) {
    const tests::TemporaryFolder folder;
    const auto file = folder.file("meminfo", "MemAvailable: 4000 kB\n");
    const MemoryWatch watch(file);
    EXPECT_FALSE(watch.isShort());
    (void)folder.file("meminfo", "MemAvailable: 1001 kB\n");
    EXPECT_FALSE(watch.isShort());
    (void)folder.file("meminfo", "MemAvailable: 999 kB\n");
    EXPECT_TRUE(watch.isShort());
    EXPECT_FALSE(MemoryWatch(folder.path("missing")).isShort()) << "unknown";
}

}  // namespace
}  // namespace noonmark
