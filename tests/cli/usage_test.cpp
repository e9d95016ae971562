#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/command_output.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::cli::tests {
namespace {

using noonmark::tests::TemporaryFolder;
using testing::HasSubstr;
using testing::StartsWith;

void expectUsageError(const std::vector<std::string>& arguments, const std::string& about) {
    const CommandOutput output = noonmarkCli(arguments);
    EXPECT_EQ(output.code, exitUsage) << output.err;
    EXPECT_EQ(output.out, "");
    EXPECT_THAT(output.err, StartsWith("noonmark-cli: "));
    EXPECT_THAT(output.err, HasSubstr(about));
    EXPECT_EQ(std::ranges::count(output.err, '\n'), 1) << output.err;
}

std::vector<std::string> study(std::vector<std::string> more) {
    std::vector<std::string> arguments{"study",    "sample:central-park-south",
                                       "--start",  "2026-03-21",
                                       "--region", "-73.98,40.765,-73.979,40.766",
                                       "--out",    "/nonexistent/out",
                                       "--cell",   "5",
                                       "--step",   "30"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(Usage, HelpListsExcludedOptionsAlphabetically) {
    EXPECT_THAT(noonmarkCli({"study", "--help"}).out,
                HasSubstr("Excludes: --centre --days --from --hours --no-refraction --start --step --window "
                          "--zone"));
}

TEST(Usage, HelpAndVersionAreAnswers) {
    EXPECT_EQ(noonmarkCli({"--help"}).code, exitOk);
    EXPECT_THAT(noonmarkCli({"--help"}).out, HasSubstr("study"));
    EXPECT_THAT(noonmarkCli({"--version"}).out, HasSubstr("Noonmark 0."));
    for (const char* command : {"sample", "info", "import", "sun", "study"}) {
        const CommandOutput help = noonmarkCli({command, "--help"});
        EXPECT_EQ(help.code, exitOk) << command;
        EXPECT_THAT(help.out, HasSubstr("--json")) << command;
        EXPECT_EQ(help.err, "");
    }
}

TEST(Usage, AnEmptyValueDoesNotTakeTheNextWord) {
    expectUsageError(study({"--name=", "--json"}), "--name= has no value");
}

// Simulates a full disk behind standard output.
TEST(Usage, OutputThatCannotBeWrittenIsNoSuccess) {
    struct Full : std::streambuf {
        int_type overflow(int_type) override { return traits_type::eof(); }
    } full;
    std::ostream out(&full);
    std::ostringstream err;
    const char* words[] = {"noonmark-cli", "engines"};
    EXPECT_EQ(runCommandLine(2, words, {out, err}), exitFailed);
    EXPECT_THAT(err.str(), HasSubstr("could not be written"));
}

TEST(Usage, EnginesNameTheirOptions) {
    const CommandOutput engines = noonmarkCli({"engines"});
    EXPECT_EQ(engines.code, exitOk);
    EXPECT_THAT(engines.out, HasSubstr("ray"));
    EXPECT_THAT(engines.out, HasSubstr("--option levels=3  1 to 8"));
}

TEST(Usage, DevicesAreThoseToChooseFrom) {
    const CommandOutput devices = noonmarkCli({"devices"});
    EXPECT_EQ(devices.code, exitOk);
    EXPECT_THAT(devices.out, HasSubstr("--option device="));
}

TEST(Usage, WrongCommandLines) {
    expectUsageError({}, "subcommand");
    expectUsageError({"paint"}, "paint");
    expectUsageError({"info"}, "files");
    expectUsageError({"info", "city.gpkg", "--bright"}, "--bright");
    expectUsageError({"info", "city.gpkg", "--height-unit", "cubits"}, "cubits");
    expectUsageError({"info", "city.gpkg", "--default-height", "0"}, "--default-height");
    expectUsageError({"info", "city.gpkg", "--mesh-anchor", "somewhere"}, "--mesh-anchor");
    expectUsageError(study({"--zone", "UTC", "--engine", "magic"}), "magic");
    expectUsageError(study({"--zone", "UTC", "--engine", "iam", "--option", "levels"}), "levels=4");
    expectUsageError(study({"--zone", "UTC", "--engine", "iam", "--option", "levels=0"}), "1 to 8");
    expectUsageError(study({"--zone", "UTC", "--engine", "iam", "--option", "interval=121"}), "120 min");
    expectUsageError(study({"--zone", "UTC", "--engine", "iam", "--option", "bound=0"}), "0.1 to 20 deg");
    expectUsageError(study({"--zone", "UTC", "--engine", "ray", "--option", "levels=3"}), "Leave it out");
    expectUsageError({"sample", "atlantis", "--out", "a.gpkg"}, "atlantis");
    expectUsageError({"sample", "grid"}, "--out");
    expectUsageError({"sample", "grid", "--out", "a.gpkg", "--buildings", "5"}, "--buildings");
    expectUsageError({"sample", "central-park-south", "--out", "a.gpkg", "--seed", "5"}, "--seed");
}

TEST(Usage, WrongStudies) {
    expectUsageError({"study", "sample:grid"}, "--region");
    expectUsageError({"study", "sample:grid", "--region", "city", "--out", "o"}, "--start");
    expectUsageError(study({}), "--zone");
    expectUsageError(study({"--zone", "America/New_Yrok"}), "New_Yrok");
    expectUsageError(study({"--zone", "UTC", "--engine", "magic"}), "magic");
    expectUsageError(study({"--zone", "UTC", "--from", "25:99"}), "25:99");
    expectUsageError(study({"--zone", "UTC", "--hours", "25"}), "--hours");
    expectUsageError(study({"--zone", "UTC", "--days", "0"}), "--days");
    for (const char* option : {"--hours", "--temperature", "--pressure", "--far-away"})
        expectUsageError(study({"--zone", "UTC", option, "nan"}), option);
    expectUsageError({"study", "sample:grid", "--cell", "nan"},
                     "--cell: nan is out of range: give 0.25 to 10");
    expectUsageError(study({"--zone", "UTC", "--centre"}), "--window");
    expectUsageError(study({"--window", "sunrise..moonrise"}), "moonrise");
    expectUsageError(study({"--window", "sunrise..sunset", "--hours", "6"}), "--window");
}

TEST(Usage, FilesThatCannotBeRead) {
    const TemporaryFolder folder;
    expectUsageError({"info", folder.path("missing.gpkg").string()}, "missing.gpkg");
    expectUsageError({"info", folder.file("words.geojson", "hello").string()}, "words.geojson");
    expectUsageError({"info", "sample:atlantis"}, "atlantis");
    expectUsageError({"info", "sample:grid", folder.file("empty.geojson", "").string()},
                     "cannot be combined");
    expectUsageError({"study", "sample:grid", "--start", "2026-03-21", "--zone", "UTC", "--region",
                      folder.path("none.geojson").string(), "--out", folder.path("out").string()},
                     "none.geojson");
}

}  // namespace
}  // namespace noonmark::cli::tests
