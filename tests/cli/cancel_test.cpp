#include <gtest/gtest.h>

#include <unistd.h>
#include <chrono>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "tests/cli/spoken.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::cli::tests {
namespace {

// Hours of work, interrupted. In a process of its own, where no thread of another test can take the signal.
[[noreturn]] void interruptedStudy(const std::string& out) {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    const std::jthread user([] {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        ::kill(::getpid(), SIGINT);
    });
    const Spoken spoken = noonmarkCli({"study", "sample:grid", "--start", "2026-01-01", "--days", "365",
                                       "--zone", "America/New_York", "--region",
                                       "-73.995,40.745,-73.975,40.765", "--cell", "0.5", "--out", out});
    std::cerr << spoken.err;
    std::_Exit(spoken.code);
}

TEST(CancelDeathTest, ctrlCEndsAStudyWithCode130) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const noonmark::tests::TemporaryFolder folder;
    EXPECT_EXIT(interruptedStudy(folder.path("out").string()), testing::ExitedWithCode(exitCancelled),
                "noonmark-cli: Cancelled");
    EXPECT_FALSE(std::filesystem::exists(folder.path("out")));
}

}  // namespace
}  // namespace noonmark::cli::tests
