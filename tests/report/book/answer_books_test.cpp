#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "app/report/book/answer_books.h"
#include "app/report/book/print_book.h"
#include "tests/report/synthetic_study.h"

namespace noonmark {

namespace {

BuildingShadow shadowOf(std::uint32_t building, double attributedM2h, double soleM2h) {
    return {building, {attributedM2h * 60 / 3, attributedM2h * 60 * 2 / 3}, {soleM2h * 60, 0}};
}

Building tower(const std::string& name, float west) {
    Part part;
    part.footprint.outer = {{west, 0}, {west + 8, 0}, {west + 8, 8}, {west, 8}};
    part.topM = 30;
    return {.sourceId = "way 7", .name = name, .parts = {part}};
}

/// Attributed: 100 m2 h of "Large", 899.4 of "Larger", 0.6 of one that is left out, 1,000 of the terrain.
Study studyWithContributions() {
    Study study = tests::syntheticStudy();
    study.city.buildings = {std::make_shared<Building>(tower("Large", 10)),
                            std::make_shared<Building>(tower("", 30)),
                            std::make_shared<Building>(tower("Larger", 50))};
    ShadowBreakdown breakdown;
    breakdown.grid = study.field.grid;
    breakdown.buildings = {shadowOf(0, 100, 60), shadowOf(1, 0.6, 0.6), shadowOf(2, 899.4, 800)};
    breakdown.terrain = shadowOf(0, 1000, 900);
    study.breakdown = breakdown;
    return study;
}

TEST(ContributionBook, RowsAddUpToAllShadow) {
    const Study study = studyWithContributions();
    const Book book = makeContributionBook(study, {});
    const auto& table = std::get<PageTable>(book.pages.back().items.back().content);
    std::vector<std::string> rows;
    for (const auto& row : table.rows)
        rows.push_back(QStringList(row.begin(), row.end()).join(u'|').toStdString());
    const std::vector<std::string> expected{
        "1|Larger|44.97 %|899 m² h|800 m² h", "2|Large|5 %|100 m² h|60 m² h",
        "|Other buildings: 1|0.03 %|1 m² h|", "|Terrain|50 %|1,000 m² h|900 m² h",
        "|All shadow|100 %|2,000 m² h|"};
    EXPECT_EQ(rows, expected);
}

TEST(ContributionBook, HasTheLegendThatWasChosen) {
    const Study study = studyWithContributions();
    const Book book = makeContributionBook(study, {.legend = {.show = ShownAs::sun, .ramp = Ramp::viridis}});
    const Legend& legend = std::get<PageMap>(book.pages.front().items.front().content).map->legend;
    EXPECT_EQ(legend.title, QStringLiteral("Hours of sun"));
    EXPECT_EQ(legend.colours->ramp, Ramp::viridis);
}

TEST(ContributionBook, NumbersStandOnTheirBuildings) {
    const Study study = studyWithContributions();
    const Book book = makeContributionBook(study, {});
    const auto& map = std::get<PageMap>(book.pages.front().items.front().content).map;
    ASSERT_EQ(map->scene.marks.size(), 2U);
    EXPECT_EQ(map->scene.marks[0].text, QStringLiteral("1"));
    EXPECT_GT(map->scene.marks[0].at.x, 50);
    EXPECT_LT(map->scene.marks[0].at.x, 58);
    EXPECT_LT(map->scene.marks[1].at.x, 18);
    EXPECT_TRUE(printBook(book));
}

TEST(ContributionBook, NothingInShadowIsStillABook) {
    Study study = studyWithContributions();
    study.breakdown->buildings.clear();
    study.breakdown->terrain.reset();
    EXPECT_TRUE(printBook(makeContributionBook(study, {})));
}

using testing::HasSubstr;

/// A park with 1 h of sun a day, and a lake.
SunOfCities twoPlaces() {
    SunByPlace sun;
    sun.name = "Existing";
    sun.city = tests::syntheticStudy().city;
    const Region region = tests::syntheticStudy().settings.region;
    sun.settings.study.region = region;
    sun.settings.enoughHours = 2;
    sun.places = {{"Park", PlaceKind::park, region.polygons, "drawn"},
                  {"Lake", PlaceKind::other, region.polygons, "drawn"}};
    sun.sun.resize(2);
    for (SunOfPlace& of : sun.sun) of.meanHours = of.minHours = of.maxHours = of.areaM2 = 1;
    sun.sun[1].remarks = {PlaceRemark::onWater};
    sun.partOf.resize(2);
    sun.asked = PlaceSelection{{{"--kind", {"park"}}}, true};
    sun.provenance.project = ProjectRecord{"town.noonmark.gpkg", "hash", {}, {}, {}};
    sun.seconds = {{"total", 1}, {"forecast", 1}};
    return {sun, {}};
}

std::string wordsOf(const Book& book) {
    QString all;
    for (const BookPage& page : book.pages)
        for (const PageItem& item : page.items)
            if (const auto* text = std::get_if<PageText>(&item.content))
                for (const TextBlock& block : text->blocks) all += block.text + u'\n';
    return all.replace(QChar(QChar::LineSeparator), u' ').toStdString();
}

const PageTable& tableOf(const Book& book) {
    for (const BookPage& page : book.pages)
        for (const PageItem& item : page.items)
            if (const auto* table = std::get_if<PageTable>(&item.content)) return *table;
    throw std::logic_error("a book without a table");
}

QImage mapOf(const Book& book) {
    return std::get<PagePicture>(book.pages[book.pages.size() - 2].items.front().content).image;
}

TEST(SunByPlaceBook, StatesTheCommandThatRepeatsIt) {
    EXPECT_THAT(wordsOf(makeSunByPlaceBook(twoPlaces(), {})),
                HasSubstr("noonmark-cli by-place town.noonmark.gpkg"));
    EXPECT_THAT(wordsOf(makeSunByPlaceBook(twoPlaces(), {}, {{.ramp = Ramp::viridis}, 3.0})),
                HasSubstr("--threshold 3"));
    SunOfCities unknown = twoPlaces();
    unknown.baseline.asked.reset();
    EXPECT_THAT(wordsOf(makeSunByPlaceBook(unknown, {})), HasSubstr("how its places were chosen"));
}

// A column of a page has room for 60 letters of a command; a longer line breaks where the column ends, which
// may be between an option and its value.
TEST(SunByPlaceBook, ItsCommandBreaksOnlyBeforeOptions) {
    SunOfCities many = twoPlaces();
    many.baseline.settings.study.period.days = 1;
    many.baseline.settings.study.period.stepMinutes = 5;
    many.baseline.settings.enoughHours = 3.5;
    QStringList lines;
    for (const BookPage& page : makeSunByPlaceBook(many, {}, {{.ramp = Ramp::viridis}, 3.0}).pages)
        for (const PageItem& item : page.items)
            if (const auto* text = std::get_if<PageText>(&item.content))
                for (const TextBlock& block : text->blocks)
                    if (block.text.startsWith(QStringLiteral("noonmark-cli")))
                        lines = block.text.split(QChar(QChar::LineSeparator));
    ASSERT_GT(lines.size(), 1);
    for (qsizetype i = 0; i < lines.size(); ++i) {
        EXPECT_LE(lines[i].size(), 60) << lines[i].toStdString();
        if (i > 0) {
            EXPECT_TRUE(lines[i].trimmed().startsWith(QStringLiteral("--"))) << lines[i].toStdString();
        }
    }
}

TEST(SunByPlaceBook, ItsMapIsDrawnWithTheLegendOfTheWindow) {
    const QImage plain = mapOf(makeSunByPlaceBook(twoPlaces(), {}));
    EXPECT_NE(mapOf(makeSunByPlaceBook(twoPlaces(), {}, {{.ramp = Ramp::viridis}, {}})), plain);
    EXPECT_NE(mapOf(makeSunByPlaceBook(twoPlaces(), {}, {{}, 0.5})), plain) << "above the threshold";
    EXPECT_TRUE(printBook(makeSunByPlaceBook(twoPlaces(), {})));
}

TEST(SunByPlaceBook, ItsTableNamesFiguresAsTheWindowDoesAndListsRemarks) {
    const Book book = makeSunByPlaceBook(twoPlaces(), {});
    const PageTable& table = tableOf(book);
    const QStringList titles(table.titles.begin(), table.titles.end());
    EXPECT_TRUE(titles.contains(QStringLiteral("Mean sun, h"))) << titles.join(u'|').toStdString();
    EXPECT_EQ(titles.back(), QStringLiteral("Remarks"));
    EXPECT_TRUE(table.rows[1].back().startsWith(QStringLiteral("mostly on water")))
        << table.rows[1].back().toStdString();
    SunOfCities dry = twoPlaces();
    dry.baseline.sun[1].remarks.clear();
    const Book without = makeSunByPlaceBook(dry, {});
    EXPECT_NE(tableOf(without).titles.back(), QStringLiteral("Remarks"));
}

TEST(SunByPlaceBook, ErrorsAreRowsOfATableThatTheSummaryNames) {
    SunOfCities sun = twoPlaces();
    sun.baseline.errors = {sumUpError("place_mean", {0.25, 0.5}),
                           sumUpError("place_date", {0, 0}, "2026-12-21")};
    const Book book = makeSunByPlaceBook(sun, {});
    const auto& errors = std::get<PageTable>(book.pages.back().items.back().content);
    ASSERT_EQ(errors.rows.size(), 2U);
    EXPECT_EQ(errors.rows[0][4], QStringLiteral("0.5 min a day"));
    EXPECT_EQ(errors.rows[0].back(), QStringLiteral("2"));
    EXPECT_EQ(errors.rows[1][1], QStringLiteral("21 December 2026"));
    EXPECT_THAT(wordsOf(book), HasSubstr("in the table at the end"));
}

}  // namespace

}  // namespace noonmark
