#include "app/report/sheets/study_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <cmath>

#include "app/report/files/read_report.h"
#include "app/report/files/saved_files.h"
#include "core/io/write_raster.h"
#include "core/measures/shadow_figures.h"
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

/// A saved study as its sheet needs it.
struct ReadBack {
    SavedResult result;
    SavedAnswer answer = readSavedAnswer(result).value();
    Region region = makeSavedRegion(result, answer.origin, {});

    [[nodiscard]] SavedSheet sheetOf(const SavedMaps& maps) const {
        return makeSavedSheet(result, std::any_cast<const SavedStudy&>(answer.content), maps);
    }
};

TEST(SavedReport, HasTheColoursAndFiguresOfTheStudy) {
    const Study study = tests::syntheticStudy();
    const ReadBack saved{makeSavedStudy(study)};
    const ChangeScale scale;
    const LegendChoice legend;
    const SavedSource source{study.city};
    const Sheet sheet =
        makeSheet(saved.result, saved.answer.origin, saved.sheetOf({study.city, saved.region, scale, legend}),
                  saved.region, source);
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
    const ReadBack saved{makeSavedStudy(study)};
    Region corner = study.settings.region;  // without its last corner: as wide and as high
    corner.polygons[0].outer.pop_back();
    EXPECT_EQ(makeSavedRegion(saved.result, saved.answer.origin, {corner}).polygons, corner.polygons);
    Region elsewhere = corner;
    for (glm::vec2& point : elsewhere.polygons[0].outer) point += glm::vec2(40, 0);
    EXPECT_EQ(bounds(makeSavedRegion(saved.result, saved.answer.origin, {elsewhere})).low,
              bounds(corner).low);
}

TEST(SavedFiles, HoldPageAndPictureAndStateWhatHasChanged) {
    const QTemporaryDir folder;
    const std::filesystem::path out = folder.filePath(QStringLiteral("out")).toStdString();
    const Study study = tests::syntheticStudy();
    const ReadBack saved{makeSavedStudy(study)};
    const SavedResult& result = saved.result;
    const auto paths = writeSavedMaps(
        result, saved.answer.origin, {study.city, {"'Existing' has changed since."}},
        [&](const SavedMaps& maps) { return saved.sheetOf(maps); }, out);
    ASSERT_TRUE(paths) << paths.error().text();
    EXPECT_EQ(paths->size(), savedMapNames().size());
    EXPECT_EQ(QImage(QString::fromStdString((out / "result.png").string())).width(), pictureWidth);
    const auto bands = readGeoTiff(out / "result.tif", result.grid);
    ASSERT_TRUE(bands) << bands.error().text();
    EXPECT_EQ(bands->size(), result.layers.size());
    const auto words = readPrintedWords(out / "result.pdf");
    ASSERT_TRUE(words) << words.error().text();
    EXPECT_THAT(*words, AllOf(HasSubstr("June"), HasSubstr("has changed since"), HasSubstr("abcdef"),
                              HasSubstr("streets.gpkg")));
}

TEST(SavedFiles, OfAnyFiguresAreATableAndPages) {
    const QTemporaryDir folder;
    const std::filesystem::path out = folder.filePath(QStringLiteral("out")).toStdString();
    const Study study = tests::syntheticStudy();
    const ReadBack saved{makeSavedStudy(study)};
    const auto lines = listLines(shadowFigures().of(study.statistics));
    const auto paths = writeSavedFigures(saved.result, saved.answer.origin, {study.city}, lines, out);
    ASSERT_TRUE(paths) << paths.error().text();
    EXPECT_EQ(paths->size(), savedFigureNames().size());
    const auto words = readPrintedWords(out / "result.pdf");
    ASSERT_TRUE(words) << words.error().text();
    EXPECT_THAT(*words, AllOf(HasSubstr("June"), HasSubstr("Shadow area"), HasSubstr("abcdef")));
}

}  // namespace
}  // namespace noonmark
