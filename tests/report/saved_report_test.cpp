#include "app/report/sheets/saved_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <cmath>

#include "app/report/files/read_report.h"
#include "app/report/files/saved_files.h"
#include "app/report/sheets/study_report.h"
#include "core/io/write_raster.h"
#include "scenarios/project/results/save_result.h"
#include "tests/report/synthetic_study.h"

namespace noonmark {
namespace {

using testing::AllOf;
using testing::HasSubstr;

SavedResult makeSavedStudy(const Study& study) {
    Project project;
    project.city = std::make_shared<const City>(study.city);
    project.inputs = {{"streets.gpkg", 12, "abcdef"}};
    SavedResult result = makeSavedResult(project, existingCity, study);
    result.name = "June";
    return result;
}

/// A saved result as its sheet needs it.
struct SavedSheet {
    SavedResult result;
    SavedAnswer answer = readSavedAnswer(result).value();
    Region region = makeSavedRegion(result, answer, {});
};

TEST(SavedReport, HasTheColoursAndFiguresOfTheStudy) {
    const Study study = tests::syntheticStudy();
    const SavedSheet saved{makeSavedStudy(study)};
    const Sheet sheet = makeSheet(saved.result, saved.answer, saved.region, {study.city}, {});
    const Sheet expected = makeSheet(study);
    EXPECT_EQ(sheet.map.legend.scale.top, expected.map.legend.scale.top);
    ASSERT_EQ(sheet.figures.size(), expected.figures.size());
    for (std::size_t i = 0; i < sheet.figures.size(); ++i) {
        EXPECT_EQ(sheet.figures[i].name, expected.figures[i].name);
        EXPECT_EQ(sheet.figures[i].value, expected.figures[i].value);
    }
    constexpr int allCells = 1'000'000;  // more pixels than cells: one pixel a cell
    const QImage now = sheet.map.scene.image(allCells).image;
    const QImage then = expected.map.scene.image(allCells).image;
    ASSERT_EQ(now.size(), then.size());
    const Grid& grid = study.field.grid;
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        const int x = int(cell) % grid.columns, y = grid.rows - 1 - int(cell) / grid.columns;
        if (std::isnan(study.field.grossMin[cell])) continue;
        ASSERT_EQ(now.pixel(x, y), then.pixel(x, y)) << cell;
    }
}

TEST(SavedReport, OutlinesTheRegionOfThatNameWhereItStillHasItsExtent) {
    Study study = tests::syntheticStudy();
    study.settings.region.name = "Yard";
    const SavedSheet saved{makeSavedStudy(study)};
    Region corner = study.settings.region;  // without its last corner: as wide and as high
    corner.polygons[0].outer.pop_back();
    EXPECT_EQ(makeSavedRegion(saved.result, saved.answer, {corner}).polygons, corner.polygons);
    Region elsewhere = corner;
    for (glm::vec2& point : elsewhere.polygons[0].outer) point += glm::vec2(40, 0);
    EXPECT_EQ(bounds(makeSavedRegion(saved.result, saved.answer, {elsewhere})).low, bounds(corner).low);
}

TEST(SavedFiles, HoldPageAndPictureAndStateWhatHasChanged) {
    const QTemporaryDir folder;
    const std::filesystem::path out = folder.filePath(QStringLiteral("out")).toStdString();
    const Study study = tests::syntheticStudy();
    const SavedResult result = makeSavedStudy(study);
    const auto paths = writeSavedFiles(result, {study.city, {"'Existing' has changed since."}}, {}, out);
    ASSERT_TRUE(paths) << paths.error().text();
    EXPECT_EQ(paths->size(), savedFileNames(result).size());
    EXPECT_EQ(QImage(QString::fromStdString((out / "result.png").string())).width(), pictureWidth);
    const auto bands = readGeoTiff(out / "result.tif", result.grid);
    ASSERT_TRUE(bands) << bands.error().text();
    EXPECT_EQ(bands->size(), result.layers.size());
    const auto words = readPrintedWords(out / "result.pdf");
    ASSERT_TRUE(words) << words.error().text();
    EXPECT_THAT(*words, AllOf(HasSubstr("June"), HasSubstr("has changed since"), HasSubstr("abcdef"),
                              HasSubstr("streets.gpkg")));
}

TEST(SavedFiles, OfADamagedResultAreNotBegun) {
    const QTemporaryDir folder;
    const std::filesystem::path out = folder.filePath(QStringLiteral("out")).toStdString();
    const Study study = tests::syntheticStudy();
    SavedResult result = makeSavedStudy(study);
    result.layers.clear();
    EXPECT_FALSE(writeSavedFiles(result, {study.city}, {}, out));
    EXPECT_FALSE(std::filesystem::exists(out / "result.tif"));
}

}  // namespace
}  // namespace noonmark
