#include "app/gui/docks/search/city_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <QCompleter>
#include <QFocusEvent>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <glm/geometric.hpp>

#include "core/city/map_context.h"
#include "tests/gui/project_window.h"
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

TEST(CitySearch, FindsCommandsByTitleAndTooltipWhereTheyCanBeUsed) {
    QMenu menu(QStringLiteral("&Edit"));
    QMenu* below = menu.addMenu(QStringLiteral("&Trees"));
    QAction* plant = below->addAction(QStringLiteral("&Plant trees"));
    plant->setToolTip(QStringLiteral("An avenue, too"));
    CitySearch search = townSearch();
    search.addCommands(menu);
    const auto found = search.find("plant");
    ASSERT_THAT(titles(found), testing::ElementsAre("Plant trees"));
    EXPECT_EQ(found.front().command, plant);
    EXPECT_EQ(found.front().about, QStringLiteral("Edit > Trees"));
    EXPECT_THAT(titles(search.find("avenue")), testing::ElementsAre("Plant trees"));
    QAction* shape = below->addAction(QStringLiteral("Shape"));
    shape->setToolTip(QStringLiteral("Plant and shape"));
    EXPECT_THAT(titles(search.find("plant")), testing::ElementsAre("Plant trees"));
    CitySearch both = townSearch();
    both.addCommands(menu);
    EXPECT_THAT(titles(both.find("plant")), testing::ElementsAre("Plant trees", "Shape"));
    plant->setEnabled(false);
    EXPECT_TRUE(search.find("plant").empty());
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

using test::ProjectWindow;
using test::waitFor;

TEST_F(ProjectWindow, WhatIsChosenInTheListIsShownAlsoOnceTheFieldHasLostTheFocus) {
    build();
    auto* field = window->findChild<SearchField*>();
    ASSERT_NE(field, nullptr);
    const auto choose = [&](const QString& text) {
        QFocusEvent in(QEvent::FocusIn), out(QEvent::FocusOut);
        QCoreApplication::sendEvent(field, &in);
        field->clear();
        QTest::keyClicks(field, text);
        const QAbstractItemModel& list = *field->completer()->completionModel();
        EXPECT_GT(list.rowCount(), 0) << text.toStdString();
        Q_EMIT field->completer()->activated(list.index(0, 0));
        QCoreApplication::sendEvent(field, &out);
        return window->panel().view().pose().target;
    };
    const QString house = QString::fromStdString(test::idOf(session().project(), 0));
    const glm::dvec3 first = choose(house);
    EXPECT_EQ(window->tools().building().selected(), 0U);
    const glm::dvec3 tower = choose(QStringLiteral("New"));
    EXPECT_EQ(window->tools().building().selected(), 3U);
    EXPECT_GT(glm::distance(first, tower), 20);
    EXPECT_LT(glm::distance(choose(house), first), 1);
}

TEST_F(ProjectWindow, ACommandThatIsTypedIsRun) {
    auto* field = window->findChild<SearchField*>();
    QAction* asked = nullptr;
    for (const QMenu* menu : window->findChildren<QMenu*>())
        for (QAction* one : menu->actions())
            if (one->objectName() == QStringLiteral("drawPlace")) asked = one;
    ASSERT_NE(asked, nullptr);
    QSignalSpy run(asked, &QAction::triggered);
    field->setFocus();
    QTest::keyClicks(field, asked->text().remove(u'&'));
    QWidget* list = field->completer()->popup();
    QTest::keyClick(list->isVisible() ? list : field, Qt::Key_Return);
    EXPECT_EQ(run.size(), 1);
    EXPECT_TRUE(waitFor([&] { return field->text().isEmpty(); }));
}

}  // namespace
}  // namespace noonmark
