#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <thread>

#include "scenarios/project/project_file.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/scenarios/sample_project.h"

namespace noonmark::tests {
namespace {

// Saves in an endless loop; reports its number at the start and after every completed save.
[[noreturn]] void saveForEver(const std::filesystem::path& file, int pipe) {
    auto disk = ProjectFile::open(file);
    for (int i = 0; disk; ++i) {
        const std::int64_t ended = disk->saves();
        if (::write(pipe, &ended, sizeof ended) != sizeof ended) break;
        Project project = disk->project();
        project.view["turn"] = std::to_string(disk->saves() + 1);
        project.scenarios[1].edits.emplace_back(Rotate{"c", double(i)});
        if (i % 5 == 4) project.scenarios[1].edits.resize(5);
        project.lots[0].outline = box(200, 0, 240, 30 + float(i % 10));
        if (!disk->save(project)) break;
    }
    ::_exit(1);
}

// Kills a saving process `microseconds` after it reported `saves` saves. Returns the last save that it
// reported.
std::int64_t killedAfter(const std::filesystem::path& file, int saves, int microseconds) {
    int ends[2];
    EXPECT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) saveForEver(file, ends[1]);
    ::close(ends[1]);
    std::int64_t last = 0;
    for (int told = 0; told <= saves; ++told) EXPECT_EQ(::read(ends[0], &last, sizeof last), sizeof last);
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "it gave up saving";
    for (std::int64_t ended = 0; ::read(ends[0], &ended, sizeof ended) == sizeof ended;) last = ended;
    ::close(ends[0]);
    return last;
}

TEST(ProjectKill, NoKilledSaveLosesWhatWasSaved) {
    const TemporaryFolder folder;
    const auto file = folder.path("town.noonmark.gpkg");
    ASSERT_TRUE(ProjectFile::create(file, sampleProject()));
    std::mt19937 random(5);
    std::uniform_int_distribution<int> moment(0, 25'000);
    std::int64_t last = 1;
    for (int i = 0; i < 200; ++i) {
        last = std::max(last, killedAfter(file, i % 2, moment(random)));
        const auto disk = ProjectFile::open(file);
        ASSERT_TRUE(disk) << disk.error().text();
        ASSERT_GE(disk->saves(), last);
        if (disk->saves() > 1) {
            ASSERT_EQ(disk->project().view.at("turn"), std::to_string(disk->saves()));
        }
        ASSERT_EQ(disk->project().city->buildings.size(), 5U);
        last = disk->saves();
    }
    EXPECT_GT(last, 100);
}

}  // namespace
}  // namespace noonmark::tests
