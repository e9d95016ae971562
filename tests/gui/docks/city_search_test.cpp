#include "app/gui/docks/search/city_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QCompleter>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include "core/city/map_context.h"
#include "tests/scenarios/small_town.h"

namespace noonmark {
namespace {

const LonLat manhattan{-73.98, 40.75};

CitySearch townSearch() {
    City city = tests::threeHouses();
    city.frame = Frame(manhattan);
    Building named = *city.buildings[1];
    named.name = "Café Tower";
    city.buildings[1] = std::make_shared<const Building>(named);
    city.context = std::make_shared<const MapContext>(
        MapContext{{},
                   {{ContextKind::street, "Tower Street", 8, {{0, 0}, {100, 0}}},
                    {ContextKind::street, "Tower Street", 8, {{100, 0}, {250, 40}}}},
                   {},
                   {}});
    return {city,
            {{"Bryant Park", PlaceKind::park, {tests::box(0, 0, 50, 50)}, "drawn"}},
            {{"Corner", tests::box(10, 10, 20, 20)}}};
}

std::vector<QString> titles(const std::vector<Found>& found) {
    std::vector<QString> all;
    for (const Found& one : found) all.push_back(one.title);
    return all;
}

TEST(CitySearch, FindsNamesWhateverTheirAccentsAndCase) {
    const CitySearch search = townSearch();
    EXPECT_THAT(titles(search.find("cafe")), testing::ElementsAre(QString::fromUtf8("Café Tower")));
    EXPECT_THAT(titles(search.find("TOWER")),
                testing::ElementsAre("Tower Street", QString::fromUtf8("Café Tower")));
    EXPECT_THAT(titles(search.find("park")), testing::ElementsAre("Bryant Park"));
    EXPECT_THAT(titles(search.find("corner")), testing::ElementsAre("Corner"));
    EXPECT_TRUE(search.find("").empty());
    EXPECT_TRUE(search.find("nowhere").empty());
}

TEST(CitySearch, FindsABuildingByItsId) {
    const auto found = townSearch().find("b");
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().building, 1U);  // equal to the id, before names that begin with b
}

TEST(CitySearch, JoinsTheLinesOfAStreet) {
    const auto found = townSearch().find("tower street");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, FoundKind::street);
    EXPECT_EQ(found[0].box.high.x, 250);
}

TEST(CitySearch, ReadsPositionsInEitherOrder) {
    for (const char* text :
         {"40.7536, -73.9832", "-73.9832 40.7536", "40.7536N 73.9832W", "40.7536° N, 73.9832° W"}) {
        const auto at = parsePosition(QString::fromUtf8(text), manhattan);
        ASSERT_TRUE(at) << text;
        EXPECT_NEAR(at->latDeg, 40.7536, 1e-9) << text;
        EXPECT_NEAR(at->lonDeg, -73.9832, 1e-9) << text;
    }
    EXPECT_FALSE(parsePosition("5th Avenue", manhattan));
    EXPECT_FALSE(parsePosition("400, 500", manhattan));
    const auto found = townSearch().find("40.7536, -73.9832");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, FoundKind::coordinates);
}

// An entry that begins as the text does is chosen by Enter in the list; the list must serve more than once.
TEST(SearchField, FindsAgainAfterTheFocusWasElsewhere) {
    QWidget window;
    auto* layout = new QVBoxLayout(&window);
    auto* field = new SearchField;
    auto* other = new QLineEdit;
    layout->addWidget(field);
    layout->addWidget(other);
    field->setIndex([] { return townSearch(); });
    QSignalSpy found(field, &SearchField::found);
    window.show();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    for (int round = 1; round <= 3; ++round) {
        field->begin();
        QTest::keyClicks(field, QStringLiteral("Tower Street"));
        QTest::keyClick(field->completer()->popup(), Qt::Key_Return);
        ASSERT_EQ(found.count(), round);
        EXPECT_EQ(found.back().at(0).value<Found>().kind, FoundKind::street);
        EXPECT_EQ(field->text(), QStringLiteral("Tower Street"));
        other->setFocus();
    }
}

}  // namespace
}  // namespace noonmark
