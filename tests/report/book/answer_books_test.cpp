#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QPainter>
#include <algorithm>
#include <stdexcept>

#include "app/report/book/answer_books.h"
#include "app/report/book/flow.h"
#include "app/report/book/print_book.h"
#include "app/report/files/element_files.h"
#include "app/report/sheets/answer_reports.h"
#include "core/city/trees/tree.h"
#include "tests/report/book/book_texts.h"
#include "tests/report/synthetic_study.h"

namespace noonmark {

namespace {

using testing::HasSubstr;

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

// 10 m2 h of the tree by its season.
TEST(ContributionBook, TreesHaveATableOfTheirOwn) {
    Study study = studyWithContributions();
    study.city.trees =
        std::make_shared<const Trees>(Trees{.trees = {{.sourceId = "node 5", .species = "Tilia"}}});
    study.field.trees =
        std::make_shared<const TreeShade>(TreeShade{.evergreen = study.field, .seasonal = study.field});
    study.byTree = TakenByTree{{{0, 20 * 60, 15 * 60}}, {{0, 10 * 60, 5 * 60}}, 1};
    const auto rowOf = [&](TreeColumns column) {
        const Book book = makeContributionBook(study, {.legend = {.trees = column}});
        const auto& table = std::get<PageTable>(book.pages.back().items.back().content);
        EXPECT_EQ(table.rows.size(), 1U);
        const auto& row = table.rows.front();
        return row[0] + u'|' + row[2] + u'|' + row[3];
    };
    EXPECT_EQ(rowOf(TreeColumns::without), QStringLiteral("Tilia (node 5)|10 m\u00b2 h|5 m\u00b2 h"));
    EXPECT_EQ(rowOf(TreeColumns::evergreen), QStringLiteral("Tilia (node 5)|20 m\u00b2 h|15 m\u00b2 h"));
    const Book book = makeContributionBook(study, {});
    EXPECT_THAT(tests::textOfPage(book, book.pages.size() - 1).toStdString(),
                HasSubstr("trees with their seasons"));
}

// Two cells: 0.5 and 0.25 without trees, 0.75 and 0.5 with their seasons.
TEST(ScoreMap, IsOfTheColumnThatTheLegendShowsAndNamesIt) {
    const Study study = tests::syntheticStudy();
    Score score;
    score.grid = {0, 0, 60, 2, 1};
    score.score = {0.5F, 0.25F};
    ShadedScore& with = score.withTrees.emplace_back();
    with.column = TreeColumns::seasonal;
    with.score = {0.75F, 0.5F};
    const auto mapOf = [&](TreeColumns trees) {
        LegendChoice choice;
        choice.trees = trees;
        return makeScoreMap(score, study.city, study.settings.region, choice);
    };
    const auto namesOf = [](const SheetMap& map) {
        std::string all;
        for (const auto& note : map.legend.notes) all += note.text.toStdString() + '|';
        return all;
    };
    EXPECT_THAT(namesOf(mapOf(TreeColumns::seasonal)), HasSubstr("trees with their seasons"));
    EXPECT_THAT(namesOf(mapOf(TreeColumns::without)), HasSubstr("without trees"));
    EXPECT_THAT(namesOf(mapOf(TreeColumns::evergreen)), HasSubstr("without trees")) << "not measured";
    EXPECT_GT(mapOf(TreeColumns::seasonal).legend.scale.top, mapOf(TreeColumns::without).legend.scale.top);
    score.withTrees.clear();
    EXPECT_THAT(namesOf(mapOf(TreeColumns::seasonal)), testing::Not(HasSubstr("trees")));
}

// A point with 60 min of shadow a day, 90 with trees as evergreens.
TEST(ElementStyle, IsByTheColumnThatTheLegendShows) {
    MeasuredElement element;
    element.grossMin = 60;
    ShadedMinutes& with = element.withTrees.emplace_back();
    with.column = TreeColumns::evergreen;
    with.grossMin = 90;
    const ElementMap map{.elements = {element}, .possibleMin = 600};
    LegendChoice choice;
    choice.trees = TreeColumns::evergreen;
    EXPECT_THAT(styleColumn(map, choice).qml, HasSubstr("attr=\"gross_min_evergreen\""));
    EXPECT_THAT(makeLegend(*inColumn(map, choice.trees), ShadowMeasure::gross, choice)
                    .notes.front()
                    .text.toStdString(),
                HasSubstr("trees as evergreens"));
    choice.trees = TreeColumns::seasonal;
    EXPECT_THAT(styleColumn(map, choice).qml, HasSubstr("attr=\"gross_min\"")) << "not measured";
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

const SheetMap& mapOf(const Book& book) {
    for (const BookPage& page : book.pages)
        for (const PageItem& item : page.items)
            if (const auto* map = std::get_if<PageMap>(&item.content)) return *map->map;
    throw std::logic_error("a book without a map");
}

QImage pictureOf(const Book& book) {
    const SheetMap& map = mapOf(book);
    QImage image(600, 600, QImage::Format_RGB32);
    QPainter painter(&image);
    paintMap({painter, 1}, makeMapView(map.scene, QRectF(image.rect())), map.scene);
    return image;
}

/// Every page can be read, and there are not too many of them.
void expectReadable(const Book& book) {
    EXPECT_LE(book.pages.size(), BookSettings::defaultPages) << book.title.toStdString();
    for (std::size_t i = 0; i < book.pages.size(); ++i) {
        const auto texts = tests::textsOfPage(book, i);
        EXPECT_THAT(tests::listMeetings(texts), testing::IsEmpty())
            << book.title.toStdString() << ", page " << i;
        constexpr double unit = MeasuringCanvas::unitsPerPoint;
        const QRectF frame = frameArea(book.setup);
        const QRectF inside(frame.topLeft() * unit, frame.size() * unit);
        for (const tests::PaintedText& text : texts)
            EXPECT_TRUE(inside.adjusted(-1, -1, 1, 1).contains(text.box))
                << book.title.toStdString() << ", page " << i << ": " << text.text.toStdString();
    }
}

constexpr PageSetup bothSetups[]{{Paper::a4, false}, {Paper::a4, true}};

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
    const SunOfCities sun = twoPlaces();
    const QImage plain = pictureOf(makeSunByPlaceBook(sun, {}));
    EXPECT_NE(pictureOf(makeSunByPlaceBook(sun, {}, {{.ramp = Ramp::viridis}, {}})), plain);
    EXPECT_NE(pictureOf(makeSunByPlaceBook(sun, {}, {{}, 0.5})), plain) << "above the threshold";
    EXPECT_TRUE(printBook(makeSunByPlaceBook(twoPlaces(), {})));
}

TEST(SunByPlaceBook, ItsTableNamesFiguresAsTheWindowDoesAndListsRemarks) {
    const Book book = makeSunByPlaceBook(twoPlaces(), {});
    const PageTable& table = tableOf(book);
    const QStringList titles(table.titles.begin(), table.titles.end());
    EXPECT_TRUE(titles.contains(QStringLiteral("Mean sun, h"))) << titles.join(u'|').toStdString();
    EXPECT_EQ(titles.back(), QStringLiteral("Remarks"));
    EXPECT_EQ(table.rows[1].front(), QStringLiteral("2")) << "its number on the map";
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

/// Many places with long names, dates and scenarios.
SunOfCities manyPlaces() {
    SunOfCities all = twoPlaces();
    SunByPlace& sun = all.baseline;
    sun.places.clear(), sun.sun.clear(), sun.partOf.clear();
    for (int i = 0; i < 400; ++i) {
        const float west = float(i % 20) * 6, south = float(i / 20) * 4;
        const Footprint outline{{{west, south}, {west + 5, south}, {west + 5, south + 3}, {west, south + 3}},
                                {}};
        sun.places.push_back({"Garden of the Seven Hills and Rivers, number " + std::to_string(i),
                              PlaceKind::park,
                              {outline},
                              "drawn"});
        SunOfPlace of;
        of.meanHours = of.minHours = of.maxHours = i / 100.0;
        of.areaM2 = 15;
        of.dateHours.assign(12, 1);
        of.belowShare.assign(12, 0.5);
        sun.sun.push_back(of);
    }
    sun.partOf.resize(sun.places.size());
    for (unsigned month = 1; month <= 12; ++month)
        sun.settings.dates.push_back(
            CivilDate{std::chrono::year{2026}, std::chrono::month{month}, std::chrono::day{21}});
    for (int i = 0; i < 9; ++i) {
        ComparedSun one{sun, std::vector<SunChange>(sun.places.size())};
        one.sun.name = "Scenario " + std::to_string(i);
        all.compared.push_back(std::move(one));
    }
    return all;
}

TEST(SunByPlaceBook, OfManyPlacesDatesAndScenariosCanBeReadAndHasAKey) {
    const SunOfCities many = manyPlaces();
    for (const PageSetup& setup : bothSetups) {
        const Book book = makeSunByPlaceBook(many, {.setup = setup});
        expectReadable(book);
        const auto map = std::ranges::find(book.pages, QStringLiteral("Map"), &BookPage::bookmark);
        const QString text = tests::textOfPage(book, std::size_t(map - book.pages.begin()));
        EXPECT_TRUE(text.contains(QStringLiteral("Further places: table"))) << text.toStdString();
    }
    EXPECT_GT(makeSunByPlaceBook(many, {.allPages = true}).pages.size(), BookSettings::defaultPages);
}

TEST(ContributionBook, OfManyBuildingsCanBeRead) {
    Study study = studyWithContributions();
    study.city.buildings.clear();
    study.breakdown->buildings.clear();
    for (std::uint32_t i = 0; i < 600; ++i) {
        study.city.buildings.push_back(std::make_shared<Building>(
            tower("House of the Seven Gables and its Gardens " + std::to_string(i), float(i % 100))));
        study.breakdown->buildings.push_back(shadowOf(i, 10, 5));
    }
    for (const PageSetup& setup : bothSetups) expectReadable(makeContributionBook(study, {.setup = setup}));
}

TEST(StudyBook, CanBeReadAndShowsOnRequestWhereHeightsComeFrom) {
    const Study study = tests::syntheticStudy();
    for (const PageSetup& setup : bothSetups) expectReadable(makeStudyBook(study, {.setup = setup}));
    const auto hasHeights = [&](bool wanted) {
        return std::ranges::any_of(
            makeStudyBook(study, {.heightMap = wanted}).pages,
            [](const BookPage& page) { return page.title == QStringLiteral("Where the heights come from"); });
    };
    EXPECT_FALSE(hasHeights(false));
    EXPECT_TRUE(hasHeights(true));
}

// As the figures of a comparison with trees and several thresholds are.
TEST(StudyBook, MoreFiguresThanBesideAMapAreOnPagesOfTheirOwn) {
    const Study study = tests::syntheticStudy();
    SavedMapBook saved{makeSheet(study)};
    for (int i = 0; i < 90; ++i)
        saved.sheet.figures.push_back(
            {"Gross, trees with their seasons, more than 30 min: number " + QString::number(i), "1,000 m²"});
    for (const PageSetup& setup : bothSetups) {
        const Book book = makeSavedBook(saved, {.setup = setup});
        expectReadable(book);
        QString all;
        for (std::size_t i = 0; i < book.pages.size(); ++i) all += tests::textOfPage(book, i);
        EXPECT_TRUE(all.contains(QStringLiteral("number 89"))) << "none is lost";
    }
}

}  // namespace

}  // namespace noonmark
