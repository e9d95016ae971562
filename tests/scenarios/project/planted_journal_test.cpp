// Journals that a stranger left beside a project file, which SQLite would apply to it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "scenarios/project/tables/database.h"
#include "tests/core/io/planted_journal.h"
#include "tests/scenarios/project/hostile_project.h"

namespace noonmark::tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct PlantedJournal : HostileProject {
    void SetUp() override {
        HostileProject::SetUp();
        victim = folder_.file("thesis.txt", "years of work");
    }
    void expectUnharmed() const { EXPECT_EQ(allBytes(victim), "years of work"); }
    [[nodiscard]] fs::path beside(const char* ending) const { return file().string() + ending; }

    fs::path victim;
};

TEST_F(PlantedJournal, ThatNamesAFileDeletesNothingAndIsRefused) {
    auto opened = ProjectFile::open(file());
    ASSERT_TRUE(opened);
    const std::string before = allBytes(file());
    plantJournal(file(), victim);
    EXPECT_THAT(error(), HasSubstr("names another file"));
    const auto saved = opened->save(opened->project());
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().text(), HasSubstr("names another file"));
    EXPECT_FALSE(opened->isUnchanged());
    EXPECT_TRUE(fs::exists(beside("-journal")));
    EXPECT_EQ(allBytes(file()), before);
    expectUnharmed();
}

TEST_F(PlantedJournal, ThatNamesTheJournalOfAnotherProjectLeavesThatAlone) {
    const fs::path other = folder_.path("other.noonmark.gpkg");
    fs::copy_file(file(), other);
    plantJournal(other);
    plantJournal(file(), other.string() + "-journal");
    EXPECT_THAT(error(), HasSubstr("names another file"));
    EXPECT_TRUE(fs::exists(other.string() + "-journal"));
}

// What a program that swaps the journal after the check would meet.
TEST_F(PlantedJournal, ReachesNoOtherFileThroughAConnection) {
    plantJournal(file(), victim);
    for (const auto access : {Database::Access::write, Database::Access::read})
        EXPECT_THROW((void)Database(file(), access).value("SELECT count(*) FROM noonmark"), DatabaseError);
    expectUnharmed();
}

TEST_F(PlantedJournal, BesideARecoveryFileDeletesNothing) {
    const fs::path recovery = recoveryPath(file());
    fs::copy_file(file(), recovery);
    plantJournal(recovery, victim);
    const auto recovered = ProjectFile::open(recovery);
    ASSERT_FALSE(recovered);
    EXPECT_THAT(recovered.error().text(), HasSubstr("names another file"));
    expectUnharmed();
}

TEST_F(PlantedJournal, OfAKilledSaveIsStillRolledBack) {
    plantJournal(file());
    EXPECT_EQ(error(), "");
    EXPECT_FALSE(fs::exists(beside("-journal")));
}

TEST_F(PlantedJournal, ThatStatesASizeTheFileNeverHadIsRefused) {
    plantJournal(file());
    std::string journal = allBytes(beside("-journal"));
    journal.replace(16, 4, bigEndian(0x7fffffff));  // pages of the database before the transaction
    std::ofstream(beside("-journal"), std::ios::binary) << journal;
    const auto before = fs::file_size(file());
    EXPECT_THAT(error(), HasSubstr("a size that the file never had"));
    EXPECT_EQ(fs::file_size(file()), before);
}

TEST_F(PlantedJournal, OrLogThatIsALinkIsRefused) {
    for (const char* ending : {"-journal", "-wal", "-shm"}) {
        fs::create_symlink(victim, beside(ending));
        EXPECT_THAT(error(), HasSubstr("a link")) << ending;
        fs::remove(beside(ending));
    }
    expectUnharmed();
}

TEST_F(PlantedJournal, OfAnOlderFileIsNotAppliedToANewOne) {
    plantJournal(file());
    fs::remove(file());
    EXPECT_FALSE(ProjectFile::create(file(), sampleProject()));
    const fs::path recovery = recoveryPath(file());
    fs::rename(beside("-journal"), recovery.string() + "-journal");
    Project project = sampleProject();
    for (int i = 0; i < 200; ++i) project.lots.push_back({"lot " + std::to_string(i), box(0, 0, 9, 9)});
    Autosave autosave(file());
    ASSERT_TRUE(autosave.keep(project));
    const auto recovered = ProjectFile::open(recovery);
    ASSERT_TRUE(recovered) << recovered.error().text();
    EXPECT_EQ(recovered->project().lots, project.lots);
    plantJournal(recovery);
    autosave.discard();
    EXPECT_THAT(folder_.names(), testing::ElementsAre("thesis.txt"));
}

TEST_F(PlantedJournal, MovesWithItsRecoveryFile) {
    plantJournal(file());
    const fs::path aside = folder_.path("aside.noonmark.gpkg");
    moveProject(file(), aside);
    EXPECT_TRUE(fs::exists(aside.string() + "-journal"));
    EXPECT_TRUE(ProjectFile::open(aside));
    EXPECT_THAT(folder_.names(), testing::ElementsAre("aside.noonmark.gpkg", "thesis.txt"));
}

}  // namespace
}  // namespace noonmark::tests
