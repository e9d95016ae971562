#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/study/verification/result_record.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::tests {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

const Commands known{"study", "impact", "review"};

Json aRecord() {
    return {{"repeat",
             "noonmark-cli study city.gpkg --start 2026-03-21 --window sunrise+1h..sunset-1h --out repeated"},
            {"project", nullptr},
            {"inputs", {{{"path", "/home/x/city.gpkg"}, {"bytes", 3}, {"sha256", "ab"}}}},
            {"mean_gross_min", 12.5},
            {"seconds", {{"total", 1.5}}}};
}

std::string faultOf(const Json& record) {
    const auto parsed = parseResultRecord(record.dump(), known, "study.json");
    return parsed ? "" : parsed.error().text();
}

TEST(ResultRecord, StatesItsCommandAndFiles) {
    const ResultRecord record = parseResultRecord(aRecord().dump(), known, "study.json").value();
    EXPECT_EQ(record.command[1], "study");
    ASSERT_EQ(record.files.size(), 1U);
    EXPECT_EQ(record.files[0].path, "/home/x/city.gpkg");
    EXPECT_TRUE(record.files[0].needed);
}

TEST(ResultRecord, FilesOfASavedProjectsCityAreNotNeeded) {
    Json record = aRecord();
    record["project"] = {{"file", "p.noonmark.gpkg"}, {"file_sha256", "cd"}};
    const auto files = parseResultRecord(record.dump(), known, "study.json").value().files;
    ASSERT_EQ(files.size(), 2U);
    EXPECT_TRUE(files[0].needed);
    EXPECT_FALSE(files[1].needed);
}

TEST(ResultRecord, CommandsThatReachElsewhereAreNotRun) {
    const auto withCommand = [](const std::string& command) {
        Json record = aRecord();
        record["repeat"] = command;
        return faultOf(record);
    };
    for (const char* command :
         {"noonmark-cli import x.osm --out repeated", "rm -r . --out repeated", "noonmark-cli study x.osm",
          "noonmark-cli study /etc/passwd --out repeated", "noonmark-cli study ../x --out repeated",
          "noonmark-cli study x.osm --out /tmp/x", "noonmark-cli study x.osm --out repeated --out other",
          "noonmark-cli study x.osm --out=repeated --overwrite",
          "noonmark-cli study --region=/etc/x --out repeated", "noonmark-cli study http://h/x --out repeated",
          "noonmark-cli study sunrise/../../x --out repeated",
          "noonmark-cli study --window=../x --out repeated",
          "noonmark-cli impact p.gpkg --save x --out repeated",
          "noonmark-cli impact p.gpkg --keep=x --out repeated", "noonmark-cli study C:\\\\x --out repeated",
          "noonmark-cli study ~/x --out repeated", "noonmark-cli study x.osm --out repeated; ls"})
        EXPECT_NE(withCommand(command), "") << command;
    EXPECT_EQ(withCommand("noonmark-cli review run p.gpkg --rule ceqr --places 'A, B' --out repeated"), "");
}

TEST(ResultRecord, WhatIsNoRecordIsRefused) {
    EXPECT_FALSE(parseResultRecord("", known, "x"));
    EXPECT_FALSE(parseResultRecord("[1]", known, "x"));
    EXPECT_FALSE(parseResultRecord(R"({"repeat": 7, "inputs": "many", "project": 3})", known, "x"));
    Json record = aRecord();
    record["repeat"] = nullptr;
    record["repeat_note"] = "the project has not been saved";
    EXPECT_THAT(faultOf(record), HasSubstr("has not been saved"));
}

TEST(FoundInputs, AreTheFilesWithTheRecordedHash) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path("deep/er"));
    std::ofstream(folder.path("city.gpkg")) << "other";
    std::ofstream(folder.path("deep/er/city.gpkg")) << "abc";
    std::ofstream(folder.path("terrain.tif")) << "changed";
    // SHA-256 of "abc": FIPS 180-4's example
    const std::string abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
    const auto found = findInputs(
        {{"C:\\maps\\city.gpkg", abc}, {"terrain.tif", abc}, {"gone.tif", abc, false}, {"sample:grid", ""}},
        folder.path(""), {});
    ASSERT_EQ(found.size(), 4U);
    EXPECT_TRUE(found[0].agrees);
    EXPECT_THAT(found[0].path->string(), HasSubstr("deep"));
    EXPECT_TRUE(found[1].path);
    EXPECT_FALSE(found[1].agrees);
    EXPECT_FALSE(found[2].path);
    EXPECT_TRUE(found[3].agrees);
    EXPECT_FALSE(areComplete(found));
    EXPECT_TRUE(areComplete({found[0], found[2], found[3]}));
}

TEST(RecordComparison, ListsEveryFigureThatDiffers) {
    Json recorded = aRecord(), computed = aRecord();
    computed["seconds"]["total"] = 99;
    computed["repeat"] = "another";
    computed["mean_gross_min"] = 12.5 * (1 + 1e-12);
    EXPECT_TRUE(compareRecords(recorded, computed).differences.empty());
    recorded["contributions_of_places"] = {{{"place", "Lawn"}, {"cells", 12}}};
    EXPECT_TRUE(compareRecords(recorded, computed).differences.empty()) << "no command computes these";
    computed["mean_gross_min"] = 12.500001;
    computed["new"] = 1;
    recorded["rows"] = {{{"enters", "09:31"}}, {{"enters", nullptr}}};
    computed["rows"] = {{{"enters", "09:32"}}};
    const auto differences = compareRecords(recorded, computed).differences;
    ASSERT_EQ(differences.size(), 4U);
    EXPECT_EQ(differences[0].key, "mean_gross_min");
    EXPECT_EQ(differences[1].key, "rows[0].enters");
    EXPECT_EQ(differences[1].recorded, "\"09:31\"");
    EXPECT_EQ(differences[1].computed, "\"09:32\"");
    EXPECT_EQ(differences[2].key, "rows[1].enters");
    EXPECT_EQ(differences[2].computed, "");
    EXPECT_EQ(differences[3].key, "new");
}

TEST(WordComparison, FindsAlteredFiguresAndGoesOn) {
    const std::string text = "Mean 12.5 min a day. Largest 480 min. Done in 3 rows and more words here";
    EXPECT_TRUE(compareWords(text, text).differences.empty());
    EXPECT_EQ(compareWords(text, text).figures, 3U);
    const auto one =
        compareWords(text, "Mean 12.6 min a day. Largest 480 min. Done in 3 rows and more words here");
    ASSERT_EQ(one.differences.size(), 1U);
    EXPECT_EQ(one.differences[0].recorded, "12.5");
    EXPECT_EQ(one.differences[0].computed, "12.6");
    EXPECT_EQ(one.differences[0].before, "Mean");
    EXPECT_TRUE(one.differences[0].hasFigure);
    const auto swapped = compareWords("a 1 b c d 2 e f g", "a 2 b c d 1 e f g");
    EXPECT_EQ(swapped.differences.size(), 2U);
    const auto wording =
        compareWords(text, "Mean 12.5 min a day. The Largest 480 min. Done in 3 rows and more words here");
    ASSERT_EQ(wording.differences.size(), 1U);
    EXPECT_FALSE(wording.differences[0].hasFigure);
    EXPECT_EQ(compareWords("a b c 5", "a b c").differences.size(), 1U);
    EXPECT_EQ(compareWords("", "5").differences.size(), 1U);
}

TEST(WordComparison, LeavesDurationsOfTheComputationOut) {
    EXPECT_TRUE(compareWords("used, 0.1 s in total. 5 x", "used, 12 s in total. 5 x").differences.empty());
    EXPECT_FALSE(compareWords("used, 0.1 s in total. 5 x", "used, 12 s in total. 6 x").differences.empty());
}

TEST(CompareTables, ARowOfMoreFieldsThanTheHeadingDiffers) {
    const char* sound = "place,area_m2,kind\r\n\"a, b\",26781.0,park\r\n";
    EXPECT_TRUE(compareTables("a.csv", sound, sound).differences.empty());
    EXPECT_EQ(compareTables("a.csv", sound, sound).fields, 6U);
    EXPECT_TRUE(compareTables("a.csv", "n\n1.50\n", "n\r\n1.5\r\n").differences.empty());
    // As Noonmark wrote it once, and as it compared it with itself.
    const char* split = "place,area_m2,kind\r\n\"a, b\",26,781,park\r\n";
    const auto differences = compareTables("a.csv", split, split).differences;
    ASSERT_EQ(differences.size(), 1U);
    EXPECT_EQ(differences[0].key, "a.csv, line 2");
    EXPECT_EQ(differences[0].recorded, "4 fields");
    EXPECT_EQ(compareTables("a.csv", sound, "place,area_m2,kind\n\"a, b\",26782,park\n").differences[0].key,
              "a.csv, line 2, area_m2");
    EXPECT_EQ(compareTables("a.csv", "n\n1\n", "n\n").differences[0].computed, "");
    EXPECT_EQ(compareTables("a.csv", "n\n", "n\n1\n").differences[0].recorded, "");
}

}  // namespace
}  // namespace noonmark::tests
