#include "core/io/formats/format.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/base/gdal_calls.h"
#include "core/io/files/plain_file.h"
#include "core/io/footprints/footprint_scan.h"
#include "core/io/pieces/read_part.h"
#include "core/io/read_city.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using testing::Contains;
using testing::HasSubstr;

// One building of 20 m; the content does not matter.
Result<FilePiece> readToy(const std::filesystem::path&, const ReadSettings&, Progress&, std::stop_token,
                          const LonLatBox*) {
    Part part{.topM = 20};
    part.footprint.outer = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    FilePiece piece{.frame = Frame({-74, 40.7}), .format = "Toy"};
    piece.buildings.push_back(std::make_shared<const Building>(Building{.sourceId = "toy", .parts = {part}}));
    piece.groundM.emplace_back(0.0F);
    return piece;
}

std::vector<Format> formatsWithToy() {
    std::vector<Format> formats(coreFormats().begin(), coreFormats().end());
    formats.push_back({.name = "Toy",
                       .reader = {FileKind::footprints, readToy},
                       .endings = {".toy"},
                       .marks = {{"TOY 1"}},
                       .companions = {".toyprj"}});
    formats.push_back({.name = "Toy 0", .marks = {{"TOY 0"}}, .instead = "Save it again as Toy 1"});
    return formats;
}

TEST(Formats, OneIsAddedByOneRow) {
    const auto formats = formatsWithToy();
    const tests::TemporaryFolder folder;
    const auto file = folder.file("a.toy", "TOY 1\n");
    const auto found = detectFormat(file, formats);
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_EQ((*found)->name, "Toy");
    EXPECT_THAT(listEndings({FileKind::footprints}, formats), Contains(".toy"));
    EXPECT_THAT(listNames({FileKind::footprints, FileKind::mesh}, formats), HasSubstr("Toy"));
    EXPECT_EQ(findByEnding("b.TOY", FileKind::footprints, formats), *found);
    EXPECT_EQ(listCompanionFiles(file, formats), std::vector{folder.path("a.toyprj")});
    EXPECT_FALSE(detectFormat(file)) << "without the row";

    NoProgress quiet;
    const auto city = readCity({file}, {}, quiet, {}, formats);
    ASSERT_TRUE(city) << city.error().text();
    EXPECT_EQ(city->city.buildings.size(), 1);
    EXPECT_EQ(city->format, "Toy");
    const auto scan = scanBuildings(file, **found, {}, quiet, {});
    ASSERT_TRUE(scan) << scan.error().text();
    EXPECT_EQ(scan->features, 1);
    EXPECT_FALSE(scan->indexed);
}

TEST(Formats, ErrorsKnowAnAddedRow) {
    const auto formats = formatsWithToy();
    const tests::TemporaryFolder folder;
    EXPECT_THAT(detectFormat(folder.file("a", "hello"), formats).error().advice, HasSubstr("Toy"));
    const auto refused = detectFormat(folder.file("b.toy", "TOY 0\n"), formats);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().what, "This is Toy 0, which is not read");
    EXPECT_EQ(refused.error().advice, "Save it again as Toy 1");
}

TEST(Formats, EachIsRecognisedSomehowAndSaysWhatToDo) {
    for (const Format& format : coreFormats()) {
        EXPECT_TRUE(!format.marks.empty() || format.begins != nullptr || format.json != JsonKind::other ||
                    (format.isRead() && !format.driver.empty()))
            << format.name;
        EXPECT_EQ(format.instead.empty(), format.isRead()) << format.name;
    }
}

TEST(Formats, EachDriverOfGdalIsRegistered) {
    const GdalCalls setUp;
    for (const Format& format : coreFormats()) {
        const std::string driver(format.driver.empty() ? "MEM" : format.driver);
        EXPECT_NE(GetGDALDriverManager()->GetDriverByName(driver.c_str()), nullptr) << format.name;
    }
}

TEST(Formats, TheGuideNamesEachThatIsRead) {
    std::ifstream stream(tests::sourceFile("docs/user/data.md"));
    const std::string guide{std::istreambuf_iterator<char>(stream), {}};
    ASSERT_FALSE(guide.empty());
    for (const Format& format : coreFormats()) {
        if (!format.isRead()) continue;
        EXPECT_THAT(guide, HasSubstr(std::string(format.name)));
    }
}

TEST(Formats, WordsOfOpenStreetMapInAnotherFileAreNotOne) {
    const tests::TemporaryFolder folder;
    const auto file =
        folder.file("a.json", R"({"type":"FeatureCollection","name":"from <osm >","features":[]})");
    const auto found = detectFormat(file);
    ASSERT_TRUE(found);
    EXPECT_EQ((*found)->name, "GeoJSON");
    EXPECT_FALSE(findReadFormat({.bytes = "name;<osm >\n1;2\n"}));
}

}  // namespace
}  // namespace noonmark
