#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <thread>

#include "scenarios/project/project_file.h"
#include "scenarios/project/tables/database.h"
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

// Keeps unsaved work in the recovery file in an endless loop, and reports as saveForEver() does.
[[noreturn]] void keepForEver(const std::filesystem::path& file, int pipe) {
    const auto disk = ProjectFile::open(file);
    Autosave autosave(file);
    for (std::int64_t i = 0; disk; ++i) {
        if (::write(pipe, &i, sizeof i) != sizeof i) break;
        Project project = disk->project();
        project.view["turn"] = std::to_string(i);
        project.scenarios[1].edits.emplace_back(Rotate{"c", double(i)});
        if (!autosave.keep(project)) break;
    }
    ::_exit(1);
}

// Kills a process that does `work` for ever, `microseconds` after it reported `saves` saves. Returns the last
// save that it reported.
std::int64_t killedAfter(const std::filesystem::path& file, int saves, int microseconds,
                         void (*work)(const std::filesystem::path&, int) = saveForEver) {
    int ends[2];
    EXPECT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) work(file, ends[1]);
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

// A recovery file that was killed while it was written is moved aside and read, as the window does when it
// starts again; what the next run keeps in its place is whole, too.
TEST(ProjectKill, NoKilledRecoveryFileIsTornOrTearsTheNext) {
    const TemporaryFolder folder;
    const auto file = folder.path("town.noonmark.gpkg"), aside = folder.path("aside.noonmark.gpkg");
    ASSERT_TRUE(ProjectFile::create(file, sampleProject()));
    std::mt19937 random(6);
    std::uniform_int_distribution<int> moment(0, 25'000);
    for (int i = 0; i < 100; ++i) {
        const std::int64_t last = killedAfter(file, 1 + i % 3, moment(random), keepForEver);
        if (i % 2 == 1) continue;  // the next run meets what this one left
        moveProject(recoveryPath(file), aside);
        const auto recovered = ProjectFile::open(aside);
        ASSERT_TRUE(recovered) << recovered.error().text();
        ASSERT_GE(std::stoll(recovered->project().view.at("turn")), last - 1);
        ASSERT_FALSE(std::filesystem::exists(recoveryPath(file).string() + "-journal"));
    }
}

// The first save copies the tables that another program changed.
TEST(ProjectKill, NoKilledSaveLosesTablesThatAreTakenBack) {
    const TemporaryFolder folder;
    const auto changed = folder.path("changed.noonmark.gpkg"), file = folder.path("town.noonmark.gpkg");
    ASSERT_TRUE(ProjectFile::create(changed, sampleProject()));
    {
        Database database(changed, Database::Access::write);
        for (const char* table : {"buildings", "scenarios", "edits", "lots", "regions"})
            database.execute(std::string("ALTER TABLE ") + table + " ADD COLUMN more TEXT DEFAULT 'x'");
    }
    std::mt19937 random(7);
    std::uniform_int_distribution<int> moment(0, 25'000);
    for (int i = 0; i < 100; ++i) {
        for (const char* ending : {"", "-journal"}) std::filesystem::remove(file.string() + ending);
        std::filesystem::copy_file(changed, file);
        const std::int64_t last = killedAfter(file, 0, moment(random));
        const auto disk = ProjectFile::open(file);
        ASSERT_TRUE(disk) << disk.error().text();
        ASSERT_GE(disk->saves(), last);
        ASSERT_EQ(disk->project().city->buildings.size(), 5U);
        ASSERT_EQ(disk->project().scenarios.size(), 2U);
        ASSERT_EQ(disk->project().scenarios[0].edits.size(), 2U);
    }
}

}  // namespace
}  // namespace noonmark::tests
