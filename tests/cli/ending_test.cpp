#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <thread>

#include "app/cli/base/interrupt.h"
#include "tests/cli/command_output.h"
#include "tests/core/io/temporary_folder.h"

// How the program ends by what its surroundings do: signals while it writes, limits, a desktop that is not
// there.
namespace noonmark::cli::tests {
namespace {

using testing::ExitedWithCode;
namespace fs = std::filesystem;

std::vector<std::string> smallStudy(const fs::path& out) {
    return {"study",   "sample:grid", "--start",  "2026-03-21", "--from", "12:00",
            "--hours", "1",           "--step",   "20",         "--zone", "America/New_York",
            "--cell",  "4",           "--region", "city",       "--out",  out.string()};
}

std::vector<std::string> facades(const fs::path& out) {
    return plus(smallStudy(out),
                {"--receivers", "facades", "--facades-of", "all", "--storey", "4", "--bay", "4"});
}

bool holdsHidden(const fs::path& folder) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().filename().string().starts_with('.')) return true;
    return false;
}

// Two signals as soon as a file is being written: the first may reach work that listens, which then ends with
// the same code. The command is repeated if it was too quick to be caught.
[[noreturn]] void endedWhileWriting(const std::vector<std::string>& words, const fs::path& out) {
    const SignalWatch watch;
    const std::jthread user([&] {
        while (!holdsHidden(out)) std::this_thread::sleep_for(std::chrono::microseconds(100));
        for (int i = 0; i < 2; ++i) {
            ::kill(::getpid(), SIGTERM);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        std::this_thread::sleep_for(std::chrono::seconds(60));
    });
    int code = exitOk;
    while (code == exitOk) code = noonmarkCli(words).code;
    std::_Exit(code);
}

/// A folder for a test and the process that it starts, which runs the test again from its beginning.
class SharedFolder {
public:
    SharedFolder() {
        GTEST_FLAG_SET(death_test_style, "threadsafe");
        if (std::getenv(handedOver) == nullptr) ::setenv(handedOver, own_.emplace().path("").c_str(), 1);
        path_ = std::getenv(handedOver);
    }
    SharedFolder(const SharedFolder&) = delete;
    SharedFolder& operator=(const SharedFolder&) = delete;
    ~SharedFolder() { ::unsetenv(handedOver); }
    [[nodiscard]] fs::path path(const char* name) const { return path_ / name; }

private:
    static constexpr const char* handedOver = "NOONMARK_TEST_ENDED";
    std::optional<noonmark::tests::TemporaryFolder> own_;
    fs::path path_;
};

void expectNothingLeft(std::vector<std::string> (*words)(const fs::path&)) {
    const SharedFolder folder;
    const fs::path out = folder.path("out");
    EXPECT_EXIT(endedWhileWriting(words(out), out), ExitedWithCode(exitCancelled), "");
    EXPECT_TRUE(fs::exists(out));
    EXPECT_FALSE(holdsHidden(out));
}

TEST(EndingDeathTest, ASignalWhileFilesAreWrittenLeavesNoHiddenOnes) { expectNothingLeft(smallStudy); }
TEST(EndingDeathTest, ASignalWhileFacadesAreWrittenLeavesNoHiddenOnes) { expectNothingLeft(facades); }

[[noreturn]] void writtenWithin(rlim_t bytes, const std::vector<std::string>& words) {
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const CommandOutput output = noonmarkCli(words);
    std::cerr << output.err;
    std::_Exit(output.code);
}

TEST(EndingDeathTest, ALimitOfFileSizesIsAnError) {
    const SharedFolder folder;
    EXPECT_EXIT(writtenWithin(8192, smallStudy(folder.path("out"))), ExitedWithCode(exitFailed),
                "noonmark-cli: ");
    EXPECT_FALSE(holdsHidden(folder.path("out")));
    EXPECT_EXIT(writtenWithin(8192, {"sample", "grid", "--out", folder.path("a.gpkg").string()}),
                ExitedWithCode(exitFailed), "noonmark-cli: ");
    EXPECT_EXIT(
        writtenWithin(8192, {"project", "new", folder.path("a.noonmark.gpkg").string(), "sample:grid"}),
        ExitedWithCode(exitFailed), "noonmark-cli: ");
}

[[noreturn]] void drawnOnADesktop(const std::vector<std::string>& words) {
    ::setenv("QT_QPA_PLATFORM", "wayland", 1);
    ::setenv("QT_QPA_PLATFORMTHEME", "gtk3", 1);
    ::setenv("QT_SCALE_FACTOR", "2", 1);
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    const CommandOutput output = noonmarkCli(words);
    std::cerr << output.err;
    std::_Exit(output.code);
}

TEST(EndingDeathTest, NoDesktopIsNeededWhateverTheEnvironmentNames) {
    const SharedFolder folder;
    EXPECT_EXIT(drawnOnADesktop(smallStudy(folder.path("out"))), ExitedWithCode(exitOk), "");
}

}  // namespace
}  // namespace noonmark::cli::tests
