#include "app/report/book/sun_by_place_book.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/report/book/print_book.h"
#include "tests/report/synthetic_study.h"

namespace noonmark {
namespace {

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
    sun.asked = PlacesAsked{{{"--kind", {"park"}}}, true};
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
    return std::get<PageTable>(book.pages.back().items.back().content);
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

}  // namespace
}  // namespace noonmark
