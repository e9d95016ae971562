#include "core/base/working_files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>

#include "core/io/files/write_text.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

TEST(PrivateFolder, IsOnlyForTheUserAndOfANewNameEachTime) {
    const tests::TemporaryFolder folder;
    std::set<std::filesystem::path> names;
    for (int i = 0; i < 20; ++i) {
        const PrivateFolder own(folder.path("."));
        struct stat found {};
        ASSERT_EQ(::lstat(own.path().c_str(), &found), 0);
        EXPECT_EQ(found.st_mode & 0777, 0700U);
        names.insert(own.path());
    }
    EXPECT_EQ(names.size(), 20U);
    EXPECT_TRUE(folder.names().empty());
    EXPECT_TRUE(PrivateFolder(folder.path("not there")).path().empty());
}

TEST(PrivateFolder, TakesNoFolderOfOthersForItsOwn) {
    const tests::TemporaryFolder folder;
    EXPECT_TRUE(makeOwnFolder(folder.path("own")));
    EXPECT_TRUE(makeOwnFolder(folder.path("own")));
    std::filesystem::permissions(folder.path("own"), std::filesystem::perms::all);
    EXPECT_FALSE(makeOwnFolder(folder.path("own"))) << "anybody may write to it";
    std::filesystem::create_directory(folder.path("other"));
    std::filesystem::create_directory_symlink(folder.path("other"), folder.path("link"));
    EXPECT_FALSE(makeOwnFolder(folder.path("link")));
}

TEST(PendingFile, WritesThroughNoLinkThatWaitsForIt) {
    const tests::TemporaryFolder folder;
    const auto precious = folder.file("precious", "before");
    // Every name that could be guessed: of the target, hidden, with the number of the process.
    for (int i = 0; i < 100; ++i)
        std::filesystem::create_symlink(
            precious, folder.path(".a." + std::to_string(::getpid()) + "-" + std::to_string(i) + ".txt"));
    std::filesystem::create_symlink(precious, folder.path("a.txt"));
    ASSERT_TRUE(writeText(folder.path("a.txt"), "after"));
    EXPECT_EQ(std::filesystem::file_size(precious), 6U);
    EXPECT_FALSE(std::filesystem::is_symlink(folder.path("a.txt")));
    const PendingFile pending(folder.path("b.txt"));
    EXPECT_FALSE(std::filesystem::exists(pending.path()));
    EXPECT_NE(pending.path().parent_path(), folder.path("."));
    EXPECT_EQ(pending.path().filename(), "b.txt");
}

[[noreturn]] void endWithoutDestructors(const std::filesystem::path& folder) {
    const PendingFile first(folder / "a"), second(folder / "b");
    std::ofstream(first.path()) << "begun";
    PrivateFolder::removeAllAndStop();
    const PendingFile late(folder / "c");
    std::cerr << std::distance(std::filesystem::directory_iterator(folder), {}) << " left";
    std::_Exit(writeText(folder / "d", "late") ? 1 : 0);
}

TEST(PrivateFolderDeathTest, NoneIsLeftByAProcessThatASignalEnds) {
    const tests::TemporaryFolder folder;
    EXPECT_EXIT(endWithoutDestructors(folder.path(".")), testing::ExitedWithCode(0), "^0 left");
}

}  // namespace
}  // namespace noonmark
