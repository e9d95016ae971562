#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>

#include "app/cli/tiles/tiles_command.h"
#include "tests/cli/command_output.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::cli::tests {
namespace {

using noonmark::tests::readBytes;
using testing::HasSubstr;

Environment environmentOf(const std::map<std::string, std::string>& variables) {
    return [variables](const char* name) -> std::optional<std::string> {
        const auto found = variables.find(name);
        return found == variables.end() ? std::nullopt : std::optional(found->second);
    };
}

TEST(FindArrayTask, OfSlurmKubernetesAndAwsBatch) {
    EXPECT_EQ(findArrayTask(environmentOf({{"SLURM_ARRAY_TASK_ID", "12"}})).value(), 12U);
    EXPECT_EQ(findArrayTask(environmentOf({{"JOB_COMPLETION_INDEX", "0"}})).value(), 0U);
    EXPECT_EQ(findArrayTask(environmentOf({{"AWS_BATCH_JOB_ARRAY_INDEX", "7"}})).value(), 7U);
    EXPECT_FALSE(findArrayTask(environmentOf({})));
    for (const char* wrong : {"", "-1", "x", "3 ", "1.5", "99999999999999999999999"})
        EXPECT_FALSE(findArrayTask(environmentOf({{"SLURM_ARRAY_TASK_ID", wrong}}))) << wrong;
}

class TilesCommand : public testing::Test {
protected:
    TilesCommand() { EXPECT_EQ(noonmarkCli({"sample", "grid", "--out", town}).code, 0); }
    [[nodiscard]] CommandOutput plan(std::vector<std::string> more = {},
                                     const std::string& engine = "ray") const {
        std::vector<std::string> words{"tiles",      "plan",
                                       town,         "--start",
                                       "2026-03-21", "--from",
                                       "10:00",      "--hours",
                                       "4",          "--step",
                                       "30",         "--zone",
                                       "UTC",        "--region",
                                       "city",       "--cell",
                                       "4",          "--engine",
                                       engine,       "--tile",
                                       "64",         "--no-error-sample",
                                       "--out",      dir,
                                       "--json"};
        words.insert(words.end(), more.begin(), more.end());
        return noonmarkCli(words);
    }

    noonmark::tests::TemporaryFolder folder;
    std::string town = folder.path("town.gpkg").string();
    std::string dir = folder.path("plan").string();
};

TEST_F(TilesCommand, PlansRunsAndMerges) {
    const CommandOutput planned = plan();
    ASSERT_EQ(planned.code, 0) << planned.err;
    EXPECT_TRUE(planned.json()["by_window"]);
    const std::size_t tasks = planned.json()["tasks"];
    EXPECT_EQ(noonmarkCli({"tiles", "merge", dir}).code, 1);
    for (std::size_t task = 0; task < tasks; ++task) {
        const CommandOutput ran =
            noonmarkCli({"tiles", "run", dir, "--task", std::to_string(task), "--threads", "1"});
        ASSERT_EQ(ran.code, 0) << ran.err;
    }
    EXPECT_TRUE(noonmarkCli({"tiles", "status", dir, "--json"}).json()["complete"]);
    const CommandOutput merged = noonmarkCli({"tiles", "merge", dir});
    ASSERT_EQ(merged.code, 0) << merged.err;
    EXPECT_THAT(merged.out, HasSubstr("shadow.vrt"));
    EXPECT_THAT(plan().err, HasSubstr("exist"));
    EXPECT_EQ(plan({"--overwrite"}).code, 0);
    EXPECT_THAT(noonmarkCli({"tiles", "run", dir, "--task", "0"}).out, HasSubstr(" 0 computed"));
}

TEST_F(TilesCommand, MonthsAreThoseOfCityStudy) {
    const CommandOutput planned = plan({"--by", "month", "--days", "20"}, "projected");
    ASSERT_EQ(planned.code, 0) << planned.err;
    for (std::size_t task = 0; task < planned.json()["tasks"]; ++task) {
        const CommandOutput ran = noonmarkCli({"tiles", "run", dir, "--task", std::to_string(task)});
        ASSERT_EQ(ran.code, 0) << ran.err;
    }
    ASSERT_EQ(noonmarkCli({"tiles", "merge", dir}).code, 0);
    const std::string whole = folder.path("whole").string();
    const CommandOutput city = noonmarkCli(
        {"city-study", town,     "--start",  "2026-03-21", "--from", "10:00",    "--hours",
         "4",          "--step", "30",       "--zone",     "UTC",    "--region", "city",
         "--cell",     "4",      "--engine", "projected",  "--tile", "64",       "--no-error-sample",
         "--by",       "month",  "--days",   "20",         "--out",  whole});
    ASSERT_EQ(city.code, 0) << city.err;
    EXPECT_THAT(city.out, HasSubstr("by_month.tif"));
    const auto figuresOf = [](const std::filesystem::path& csv) {  // the columns before the source
        std::vector<std::string> lines;
        std::ifstream stream(csv);
        for (std::string line; std::getline(stream, line);) {
            std::size_t end = 0;
            for (int comma = 0; comma < 4; ++comma) end = line.find(',', end + 1);
            lines.push_back(line.substr(0, end));
        }
        return lines;
    };
    const auto figures = figuresOf(folder.path("plan/merged/by_month.csv"));
    ASSERT_EQ(figures.size(), 3U);  // March and April
    EXPECT_THAT(figures[1], HasSubstr("2026-03,"));
    EXPECT_EQ(figures, figuresOf(folder.path("whole/by_month.csv")));
    const std::string style = readBytes(folder.path("whole/by_month.qml"));
    EXPECT_EQ(style, readBytes(folder.path("plan/merged/by_month.qml")));
    const double sunlit =
        std::stod(figures[1].substr(figures[1].find(',') + 1));  // of March, the longer part
    const double end = std::stod(style.substr(style.rfind("<item value=\"") + 13));
    EXPECT_GT(sunlit, 1440) << "more than a day has";
    EXPECT_GE(end, sunlit);
    EXPECT_LT(end, 1.5 * sunlit);
}

TEST_F(TilesCommand, ExitCodesTellErrorsThatStay) {
    EXPECT_EQ(noonmarkCli({"tiles", "run", dir, "--task", "0"}).code, 1);
    ASSERT_EQ(plan().code, 0);
    EXPECT_EQ(noonmarkCli({"tiles", "run", dir, "--task", "4000"}).code, 1);
    EXPECT_EQ(noonmarkCli({"tiles", "run", dir, "--task", "x"}).code, 2);
    std::filesystem::remove(town);
    EXPECT_EQ(noonmarkCli({"tiles", "run", dir, "--task", "0"}).code, 1);
    EXPECT_EQ(noonmarkCli({"tiles", "plan", "sample:grid", "--region", "city", "--start", "2026-03-21",
                           "--zone", "UTC", "--out", dir})
                  .code,
              2);
}

}  // namespace
}  // namespace noonmark::cli::tests
