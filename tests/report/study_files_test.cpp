#include "app/report/files/study_files.h"

#include <gtest/gtest.h>

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/report/book/answer_books.h"
#include "app/report/sheets/study_report.h"
#include "tests/report/synthetic_study.h"

namespace noonmark {
namespace {

QByteArray reportOf(const Study& study) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    EXPECT_TRUE(writeReport(study, buffer));
    return buffer.data();
}

/// Counts "/Type /Page" without "/Type /Pages".
qsizetype pagesOf(const QByteArray& pdf) { return pdf.count("/Type /Page") - pdf.count("/Type /Pages"); }

std::vector<std::string> linesOf(const QByteArray& text) {
    std::istringstream stream(text.toStdString());
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line.ends_with('\r') ? line.substr(0, line.size() - 1) : line);
    return lines;
}

TEST(StudyReport, IsOnePageOfText) {
    const QByteArray pdf = reportOf(tests::syntheticStudy());
    EXPECT_TRUE(pdf.startsWith("%PDF"));
    EXPECT_EQ(pagesOf(pdf), 1);
    EXPECT_GE(pdf.count("/FontFile2"), 2) << "text must stay text";
}

TEST(StudyReport, StaysOnOnePageWithFarTooMuchToSay) {
    Study study = tests::syntheticStudy();
    study.settings.region.name = std::string(500, 'W');
    study.provenance.attribution = std::string(900, 'x');
    study.field.engine = std::string(3000, 'e');
    for (int i = 0; i < 300; ++i)
        study.provenance.inputs.push_back(
            {std::string(200, 'n') + std::to_string(i), 1, std::string(64, 'f')});
    for (int i = 0; i < 200; ++i)
        study.warnings.push_back({WarningKind::repaired, std::string(150, 'a') + std::to_string(i), "way"});
    EXPECT_EQ(pagesOf(reportOf(study)), 1);
}

TEST(StudyReport, AMomentHasAReportToo) {
    Study study = tests::syntheticStudy();
    study.settings.period.hours = 0;
    study.field.sunlitMinutesPerDay = 1;
    EXPECT_EQ(pagesOf(reportOf(study)), 1);
}

// The lines of cells.csv, the heading first.
std::vector<std::string> cellLinesOf(const Study& study) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    EXPECT_TRUE(writeCellsCsv(study.field, study.city.frame, buffer));
    std::vector<std::string> lines = linesOf(buffer.data());
    EXPECT_EQ(lines.size(), 1 + study.receivers.cells.size());
    return lines;
}

TEST(CellsCsv, HasARowForEachReceiver) {
    const auto lines = cellLinesOf(tests::syntheticStudy());
    ASSERT_GT(lines.size(), 1U);
    EXPECT_EQ(lines[0], "x_m,y_m,lon_deg,lat_deg,gross_min,continuous_min");
    EXPECT_EQ(lines[1].substr(0, 12), "0.500,0.500,");
    EXPECT_TRUE(lines[1].ends_with(",0.000,0.000"));
    EXPECT_EQ(lines.back().substr(0, 15), "119.500,79.500,");
    EXPECT_TRUE(lines.back().ends_with(",360.000,180.000"));
}

TEST(StudyReport, GrossShadowAloneHasOneMap) {
    const auto imagesOf = [](const QByteArray& pdf) { return pdf.count("/Subtype /Image"); };
    const QByteArray both = reportOf(tests::syntheticStudy());
    const QByteArray gross = reportOf(tests::grossOnly(tests::syntheticStudy()));
    EXPECT_EQ(pagesOf(gross), 1);
    EXPECT_LT(imagesOf(gross), imagesOf(both));
    EXPECT_GT(imagesOf(gross), 0);
}

TEST(CellsCsv, LeavesOutRunsThatWereNotCounted) {
    const auto lines = cellLinesOf(tests::grossOnly(tests::syntheticStudy()));
    ASSERT_GT(lines.size(), 1U);
    EXPECT_EQ(lines[0], "x_m,y_m,lon_deg,lat_deg,gross_min");
    EXPECT_EQ(std::ranges::count(lines.back(), ','), 4);
    EXPECT_TRUE(lines.back().ends_with(",360.000"));
}

TEST(CellsCsv, SaysWhenTheDeviceIsFull) {
    const Study study = tests::syntheticStudy();
    QFile full(QStringLiteral("/dev/full"));
    if (!full.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        GTEST_SKIP() << "there is no /dev/full here";
    EXPECT_FALSE(writeCellsCsv(study.field, study.city.frame, full));
}

TEST(StudyFiles, HaveABookOfSheetsOnRequest) {
    const QTemporaryDir folder;
    BookSettings book;
    book.titleBlock.author = "A. Planner";
    const auto files = writeStudyFiles(tests::syntheticStudy(), folder.path().toStdString(), {.book = book});
    ASSERT_TRUE(files) << files.error().text();
    QFile pdf(folder.filePath("sheets.pdf"));
    ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
    EXPECT_TRUE(pdf.readAll().startsWith("%PDF"));
    const Study study = tests::syntheticStudy();
    const Book pages = makeStudyBook(study, book);
    EXPECT_EQ(pages.titleBlock.author, "A. Planner");
    EXPECT_EQ(pages.pages.front().title, QStringLiteral("Shadow study: Four quarters"));
    EXPECT_EQ(pages.pages.back().title, QStringLiteral("Method and sources"));
}

TEST(StudyFiles, AreAllThere) {
    const QTemporaryDir folder;
    const std::filesystem::path out = std::filesystem::path(folder.path().toStdString()) / "new" / "folder";
    const auto files = writeStudyFiles(tests::syntheticStudy(), out, {.cellsCsv = true});
    ASSERT_TRUE(files) << files.error().text();
    std::vector<std::string> names;
    for (const auto& file : *files) {
        EXPECT_GT(std::filesystem::file_size(file), 100U) << file;
        names.push_back(file.filename().string());
    }
    EXPECT_EQ(names, (std::vector<std::string>{"shadow.tif", "shadow.qml", "shadow.png", "report.pdf",
                                               "study.json", "region.geojson", "cells.csv"}))
        << "its region is a box in metres, which four numbers in degrees do not state to the last bit";
    const auto entries =
        std::distance(std::filesystem::directory_iterator(out), std::filesystem::directory_iterator());
    EXPECT_EQ(std::size_t(entries), names.size()) << "nothing half done may stay behind";
    EXPECT_EQ(QImage(QString::fromStdString((out / "shadow.png").string())).width(), 1600);
}

TEST(StudyFiles, TheJsonSaysHowToRepeatIt) {
    Study study = tests::syntheticStudy();
    study.provenance.inputs = {{"city.gpkg", 7, "abc"}};
    const auto json = nlohmann::json::parse(studyJson(study));
    EXPECT_EQ(json["repeat"].get<std::string>().rfind("noonmark-cli study city.gpkg --start 2026-03-21", 0),
              0U);
}

TEST(StudyFiles, ARegionThatIsNoBoxComesAlong) {
    const QTemporaryDir folder;
    Study study = tests::syntheticStudy();
    study.settings.region = {"triangle", {{{{0, 0}, {100, 0}, {100, 100}}, {}}}};
    const auto files = writeStudyFiles(study, folder.path().toStdString(), {});
    ASSERT_TRUE(files) << files.error().text();
    EXPECT_EQ(files->back().filename(), "region.geojson");
}

TEST(StudyFiles, AFolderThatCannotBeMadeIsAnError) {
    const auto files = writeStudyFiles(tests::syntheticStudy(), "/proc/no/such", {});
    ASSERT_FALSE(files);
    EXPECT_NE(files.error().text().find("/proc/no/such"), std::string::npos);
    EXPECT_FALSE(files.error().advice.empty());
}

TEST(StudyFiles, AFileInPlaceOfTheFolderIsAnError) {
    const QTemporaryDir folder;
    const std::string inTheWay = folder.filePath(QStringLiteral("out")).toStdString();
    QFile file(QString::fromStdString(inTheWay));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    EXPECT_FALSE(writeStudyFiles(tests::syntheticStudy(), inTheWay, {}));
}

TEST(StudyFiles, AFolderInPlaceOfAFileIsAnErrorAndLeavesNothingHalfDone) {
    const QTemporaryDir folder;
    const std::filesystem::path out = folder.path().toStdString();
    std::filesystem::create_directories(out / "report.pdf" / "x");
    const auto files = writeStudyFiles(tests::syntheticStudy(), out, {});
    ASSERT_FALSE(files);
    EXPECT_NE(files.error().text().find("report.pdf"), std::string::npos);
    for (const auto& entry : std::filesystem::directory_iterator(out))
        EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
}

}  // namespace
}  // namespace noonmark
