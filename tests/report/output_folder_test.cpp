#include "app/report/files/output_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

std::vector<std::string> namesIn(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    return names;
}

TEST(OutputFolder, WritesAllOrNothing) {
    const tests::TemporaryFolder folder;
    OutputFolder files(folder.path("out"));
    files.add("a.txt", textContent("a"));
    files.add("b.txt", [](QIODevice&) { return false; });
    files.add("c.txt", textContent("c"));
    const auto written = std::move(files).result();
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().where, folder.path("out") / "b.txt");
    EXPECT_THAT(written.error().text(), HasSubstr("it could not be written completely"));
    OutputFolder again(folder.path("out"));
    again.add("d.txt", textContent("d"));
    EXPECT_TRUE(std::move(again).result());
    EXPECT_EQ(namesIn(folder.path("out")), std::vector<std::string>{"d.txt"});
}

TEST(OutputFolder, FilesHaveTheNamesThatTheRulesGiveThem) {
    const tests::TemporaryFolder folder;
    OutputRules rules;
    rules.renamed = {{"sheets.pdf", "Mill Lane.pdf"}};
    OutputFolder files(folder.path("out"), rules);
    files.add("sheets.pdf", textContent("%PDF-1.4"));
    const auto written = std::move(files).result();
    ASSERT_TRUE(written);
    EXPECT_EQ(written->front(), folder.path("out") / "Mill Lane.pdf");
    EXPECT_EQ(namesIn(folder.path("out")), std::vector<std::string>{"Mill Lane.pdf"});
    rules.inputs = {folder.path("out") / "Mill Lane.pdf"};
    rules.overwrite = true;
    OutputFolder again(folder.path("out"), rules);
    again.add("sheets.pdf", textContent("%PDF-1.4"));
    EXPECT_FALSE(std::move(again).result()) << "an input under the chosen name";
}

TEST(OutputFolder, WritesTheLastTextFromTheDurationsOfTheOthers) {
    const tests::TemporaryFolder folder;
    OutputFolder files(folder.path("out"));
    files.addLast("last.txt", [](const OutputFolder::Durations& durations) {
        std::string names;
        for (const auto& [name, seconds] : durations) names += seconds >= 0 ? name : "negative";
        return names;
    });
    files.add("b.txt", textContent("b"));
    files.add("a.txt", textContent("a"));
    ASSERT_TRUE(std::move(files).result());
    std::ifstream stream(folder.path("out") / "last.txt");
    std::string text;
    stream >> text;
    EXPECT_EQ(text, "a.txtb.txt");
}

// Simulates a full disk: no file may grow beyond 64 KiB.
TEST(OutputFolderDeathTest, AFullDiskIsReportedAndLeavesNothing) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const tests::TemporaryFolder folder;
    const auto fill = [&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{1 << 16, 1 << 16};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        OutputFolder files(folder.path("out"));
        files.add("small.txt", textContent("small"));
        files.add("large.txt", textContent(std::string(1 << 20, 'x')));
        const auto written = std::move(files).result();
        std::cerr << (written ? "written" : written.error().text()) << '\n';
        std::_Exit(namesIn(folder.path("out")).empty() ? 0 : 1);
    };
    EXPECT_EXIT(fill(), testing::ExitedWithCode(0), "large.txt: The file could not be written");
}

}  // namespace
}  // namespace noonmark
