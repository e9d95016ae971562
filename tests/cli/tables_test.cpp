#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "tests/cli/project_command.h"

namespace noonmark::cli::tests {

namespace {

using noonmark::tests::readBytes;

// Reads tables as a stranger does, by Python's csv module, which shares no code with the writer: each row has
// as many fields as the heading, what is named with a unit or counts is a number, and no text is a formula.
// Prints what is wrong, then "read" and the number of rows.
constexpr const char* strangersReader = R"(
import csv, math, re, sys
unit = re.compile(r'.*_(m|m2|m2h|min|deg|pct|ft2|s|h)(_[0-9-]+)?$|^(attributed|sole) ')
counts = {'intervals', 'receivers', 'floor', 'windows', 'changes', 'storeys', 'pass', 'borderline', 'fail',
          'not_judged', 'hour', 'weight', 'lon', 'lat', 'height', 'facing'}
rows = 0
for name in sys.argv[1:]:
    with open(name, newline='', encoding='utf-8-sig') as file:
        table = list(csv.reader(file, strict=True))
    for number, row in enumerate(table[1:], 2):
        rows += 1
        if len(row) != len(table[0]):
            print(f'{name}, row {number}: {len(row)} fields, {len(table[0])} in the heading: {row}')
            continue
        for column, value in zip(table[0], row):
            if unit.match(column) or column in counts:
                if value and not (re.fullmatch(r'-?[0-9]+(\.[0-9]+)?(e[-+][0-9]+)?', value) and math.isfinite(float(value))):
                    print(f'{name}, row {number}, {column}: {value!r} is no number')
            elif value.lstrip()[:1] in tuple('=@+-\uFF1D\uFF20\uFF0B\uFF0D') and value:
                print(f'{name}, row {number}, {column}: {value!r} is a formula')
print('read', rows)
)";

std::string said(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> shell(::popen((command + " 2>&1").c_str(), "r"), &::pclose);
    std::string text;
    for (int letter = 0; (letter = std::fgetc(shell.get())) != EOF;) text += char(letter);
    return text;
}

/// A project whose names are made to break tables.
class Tables : public ProjectCommand {
protected:
    void SetUp() override {
        if (said("python3 -c 'print(1)'") != "1\n") GTEST_SKIP() << "There is no python3 to read the tables";
        ProjectCommand::SetUp();
        done("add-scenario", {scenario_});
        done("demolish", {"One57", "--scenario", scenario_});
        auto disk = ProjectFile::open(file_).value();
        Project project = disk.project();
        const auto park = project.regions.at(0).polygons;
        project.places.push_back({"=1+1, \"Park\"; x", PlaceKind::park, park, "test"});
        project.places.push_back({"\uFF1DSUM(A1)", PlaceKind::park, park, "\uFF20x"});
        ASSERT_TRUE(disk.save(project));
    }

    /// Runs a command that must succeed.
    static std::string ran(const std::vector<std::string>& words) {
        const CommandOutput output = noonmarkCli(words);
        EXPECT_EQ(output.code, exitOk) << words[0] << ": " << output.err;
        return output.out;
    }

    /// Expects all tables in the folder to be sound, and as many as that.
    void expectTables(const std::filesystem::path& folder, std::size_t count) const {
        std::string command = "python3 " + folder_.file("read.py", strangersReader).string();
        std::size_t tables = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".csv") {
                command += " '" + entry.path().string() + "'";
                ++tables;
            }
        EXPECT_EQ(tables, count) << folder;
        const std::string text = said(command);
        EXPECT_THAT(text, testing::MatchesRegex("read [1-9][0-9]*\n")) << folder;
    }

    const std::string scenario_ = "=Tower, \"A\"";
    /// An hour in December; `from`: the option of its beginning.
    static std::vector<std::string> noon(const char* from) {
        return {"--start", "2026-12-21", from, "12:00",  "--hours",
                "1",       "--step",     "10", "--zone", "America/New_York"};
    }
};

TEST_F(Tables, OfStudiesAndCityStudiesAreReadByStrangers) {
    std::vector<std::string> asked{"--scenario",      scenario_,  "--by",    "month",
                                   "--contributions", "--engine", "horizon", "--cells-csv"};
    const auto when = noon("--from");
    asked.insert(asked.end(), when.begin(), when.end());
    const CommandOutput study = measured("study", asked);
    ASSERT_EQ(study.code, exitOk) << study.err;
    expectTables(folder_.path("out"), 3);  // cells, months and contributions
    std::vector<std::string> whole{"city-study", file_,     "--region", "Park",
                                   "--cell",     "10",      "--by",     "month",
                                   "--engine",   "horizon", "--out",    folder_.path("whole").string()};
    whole.insert(whole.end(), when.begin(), when.end());
    ran(whole);
    expectTables(folder_.path("whole"), 1);
}

TEST_F(Tables, OfPointsAreReadByStrangers) {
    const std::string points =
        folder_.file("points.csv", "id,lon,lat\n\"'=A1, b\",-73.9785,40.7675\n").string();
    std::vector<std::string> asked{
        "study", file_,      "--receivers", "points", "--points",
        points,  "--region", "Park",        "--out",  folder_.path("points").string()};
    const auto when = noon("--from");
    asked.insert(asked.end(), when.begin(), when.end());
    ran(asked);
    const std::string minutes = folder_.path("points/minutes.csv").string();
    ran({"point", file_, "--at", "-73.9785,40.7675,1.5", "--zone", "America/New_York", "--step", "15",
         "--csv", minutes});
    expectTables(folder_.path("points"), 2);
}

TEST_F(Tables, OfComparisonsScoresAndScenariosAreReadByStrangers) {
    ASSERT_EQ(atNoon("impact", {"--from", scenario_, "--to", "Existing", "--by-building"}).code, exitOk);
    ASSERT_EQ(atNoon("score", {"--scenario", scenario_, "--weights", "default"}).code, exitOk);
    ASSERT_EQ(atNoon("scenarios", {}).code, exitOk);
    expectTables(folder_.path("out"), 4);
}

TEST_F(Tables, OfReviewsAreReadByStrangers) {
    const std::string out = folder_.path("review").string();
    ran({"review", "run", file_, "--rule", "ceqr", "--from", scenario_, "--to", "Existing", "--places", "all",
         "--zone", "America/New_York", "--cell", "10", "--out", out});
    EXPECT_THAT(readBytes(folder_.path("review/review.csv")),
                testing::ContainsRegex(",[0-9][0-9][0-9][0-9]\\.[0-9],"))
        << "areas of a thousand and more";
    ran({"review",
         "run",
         file_,
         "--rule",
         "korea",
         "--from",
         scenario_,
         "--to",
         "Existing",
         "--facades-of",
         "all",
         "--region",
         "-73.9800,40.7645,-73.9780,40.7660",
         "--bay",
         "15",
         "--storey",
         "30",
         "--zone",
         "America/New_York",
         "--out",
         folder_.path("review/windows").string()});
    expectTables(folder_.path("review"), 2);
}

TEST_F(Tables, OfTilesAreReadByStrangers) {
    const std::string planned = folder_.path("plan").string();
    const std::string polygons = folder_
                                     .file("places.geojson", R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"name":"=A1, \"x\"","leisure":"park"},"geometry":{"type":"Polygon","coordinates":
[[[-73.980,40.766],[-73.977,40.766],[-73.977,40.768],[-73.980,40.768],[-73.980,40.766]]]}}]})")
                                     .string();
    const auto measured = [&](const std::vector<std::string>& more, const std::vector<std::string>& merge) {
        std::vector<std::string> words{"tiles",     "plan",  file_,    "--region", "Park",
                                       "--cell",    "10",    "--tile", "64",       "--engine",
                                       "projected", "--out", planned,  "--json"};
        const auto when = noon("--from");
        words.insert(words.end(), when.begin(), when.end());
        words.insert(words.end(), more.begin(), more.end());
        const std::size_t tasks = nlohmann::json::parse(ran(words))["tasks"];
        for (std::size_t task = 0; task < tasks; ++task)
            ran({"tiles", "run", planned, "--task", std::to_string(task)});
        std::vector<std::string> merged{"tiles", "merge", planned};
        merged.insert(merged.end(), merge.begin(), merge.end());
        ran(merged);
    };
    measured({"--by", "month"}, {"--places", polygons});
    expectTables(folder_.path("plan/merged"), 2);
    std::filesystem::remove_all(planned);
    measured({"--timelines", polygons}, {});
    expectTables(folder_.path("plan/merged"), 1);
}

TEST_F(Tables, OnStandardOutputAreReadByStrangers) {
    const auto printed = [&](const char* name, const std::string& text) {
        std::filesystem::create_directory(folder_.path("printed"));
        EXPECT_TRUE(folder_.file(std::string("printed/") + name, text).has_filename());
    };
    std::vector<std::string> asked{"timeline", file_, "--place", "all", "--csv"};
    const auto when = noon("--at");
    asked.insert(asked.end(), when.begin() + 2, when.end());
    asked.insert(asked.end(), {"--day", "2026-12-21"});
    printed("timeline.csv", ran(asked));
    const std::string weights = "name,first,last,weight\n\"'=1, \"\"a\"\"\",01-01,12-31,1\n";
    done("weights add", {"own", folder_.file("weights.csv", weights).string()});
    printed("weights.csv", done("weights show", {"own"}));
    expectTables(folder_.path("printed"), 2);
}

}  // namespace

}  // namespace noonmark::cli::tests
