#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <random>
#include <thread>

#include "tests/cli/command_output.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::cli::tests {
namespace {

// Interrupts hours of work. Runs in its own process, where no thread of another test can receive the signal.
[[noreturn]] void interruptedStudy(const std::string& out) {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    const std::jthread user([] {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        ::kill(::getpid(), SIGINT);
    });
    const CommandOutput output = noonmarkCli(
        {"study", "sample:grid", "--start", "2026-01-01", "--days", "365", "--zone", "America/New_York",
         "--region", "-73.995,40.745,-73.975,40.765", "--cell", "0.5", "--out", out});
    std::cerr << output.err;
    std::_Exit(output.code);
}

TEST(CancelDeathTest, CtrlCEndsAStudyWithCode130) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const noonmark::tests::TemporaryFolder folder;
    EXPECT_EXIT(interruptedStudy(folder.path("out").string()), testing::ExitedWithCode(exitCancelled),
                "noonmark-cli: Cancelled");
    EXPECT_FALSE(std::filesystem::exists(folder.path("out")));
}

std::vector<std::string> cityStudy(const std::filesystem::path& out) {
    return {"city-study", "sample:central-park-south",
            "--start",    "2026-03-21",
            "--step",     "30",
            "--zone",     "America/New_York",
            "--region",   "city",
            "--cell",     "2",
            "--tile",     "64",
            "--engine",   "ray",
            "--out",      out.string(),
            "--json"};
}

std::ptrdiff_t linesIn(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return std::count(std::istreambuf_iterator<char>(stream), {}, '\n');
}

// SIGKILL leaves no time to clean up.
[[noreturn]] void killedCityStudy(const std::filesystem::path& out, std::ptrdiff_t tiles) {
    const std::jthread killer([&] {
        while (linesIn(out / "shadow.tif.tiles" / "journal.jsonl") <= tiles)
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        ::kill(::getpid(), SIGKILL);
    });
    (void)noonmarkCli(cityStudy(out));
    std::_Exit(0);
}

TEST(KillDeathTest, AKilledCityStudyGoesOnAndSaysTheSame) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    // The process that will be killed runs this test again from the start and uses the folder of its parent.
    constexpr const char* handedOver = "NOONMARK_TEST_KILLED_STUDY";
    std::optional<noonmark::tests::TemporaryFolder> folder;
    if (std::getenv(handedOver) == nullptr) ::setenv(handedOver, folder.emplace().path("out").c_str(), 1);
    const std::filesystem::path out = std::getenv(handedOver);
    std::mt19937 random(2);
    const auto tiles = std::ptrdiff_t(1 + random() % 20);
    EXPECT_EXIT(killedCityStudy(out, tiles), testing::KilledBySignal(SIGKILL), "");
    ::unsetenv(handedOver);
    EXPECT_FALSE(std::filesystem::exists(out / "shadow.tif"));
    const CommandOutput resumed = noonmarkCli(cityStudy(out));
    ASSERT_EQ(resumed.code, exitOk) << resumed.err;
    EXPECT_GE(resumed.json()["tiles"]["resumed"].get<std::ptrdiff_t>(), tiles);
    EXPECT_FALSE(std::filesystem::exists(out / "shadow.tif.tiles"));
    const auto unbroken = noonmarkCli(cityStudy(folder->path("again"))).json();
    for (const char* key : {"receivers", "shadow_area_m2", "mean_gross_min", "max_continuous_min", "rays"})
        EXPECT_EQ(resumed.json()[key], unbroken[key]) << key;
    EXPECT_EQ(unbroken["tiles"]["resumed"], 0);
}

}  // namespace
}  // namespace noonmark::cli::tests
