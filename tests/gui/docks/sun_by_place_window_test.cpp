#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QTreeView>
#include <QUndoStack>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/contributions/contributions_dock.h"
#include "app/gui/docks/export/export_dialog.h"
#include "app/gui/docks/export/table_text.h"
#include "app/gui/docks/places/places_dock.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/docks/scenarios/scenarios_dock.h"
#include "app/gui/docks/study_form/places_form.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/view/panel/view_panel.h"
#include "core/city/trees/tree_facts.h"
#include "tests/gui/answers_window.h"

namespace noonmark {
namespace {

using test::waitFor;

Place area(const std::string& name, PlaceKind kind, glm::vec2 corner, float sideM,
           const std::string& source = "drawn") {
    return {name, kind, {test::square(corner, sideM)}, source};
}

/// The window with a project that has parks, one of them in pieces, a greenstreet and a street.
struct SunByPlaceWindow : test::AnswersWindow {
    void SetUp() override {
        test::AnswersWindow::SetUp();
        Project next = session().project();
        next.places = {area("North Park", PlaceKind::park, {-40, 30}, 60),
                       area("park (OSM way 7)", PlaceKind::park, {-30, 40}, 10, "OSM way 7"),
                       area("park (OSM way 8)", PlaceKind::park, {60, -70}, 10, "OSM way 8"),
                       area("Green", PlaceKind::greenstreet, {30, -70}, 20),
                       area("Main Street", PlaceKind::street, {-80, -80}, 20)};
        ASSERT_TRUE(session().change(std::move(next), QStringLiteral("places")));
        chooseKind(StudyKind::places);
    }

    StudyDock& form() { return *window->findChild<StudyDock*>(); }
    PlacesDock& dock() { return *window->findChild<PlacesDock*>(); }
    template <class Field>
    Field& field(const char* name) {
        return *window->findChild<Field*>(QString::fromLatin1(name));
    }
    void chooseKind(StudyKind kind) {
        auto& list = field<QComboBox>("studyKind");
        list.setCurrentIndex(int(kind));
        Q_EMIT list.activated(int(kind));
    }
    void chooseDays(int days) {
        StudySettings settings = workbench().document().settings();
        settings.period.days = days;
        workbench().document().change(settings, QStringLiteral("test"));
    }
    std::shared_ptr<const SunOfCities> sun() { return dock().model().sun(); }
    void measure() {
        chooseDays(40);
        const auto before = sun();
        QTest::mouseClick(&field<QPushButton>("run"), Qt::LeftButton);
        ASSERT_TRUE(waitFor([&] { return sun() && sun() != before; }))
            << window->panel().messages().text().toStdString();
    }
    // In the plural of any number, also where its forms are not translated yet.
    QString textOf(const char* label) {
        return field<QLabel>(label).text().replace(QStringLiteral("place(s)"), QStringLiteral("places"));
    }
    QString count() { return textOf("placesBelow"); }
    QAbstractItemView& table() { return field<QAbstractItemView>("placesTable"); }
    QStringList rows(const QModelIndex& parent = {}) {
        QStringList names;
        for (int row = 0; row < table().model()->rowCount(parent); ++row)
            names << table().model()->index(row, 0, parent).data().toString();
        return names;
    }
    std::size_t countBelow(double hours) {
        std::size_t below = 0;
        for (const SunOfPlace& one : sun()->baseline.sun)
            if (one.meanHours < hours) ++below;
        return below;
    }
};

TEST_F(SunByPlaceWindow, TheFormCountsKindsAndTicksThemExactly) {
    auto& kinds = field<QListWidget>("placeKinds");
    ASSERT_EQ(kinds.count(), 4);
    EXPECT_EQ(kinds.item(0)->text(), QStringLiteral("Parks 3"));
    EXPECT_EQ(kinds.item(1)->text(), QStringLiteral("Lawns and beds 1"));
    EXPECT_EQ(kinds.item(2)->text(), QStringLiteral("Streets 1"));
    EXPECT_TRUE(kinds.item(3)->text().startsWith(QStringLiteral("Own regions")));
    kinds.setCurrentRow(2);
    QTest::keyClick(&kinds, Qt::Key_Space);
    EXPECT_EQ(kinds.item(2)->checkState(), Qt::Unchecked);
    EXPECT_EQ(kinds.item(1)->checkState(), Qt::Checked) << "a lawn is no street";
    measure();
    EXPECT_EQ(sun()->baseline.places.size(), 4U);
}

TEST_F(SunByPlaceWindow, ItAsksForTheWholeYearUntilAnotherQuestionIsChosen) {
    const Period& period = workbench().document().settings().period;
    EXPECT_EQ(period.days, 365);
    EXPECT_TRUE(period.window);
    EXPECT_EQ(field<QLineEdit>("placeDates").text(), QStringLiteral("2026-12-21, 2026-03-21, 2026-06-21"));
    chooseKind(StudyKind::shadow);
    EXPECT_EQ(workbench().document().settings().period.days, 40);
    EXPECT_FALSE(workbench().document().settings().period.window);
}

TEST_F(SunByPlaceWindow, ADateThatIsNoneIsRefusedInTheForm) {
    auto& dates = field<QLineEdit>("placeDates");
    dates.clear();
    QTest::keyClicks(&dates, QStringLiteral("2026-13-21"));
    EXPECT_FALSE(field<QPushButton>("run").isEnabled());
    dates.clear();
    QTest::keyClicks(&dates, QStringLiteral("2026-12-21"));
    EXPECT_TRUE(field<QPushButton>("run").isEnabled());
    measure();
    EXPECT_EQ(sun()->baseline.settings.dates.size(), 1U);
}

TEST_F(SunByPlaceWindow, TheThresholdColoursAndCountsThePlacesBelowIt) {
    measure();
    auto& slider = field<QSlider>("placesSlider");
    EXPECT_EQ(slider.value(), 20) << "two hours were asked for";
    const auto before = dock().view();
    for (const int tenths : {0, 45, 80, 120}) {
        slider.setValue(tenths);
        const QString expected = QStringLiteral("%1 of 5 places have less than %2 h of sun a day")
                                     .arg(countBelow(tenths / 10.0))
                                     .arg(tenths / 10.0, 0, 'f', 1);
        EXPECT_EQ(count().toStdString(), expected.toStdString());
    }
    EXPECT_NE(dock().view()->picture.pixels, before->picture.pixels);
    EXPECT_EQ(window->panel().legend().legend()->title, QStringLiteral("Sun by place"));
    EXPECT_TRUE(field<QComboBox>("measure").isHidden()) << "gross shadow is not what is shown";
    auto& shown = field<QComboBox>("placesShown");
    ASSERT_EQ(shown.count(), 4) << "the period and three dates";
    shown.setCurrentIndex(1);
    EXPECT_TRUE(count().contains(QStringLiteral("21 December 2026"))) << count().toStdString();
}

TEST_F(SunByPlaceWindow, TheShareWithEnoughSunFollowsTheThreshold) {
    measure();
    const auto share = [&] {
        const QAbstractItemModel& model = *table().model();
        return model.index(0, dock().model().enoughColumn()).data(PlaceSunModel::valueRole).toDouble();
    };
    EXPECT_DOUBLE_EQ(share(), 100 * sun()->baseline.sun[0].enoughShare);
    field<QSlider>("placesSlider").setValue(0);
    EXPECT_EQ(share(), 100);
    field<QSlider>("placesSlider").setValue(120);
    EXPECT_EQ(share(), 0);
    EXPECT_TRUE(table()
                    .model()
                    ->headerData(dock().model().enoughColumn(), Qt::Horizontal)
                    .toString()
                    .contains(QStringLiteral("12 h")));
}

TEST_F(SunByPlaceWindow, TheNextRunBeginsWithTheThresholdOfTheAnswer) {
    measure();
    field<QSlider>("placesSlider").setValue(45);
    ASSERT_TRUE(waitFor([&] { return field<QDoubleSpinBox>("enoughHours").value() == 4.5; }));
    measure();
    EXPECT_EQ(field<QSlider>("placesSlider").value(), 45);
    EXPECT_EQ(sun()->baseline.settings.enoughHours, 4.5);
}

TEST_F(SunByPlaceWindow, OneThresholdRulesColumnsOfDatesHeadlineAndFiles) {
    measure();
    const std::vector<Place> places = sun()->baseline.places;
    const auto headline = [&] { return window->findChild<ResultsDock*>()->headline(); };
    EXPECT_TRUE(headline().contains(QStringLiteral("less than 2 h"))) << headline().toStdString();
    table().setCurrentIndex(table().model()->index(1, 0));
    Q_EMIT window->findChild<ResultsDock*>()->allPlacesRequested();
    field<QSlider>("placesSlider").setValue(120);
    QStringList headings;
    for (int column = 0; column < table().model()->columnCount(); ++column)
        headings << table().model()->headerData(column, Qt::Horizontal).toString();
    EXPECT_TRUE(headings.filter(QStringLiteral("2 h")).filter(QStringLiteral("< 2 h")).isEmpty())
        << headings.join(u' ').toStdString();
    EXPECT_EQ(headings.filter(QStringLiteral("< 12 h")).size(), 3);
    ASSERT_TRUE(waitFor([&] { return sun()->baseline.settings.enoughHours == 12; }));
    EXPECT_TRUE(headline().contains(QStringLiteral("less than 12 h"))) << headline().toStdString();
    EXPECT_TRUE(headline().startsWith(QStringLiteral("5 of 5"))) << headline().toStdString();
    EXPECT_EQ(field<QSlider>("placesSlider").value(), 120);
    EXPECT_TRUE(table().currentIndex().isValid()) << "the table is not filled anew";
    EXPECT_EQ(sun()->baseline.sun[0].belowShare[0], 1) << "no cell has 12 h on 21 December";
    EXPECT_EQ(sun()->baseline.sun[0].enoughShare, 0);
    EXPECT_EQ(sun()->baseline.places, places);
    EXPECT_NE(workbench().answer()->json().find("\"enough_hours\": 12"), std::string::npos);
    EXPECT_EQ(workbench().measured().size(), 1U) << "it is the same answer";
}

TEST_F(SunByPlaceWindow, AChosenPlaceShowsItsMonthsAndItsContributorsInResults) {
    measure();
    auto& results = *window->findChild<ResultsDock*>();
    const QString ofAll = results.headline();
    const auto& places = sun()->baseline.places;
    const auto park = std::ranges::find(places, "North Park", &Place::name) - places.begin();
    dock().select(std::size_t(park));
    EXPECT_TRUE(results.headline().startsWith(QStringLiteral("North Park: ")))
        << results.headline().toStdString();
    EXPECT_EQ(results.headline(), sentenceText(makePage(*sun(), std::size_t(park)).headline));
    EXPECT_TRUE(field<QPushButton>("allPlaces").isVisibleTo(&results));
    const auto hasContributors = [&] {
        return std::ranges::any_of(results.rows(), [](const ResultRow& row) {
            return row.value.contains(QStringLiteral("of sun a day, "));
        });
    };
    EXPECT_FALSE(hasContributors());
    QTest::mouseClick(&field<QPushButton>("resultContributors"), Qt::LeftButton);
    ASSERT_TRUE(waitFor(hasContributors));
    QTest::mouseClick(&field<QPushButton>("allPlaces"), Qt::LeftButton);
    EXPECT_EQ(results.headline(), ofAll);
    EXPECT_FALSE(field<QPushButton>("allPlaces").isVisibleTo(&results));
}

TEST_F(SunByPlaceWindow, TheLegendTakesRangeAndClassesInHours) {
    measure();
    LegendStrip& strip = window->panel().legend();
    strip.edit();
    EXPECT_TRUE(field<QComboBox>("legendRamp").currentText().startsWith(QStringLiteral("Orange to violet")))
        << "the colours that the places have";
    auto& kinds = field<QComboBox>("legendClasses");
    ASSERT_TRUE(kinds.isEnabled());
    kinds.setCurrentIndex(int(LegendClasses::Kind::breaks));
    auto& numbers = field<QLineEdit>("legendBreaks");
    numbers.setText(QStringLiteral("1,5"));
    QTest::keyClick(&numbers, Qt::Key_Return);
    EXPECT_EQ(strip.legend()->colours->breaks, (std::vector<double>{1, 5}));
    kinds.setCurrentIndex(int(LegendClasses::Kind::continuous));
    EXPECT_EQ(strip.legend()->colours->breaks.size(), 5U) << "those of the threshold again";
}

// Sun and shadow add up to the sunlit time.
TEST_F(SunByPlaceWindow, OneSwitchShowsMinutesOfShadowEverywhereAndStays) {
    measure();
    LegendStrip& strip = window->panel().legend();
    const auto& results = *window->findChild<ResultsDock*>();
    const auto colours = dock().view()->picture.pixels;
    const double hours = sun()->baseline.sun[0].meanHours, possible = sun()->baseline.possibleHours;
    const QModelIndex first = table().model()->index(0, PlaceSunModel::firstFigure);
    EXPECT_NEAR(first.data(PlaceSunModel::valueRole).toDouble(), hours, 1e-9);
    ASSERT_FALSE(field<QToolButton>("showShadow").isHidden());
    EXPECT_TRUE(field<QToolButton>("showSun").isChecked()) << "it is asked for as sun";
    field<QToolButton>("showShadow").click();
    const QModelIndex now = table().model()->index(0, PlaceSunModel::firstFigure);
    EXPECT_NEAR(now.data(PlaceSunModel::valueRole).toDouble(), (possible - hours) * 60, 1e-6);
    EXPECT_TRUE(table()
                    .model()
                    ->headerData(PlaceSunModel::firstFigure, Qt::Horizontal)
                    .toString()
                    .contains(QStringLiteral("shadow, min")));
    EXPECT_EQ(dock().view()->picture.pixels, colours) << "the same places are the dark ones";
    EXPECT_EQ(strip.legend()->title, QStringLiteral("Shadow by place"));
    const auto& breaks = strip.legend()->colours->breaks;
    EXPECT_TRUE(std::ranges::is_sorted(breaks));
    EXPECT_EQ(breaks[2], std::round((possible - 2) * 60)) << "the threshold of two hours of sun";
    EXPECT_TRUE(results.headline().contains(QStringLiteral("in shadow for more than")))
        << results.headline().toStdString();
    dock().select(0);
    EXPECT_TRUE(results.headline().contains(QStringLiteral("of shadow a day")))
        << results.headline().toStdString();
    EXPECT_EQ(settings.value(QStringLiteral("placesShow")).toString(), QStringLiteral("shadow"));
    field<QToolButton>("showSun").click();
    EXPECT_EQ(strip.legend()->title, QStringLiteral("Sun by place"));
    EXPECT_EQ(dock().view()->picture.pixels, colours);
}

// Days that are no days of the period keep hours of sun: their shadow is not known.
TEST_F(SunByPlaceWindow, ADateIsCountedListedAndShownFirstInTheUnitThatIsChosen) {
    measure();
    auto& tree = field<QTreeView>("placesTable");
    auto& shown = field<QComboBox>("placesShown");
    const int period = dock().model().columnOf({});
    tree.sortByColumn(period, Qt::AscendingOrder);
    const CivilDate june = std::chrono::year(2026) / 6 / 21, march = std::chrono::year(2026) / 3 / 21;
    const auto& dates = sun()->baseline.settings.dates;
    const auto at = std::size_t(std::ranges::find(dates, march) - dates.begin());
    ASSERT_TRUE(at < dates.size() && std::ranges::find(dates, june) != dates.end());
    shown.setCurrentIndex(int(at) + 1);
    const int column = dock().model().columnOf({ShownSun::What::date, at});
    EXPECT_NE(column, period);
    EXPECT_EQ(tree.header()->visualIndex(column), 1) << "beside the names";
    EXPECT_EQ(tree.header()->sortIndicatorSection(), column) << "the order follows what is shown";

    auto& threshold = field<QDoubleSpinBox>("placesThreshold");
    threshold.setValue(std::ceil(sun()->baseline.sun[0].dateHours[at] * 10) / 10 + 0.1);
    const auto below = std::ranges::count_if(
        sun()->baseline.sun, [&](const SunOfPlace& one) { return one.dateHours[at] < threshold.value(); });
    ASSERT_GT(below, 0);
    field<QCheckBox>("placesOnlyBelow").setChecked(true);
    EXPECT_TRUE(textOf("placesListed").startsWith(QString::number(below)))
        << textOf("placesListed").toStdString();
    EXPECT_TRUE(count().contains(QStringLiteral("h of sun on 21 March 2026"))) << count().toStdString();
}

TEST_F(SunByPlaceWindow, ShadowOfTheDatesIsStatedWhereTheyAreInThePeriod) {
    chooseDays(365);
    const auto before = sun();
    QTest::mouseClick(&field<QPushButton>("run"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return sun() && sun() != before; }));
    field<QToolButton>("showShadow").click();
    field<QComboBox>("placesShown").setCurrentIndex(1);
    const double possible = possibleHoursOn(
        sun()->baseline, [&](const CivilDate& day) { return day == sun()->baseline.settings.dates[0]; });
    const QString minutes = QString::number(std::round((possible - 2) * 60));
    EXPECT_TRUE(
        count().contains(QStringLiteral("more than %1 min of shadow on 21 December 2026").arg(minutes)))
        << count().toStdString();
    EXPECT_EQ(field<QDoubleSpinBox>("placesThreshold").suffix(), QStringLiteral(" h of sun"));

    // Which have too little shade: those with most sun.
    std::vector<double> hours;
    for (const SunOfPlace& one : sun()->baseline.sun) hours.push_back(one.dateHours[0]);
    const double middle = (*std::ranges::min_element(hours) + *std::ranges::max_element(hours)) / 2;
    auto& shade = field<QDoubleSpinBox>("placesShade");
    EXPECT_FALSE(shade.isHidden());
    shade.setValue(possible - middle);
    const auto sunny =
        std::ranges::count_if(hours, [&](double one) { return possible - one < shade.value(); });
    ASSERT_GT(sunny, 0);
    EXPECT_TRUE(count().startsWith(QString::number(sunny))) << count().toStdString();
    EXPECT_TRUE(count().contains(
        QStringLiteral("less than %1 h of shade on 21 December 2026").arg(shade.value(), 0, 'f', 1)))
        << count().toStdString();
    field<QCheckBox>("placesOnlyBelow").setChecked(true);
    EXPECT_TRUE(textOf("placesListed").startsWith(QString::number(sunny)))
        << textOf("placesListed").toStdString();
    field<QToolButton>("showSun").click();
    EXPECT_TRUE(shade.isHidden());
    EXPECT_TRUE(count().contains(QStringLiteral("less than 2.0 h of sun"))) << count().toStdString();
}

TEST_F(SunByPlaceWindow, WhatWasTickedAndListedComesBackWithTheProject) {
    auto& kinds = field<QListWidget>("placeKinds");
    kinds.item(2)->setCheckState(Qt::Unchecked);
    field<QDoubleSpinBox>("enoughHours").setValue(3);
    measure();
    field<QComboBox>("placesShown").setCurrentIndex(2);
    field<QCheckBox>("placesGrouped").setChecked(true);
    const std::string asked = form().places().choice(), listed = dock().choice();
    form().places().restore({});
    EXPECT_EQ(kinds.item(2)->checkState(), Qt::Checked) << "as at first";
    EXPECT_EQ(field<QDoubleSpinBox>("enoughHours").value(), 2);
    form().places().restore(asked);
    EXPECT_EQ(kinds.item(2)->checkState(), Qt::Unchecked);
    EXPECT_EQ(form().places().choice(), asked);
    dock().restore(listed);
    measure();
    EXPECT_EQ(dock().choice(), listed);
    for (const char* hostile : {"", "[]", "{\"unticked\":7,\"dates\":[]}", "{\"unticked\":[1,\"nothing\"]}"})
        form().places().restore(hostile);
    EXPECT_EQ(kinds.item(2)->checkState(), Qt::Checked);
}

// What is measured of all scenarios does not depend on the one that is displayed.
TEST_F(SunByPlaceWindow, AnotherScenarioOrAnswerMayBeShownWhileAllAreMeasured) {
    measure();
    chooseDays(3);
    session().goTo(existingCity);
    ASSERT_TRUE(waitFor([&] { return !workbench().following().busy() && !workbench().running().busy(); }));
    workbench().measureAll();
    ASSERT_TRUE(workbench().running().busy());
    session().goTo("Tower");
    ASSERT_TRUE(waitFor([&] { return workbench().measuredScenarios().size() == 2; }));
}

TEST_F(SunByPlaceWindow, TheColumnOfNamesIsWideEnoughForThemWhereThePanelHasRoom) {
    measure();
    auto& tree = field<QTreeView>("placesTable");
    tree.setFixedWidth(500);
    ASSERT_TRUE(waitFor([&] { return tree.viewport()->width() > 450; }));
    for (int row = 0; row < tree.model()->rowCount(); ++row) {
        const QString name = tree.model()->index(row, 0).data().toString();
        EXPECT_GE(tree.columnWidth(0), tree.indentation() + tree.fontMetrics().horizontalAdvance(name))
            << name.toStdString();
    }
}

TEST_F(SunByPlaceWindow, TheMapIsExportedAsPictureAndRasterAlsoOfASavedAnswer) {
    measure();
    const auto exported = [&](const char* name) {
        const std::filesystem::path out = folder.filePath(QString::fromLatin1(name)).toStdString();
        workbench().exportShown(out, {});
        EXPECT_TRUE(waitFor([&] { return !workbench().writing().busy(); }));
        return out;
    };
    const std::filesystem::path fresh = exported("fresh");
    const QImage picture(QString::fromStdString((fresh / "sun_by_place.png").string()));
    EXPECT_EQ(picture.width(), pictureWidth);
    std::set<QRgb> colours;
    for (int x = 0; x < picture.width(); x += 4)
        for (int y = 0; y < picture.height(); y += 4) colours.insert(picture.pixel(x, y));
    EXPECT_GT(colours.size(), 3U) << "it is not empty";
    EXPECT_TRUE(std::filesystem::exists(fresh / "sun_by_place.tif"));
    EXPECT_TRUE(std::filesystem::exists(fresh / "sun_by_place.qml"));
    keep("Sunny");
    workbench().showStudyAgain();
    showSaved("Sunny");
    EXPECT_TRUE(std::filesystem::exists(exported("saved") / "sun_by_place.png"));
}

// What the dialog exports has the colours of the view: sun, where the legend of studies shows shadow.
TEST_F(SunByPlaceWindow, TheExportedMapIsThatOfTheView) {
    measure();
    ExportChoice sun;
    sun.legend.show = ShownAs::sun;
    const auto pictureIn = [&](const char* name) {
        return QImage(folder.filePath(QString::fromLatin1(name) + QStringLiteral("/sun_by_place.png")));
    };
    const auto settle = [&] { ASSERT_TRUE(waitFor([&] { return !workbench().writing().busy(); })); };
    workbench().exportShown(folder.filePath(QStringLiteral("sun")).toStdString(), sun);
    settle();
    for (const QMenu* menu : window->menuBar()->findChildren<QMenu*>())
        for (QAction* action : menu->actions())
            if (action->shortcut() == QKeySequence(QStringLiteral("Ctrl+E"))) action->trigger();
    auto* dialog = window->findChild<ExportDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QLineEdit*>(QStringLiteral("exportFolder"))
        ->setText(folder.filePath(QStringLiteral("shown")));
    dialog->findChild<QPushButton*>(QStringLiteral("exportWrite"))->click();
    settle();
    ASSERT_FALSE(pictureIn("shown").isNull());
    EXPECT_EQ(pictureIn("shown"), pictureIn("sun"));
}

TEST_F(SunByPlaceWindow, OwnRegionsCountAsPlacesOnceTheyAreTicked) {
    Project next = session().project();
    next.regions = {{"Our block", {test::square({-60, -40}, 30)}}};
    ASSERT_TRUE(session().change(std::move(next), QStringLiteral("region")));
    auto& kinds = field<QListWidget>("placeKinds");
    ASSERT_EQ(kinds.count(), 4);
    EXPECT_EQ(kinds.item(3)->checkState(), Qt::Unchecked);
    kinds.setCurrentRow(3);
    QTest::keyClick(&kinds, Qt::Key_Space);
    measure();
    ASSERT_EQ(sun()->baseline.places.size(), 6U);
    EXPECT_EQ(sun()->baseline.places.back().name, "Our block");
}

TEST_F(SunByPlaceWindow, PiecesWithoutANameStandBelowTheirParkOrTheirKind) {
    measure();
    EXPECT_EQ(rows(), (QStringList{"North Park", "Green", "Main Street", "Parks without a name (1)"}));
    EXPECT_EQ(rows(table().model()->index(0, 0)), QStringList{"park (OSM way 7)"});
    field<QCheckBox>("placesGrouped").click();
    EXPECT_EQ(rows(), (QStringList{"Parks (2)", "Lawns and beds (1)", "Streets (1)"}))
        << "a lawn of North Park is in it already";
    const auto valueOf = [&](std::size_t place, int column) {
        const QModelIndex source = dock().model().indexOf(place);
        return dock().model().valueAt(source.siblingAtColumn(PlaceSunModel::firstFigure + column));
    };
    // Of mean, least and most sun, the first three figures, a row above has the mean by area, the least and
    // the most of the two parks.
    const auto above = [&](int column) {
        return table()
            .model()
            ->index(0, PlaceSunModel::firstFigure + column)
            .data(PlaceSunModel::valueRole)
            .toDouble();
    };
    const auto& sunOf = shownCity(*sun()).sun;
    const double areas = sunOf[0].areaM2 + sunOf[2].areaM2;
    EXPECT_NEAR(above(0), (valueOf(0, 0) * sunOf[0].areaM2 + valueOf(2, 0) * sunOf[2].areaM2) / areas, 1e-9);
    EXPECT_EQ(above(1), std::min(valueOf(0, 1), valueOf(2, 1)));
    EXPECT_EQ(above(2), std::max(valueOf(0, 2), valueOf(2, 2)));
    auto& text = field<QLineEdit>("placesFilter");
    QTest::keyClicks(&text, QStringLiteral("main"));
    EXPECT_EQ(rows(), QStringList{"Streets (1)"});
    text.clear();
    field<QComboBox>("placesKind").setCurrentIndex(2);
    EXPECT_EQ(rows(), QStringList{"Lawns and beds (1)"});
    EXPECT_EQ(textOf("placesListed"), QStringLiteral("1 of 5 places listed"));
    EXPECT_TRUE(count().startsWith(QStringLiteral("Lawns and beds: "))) << count().toStdString();
    EXPECT_TRUE(count().contains(QStringLiteral(" of 1 "))) << count().toStdString();
}

TEST_F(SunByPlaceWindow, ColumnsSortByTheirNumbers) {
    measure();
    table().model()->sort(PlaceSunModel::firstFigure, Qt::DescendingOrder);
    double last = 24;
    for (int row = 0; row < table().model()->rowCount(); ++row) {
        const double hours =
            table().model()->index(row, PlaceSunModel::firstFigure).data(PlaceSunModel::valueRole).toDouble();
        EXPECT_LE(hours, last);
        last = hours;
    }
    EXPECT_TRUE(makeTableText(*table().model()).contains(QStringLiteral("Main Street")))
        << "it can be copied";
}

TEST_F(SunByPlaceWindow, ARowShowsItsPlaceAndAPlaceInTheViewSelectsItsRow) {
    measure();
    const CameraPose before = window->panel().view().pose();
    Q_EMIT dock().goToRequested(0);
    EXPECT_NE(window->panel().view().pose().target, before.target) << "it zooms to the place";
    const CityView& view = window->panel().view();
    const auto pixel = pixelOf(view.pose(), view.lens(), {-5, 80, 0});
    ASSERT_TRUE(pixel);
    Q_EMIT window->panel().navigator().clicked(QPointF(pixel->x, pixel->y));
    EXPECT_EQ(table().currentIndex().data().toString(), QStringLiteral("North Park"));
}

TEST_F(SunByPlaceWindow, AScenarioIsSetAgainstItsBaseline) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([&] { return !workbench().following().busy() && !workbench().running().busy(); }));
    measure();
    ASSERT_EQ(sun()->compared.size(), 1U);
    EXPECT_EQ(sun()->compared[0].sun.name, "Tower");
    auto& shown = field<QComboBox>("placesShown");
    shown.setCurrentIndex(shown.count() - 1);
    EXPECT_EQ(shown.currentText(), QStringLiteral("Change"));
    EXPECT_EQ(window->panel().legend().legend()->title, QStringLiteral("Change of sun by place"));
    EXPECT_TRUE(count().contains(QStringLiteral("lose more than a minute"))) << count().toStdString();
    QStringList hours;
    for (int column = 0; column < table().model()->columnCount(); ++column) {
        const QString heading = table().model()->headerData(column, Qt::Horizontal).toString();
        if (heading.startsWith(QStringLiteral("Change")) && heading.endsWith(QStringLiteral(", h")))
            hours << heading;
    }
    EXPECT_TRUE(hours.isEmpty()) << "a change is told in minutes throughout: "
                                 << hours.join(u' ').toStdString();
}

TEST_F(SunByPlaceWindow, TheTableHasTheChangeOnEachDate) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([&] { return !workbench().following().busy() && !workbench().running().busy(); }));
    measure();
    const PlaceSunModel& model = dock().model();
    int change = 0;
    while (change < model.columnCount({}) &&
           model.headerData(change, Qt::Horizontal, Qt::DisplayRole) != QStringLiteral("21 Dec: change, min"))
        ++change;
    ASSERT_LT(change, model.columnCount({}));
    const double minutes =
        60 * (sun()->compared[0].sun.sun[0].dateHours[0] - sun()->baseline.sun[0].dateHours[0]);
    EXPECT_LT(minutes, 0) << "the tower takes sun from the park in winter";
    EXPECT_EQ(model.indexOf(0).siblingAtColumn(change).data().toString(), groupDigits(minutes, 1));
}

TEST_F(SunByPlaceWindow, AllScenariosAreMeasuredSideBySide) {
    auto& all = field<QCheckBox>("placesAllScenarios");
    EXPECT_TRUE(all.isHidden()) << "two scenarios are compared without it";
    ASSERT_TRUE(session().change(withScenario(session().project(), "Copy", "Tower"), QStringLiteral("copy")));
    EXPECT_FALSE(all.isHidden());
    EXPECT_FALSE(all.isEnabled()) << "no baseline is chosen";
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([&] { return !workbench().following().busy() && !workbench().running().busy(); }));
    ASSERT_TRUE(all.isEnabled());
    all.setChecked(true);
    measure();
    ASSERT_EQ(sun()->compared.size(), 2U);
    EXPECT_EQ(sun()->compared[0].sun.name, "Copy");
    EXPECT_EQ(sun()->compared[1].sun.name, "Tower") << "the displayed one is what table and map show";
    EXPECT_EQ(sun()->compared[0].changes[0].meanHours, sun()->compared[1].changes[0].meanHours);
    EXPECT_EQ(workbench().answer()->page({}).charts.size(), 4U);
    keep("All");
    showSaved("All");
    ASSERT_EQ(sun()->compared.size(), 2U);
    EXPECT_EQ(sun()->compared[1].sun.name, "Tower");
}

TEST_F(SunByPlaceWindow, TheLegendStatesTheErrorOfWhatIsColoured) {
    measure();
    const auto errorOf = [&](const char* quantity) {
        const auto& errors = sun()->baseline.errors;
        const auto at =
            std::ranges::find(errors, quantity, [](const ShownError& error) { return error.facts.key; });
        return at == errors.end() ? QStringLiteral("none") : sentenceText(describe(*at));
    };
    EXPECT_TRUE(dock().view()->note.endsWith(errorOf("place_mean"))) << dock().view()->note.toStdString();
    field<QComboBox>("placesShown").setCurrentIndex(1);
    EXPECT_TRUE(dock().view()->note.endsWith(errorOf("place_date"))) << dock().view()->note.toStdString();
}

TEST_F(SunByPlaceWindow, AChosenPlaceShowsWhoShadesItAlsoWhenSavedAndReopened) {
    measure();
    auto& contributions = *window->findChild<ContributionsDock*>();
    const auto shownFor = [&](const char* name) {
        return contributions.subject() == name && !contributions.model().sheet().rows.empty();
    };
    const auto& places = sun()->baseline.places;
    const auto park = std::ranges::find(places, "North Park", &Place::name) - places.begin();
    dock().select(std::size_t(park));
    QTest::mouseClick(&field<QPushButton>("placeContributors"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return shownFor("North Park"); }));
    ASSERT_EQ(workbench().answer()->ofPlaces().size(), 1U);
    const ContributionTable kept = workbench().answer()->ofPlaces().front();
    EXPECT_GT(kept.rows.front().attributedMinM2, 0);
    EXPECT_TRUE(sun()) << "the answer stays";
    keep("Sunny");
    workbench().showStudyAgain();
    showSaved("Sunny");
    ASSERT_EQ(workbench().answer()->ofPlaces().size(), 1U);
    EXPECT_EQ(workbench().answer()->ofPlaces().front().rows.front().id, kept.rows.front().id);
    EXPECT_EQ(workbench().answer()->ofPlaces().front().period, kept.period);
    EXPECT_TRUE(shownFor("North Park"));
    EXPECT_TRUE(workbench().filesOf({}).contains(QStringLiteral("contributions_of_places.csv")));
}

TEST_F(SunByPlaceWindow, ASavedAnswerComesBack) {
    measure();
    const auto measured = sun();
    keep("Sunny");
    workbench().showStudyAgain();
    EXPECT_FALSE(window->panel().results().showsPlaces()) << "another answer is in front";
    showSaved("Sunny");
    ASSERT_TRUE(sun());
    ASSERT_EQ(sun()->baseline.places, measured->baseline.places);
    EXPECT_NEAR(sun()->baseline.sun[0].meanHours, measured->baseline.sun[0].meanHours, 1e-4);
    EXPECT_FALSE(dock().view()->marked);
    EXPECT_EQ(window->panel().legend().legend()->title, QStringLiteral("Sun by place"));
}

TEST_F(SunByPlaceWindow, WhileTheStudyIsShownThePlacesAreSetAside) {
    study();
    measure();
    const auto measured = sun();
    workbench().showStudyAgain();
    EXPECT_EQ(sun(), measured) << "the table stays";
    EXPECT_FALSE(window->panel().results().showsPlaces());
    EXPECT_FALSE(field<QSlider>("placesSlider").isEnabled()) << "the answer states its threshold";
    QTest::mouseClick(&field<QPushButton>("placesReturn"), Qt::LeftButton);
    EXPECT_EQ(sunOf(workbench().answer()), measured);
    EXPECT_TRUE(window->panel().results().showsPlaces());
    EXPECT_FALSE(field<QPushButton>("placesReturn").isVisibleTo(&dock()));
    EXPECT_TRUE(field<QSlider>("placesSlider").isEnabled());
}

TEST_F(SunByPlaceWindow, MeasuringAllScenariosLeavesThePlacesInFront) {
    measure();
    chooseDays(1);
    workbench().measureAll();
    ASSERT_TRUE(waitFor([&] { return workbench().measuredScenarios().size() == 2; }));
    EXPECT_TRUE(sunOf(workbench().answer()));
}

TEST_F(SunByPlaceWindow, MeasureAllMeasuresThePlacesThatAreAskedFor) {
    chooseDays(40);
    QTest::mouseClick(&field<QPushButton>("measureAll"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return sun() != nullptr; })) << window->panel().messages().text().toStdString();
    ASSERT_EQ(sun()->compared.size(), 1U);
    EXPECT_EQ(sun()->baseline.name, existingCity);
    EXPECT_EQ(sun()->compared[0].sun.name, "Tower");
    EXPECT_EQ(session().scenario(), "Tower");
}

// In the table of scenarios: values and months of the places, also in another session.
TEST_F(SunByPlaceWindow, TheTableOfScenariosHasTheSunOfTheirPlaces) {
    const ScenarioTable& scenarios = window->findChild<ScenariosDock*>()->table();
    const auto shown = [&](int row, std::string_view key) {
        return scenarios.index(row, scenarioColumn(key)).data().toString();
    };
    EXPECT_EQ(shown(0, "hours_mean"), QStringLiteral("not measured"));
    QTest::mouseClick(&field<QPushButton>("measureAll"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return sun() != nullptr; }));
    const double before = averagePlaces(sun()->baseline).meanHours;
    const double after = averagePlaces(sun()->compared[0].sun).meanHours;
    EXPECT_GT(before, after) << "the tower takes sun";
    EXPECT_EQ(shown(0, "hours_mean"), QString::number(before, 'f', 2));
    EXPECT_EQ(shown(1, "hours_mean"), QString::number(after, 'f', 2));
    EXPECT_NE(shown(1, "share_enough"), QStringLiteral("not measured"));
    const std::vector<MonthChart> charts = makeMonthCharts(scenarios.months());
    ASSERT_EQ(charts.size(), 1U);
    EXPECT_EQ(charts[0].key, "places_sun_hours");
    ASSERT_EQ(charts[0].values.series.size(), 2U);
    EXPECT_EQ(charts[0].values.groups.size(), sun()->baseline.months.size());
    EXPECT_LT(charts[0].changes.groups[0].values[0], 0);
    const QString saved = shown(1, "hours_mean");
    window->saving().save();
    ASSERT_TRUE(waitFor([&] { return !window->saving().writing().busy(); }));
    const auto city = workbench().city();
    window->open({QString::fromStdString(session().file()->path().string())});
    ASSERT_TRUE(waitFor([&] { return workbench().city() != city && shown(1, "hours_mean") == saved; }));
    EXPECT_EQ(makeMonthCharts(scenarios.months()).size(), 1U);
}

TEST_F(SunByPlaceWindow, AnEditOfAThirdScenarioMarksWhatWasMeasuredOfAll) {
    ASSERT_TRUE(session().change(withScenario(session().project(), "Copy", "Tower"), QStringLiteral("copy")));
    QTest::mouseClick(&field<QPushButton>("measureAll"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return sun() && sun()->compared.size() == 2; }));
    const std::string third = sun()->compared[0].sun.name;
    const auto measured = workbench().measuredShown();
    ASSERT_TRUE(measured);
    EXPECT_FALSE(workbench().isOutdated(*measured));
    Project next = session().project();
    for (Scenario& scenario : next.scenarios)
        if (scenario.name == third) scenario.edits.push_back(test::newTower("Third", 50));
    ASSERT_TRUE(session().change(std::move(next), QStringLiteral("edit")));
    EXPECT_TRUE(workbench().isOutdated(*measured));
}

TEST_F(SunByPlaceWindow, SideBySideEachScenarioHasItsOwnPlaces) {
    QTest::mouseClick(&field<QPushButton>("measureAll"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return sun() != nullptr; }));
    window->comparing().findChild<QAction*>(QStringLiteral("compareBeside"))->trigger();
    const ResultLayer& layer = window->panel().results();
    ASSERT_TRUE(waitFor([&] { return window->panel().view().sides().layout == SideLayout::beside; }));
    EXPECT_TRUE(layer.missingSides().empty());
    const auto before = dock().view()->in(existingCity);
    ASSERT_TRUE(before);
    const glm::dvec2 park{-10, 60};
    EXPECT_NE(before->describe(park), dock().view()->describe(park)) << "the tower shades it";
    field<QComboBox>("placesShown").setCurrentText(QStringLiteral("Change"));
    EXPECT_EQ(layer.missingSides(), std::vector<std::string>{existingCity}) << "a baseline has no change";
    const Pick inPark{.position = {park, 0}};
    EXPECT_FALSE(layer.minutesAt(inPark).isEmpty());
    EXPECT_TRUE(layer.minutesAt(inPark, true).isEmpty()) << "nothing is shown there";
}

TEST_F(SunByPlaceWindow, TheDateThatIsShownStaysWithTheNextRun) {
    measure();
    auto& shown = field<QComboBox>("placesShown");
    shown.setCurrentIndex(1);
    field<QCheckBox>("placesOnlyBelow").setChecked(true);
    measure();
    EXPECT_EQ(shown.currentIndex(), 1);
    EXPECT_TRUE(field<QCheckBox>("placesOnlyBelow").isChecked());
}

TEST_F(SunByPlaceWindow, WhoShadesAPlaceIsOfTheDateThatIsShown) {
    measure();
    auto& contributions = *window->findChild<ContributionsDock*>();
    const auto& places = sun()->baseline.places;
    dock().select(std::size_t(std::ranges::find(places, "North Park", &Place::name) - places.begin()));
    field<QComboBox>("placesShown").setCurrentIndex(1);
    QTest::mouseClick(&field<QPushButton>("placeContributors"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return !contributions.model().sheet().rows.empty(); }));
    const SunByPlaceSettings& settings = sun()->baseline.settings;
    const ContributionTable kept = workbench().answer()->ofPlaces().front();
    EXPECT_EQ(kept.period, statePeriod(periodOf(settings, settings.dates[0])));
    field<QComboBox>("placesShown").setCurrentIndex(0);
    ASSERT_TRUE(waitFor([&] { return workbench().answer()->ofPlaces().size() == 2; }))
        << "of the period, too";
    EXPECT_EQ(workbench().answer()->ofPlaces().back().period, statePeriod(settings.study.period));
}

// Without another result there is nothing to return to: the list has the hidden one all the same.
TEST_F(SunByPlaceWindow, AHiddenAnswerIsInTheListOfAnswers) {
    measure();
    workbench().showStudyAgain();
    auto& list = field<QComboBox>("answers");
    ASSERT_EQ(list.count(), 1);
    EXPECT_FALSE(list.isHidden());
    EXPECT_EQ(list.currentIndex(), -1);
    Q_EMIT list.activated(0);
    EXPECT_TRUE(window->panel().results().showsPlaces());
}

// Its cells are not saved: the map and the count follow the threshold, shares of the area cannot.
TEST_F(SunByPlaceWindow, ASavedAnswerSaysWhichThresholdItsSharesAreFor) {
    measure();
    keep("Sunny");
    const auto* below = dock().findChild<QLabel*>(QStringLiteral("placesBelow"));
    auto* threshold = dock().findChild<QDoubleSpinBox*>(QStringLiteral("placesThreshold"));
    ASSERT_TRUE(below && threshold);
    threshold->setValue(threshold->value() + 1);
    EXPECT_FALSE(below->text().contains(QStringLiteral("as they were saved"))) << "its cells are known";
    workbench().showStudyAgain();
    showSaved("Sunny");
    EXPECT_FALSE(below->text().contains(QStringLiteral("as they were saved")));
    threshold->setValue(threshold->value() + 1);
    EXPECT_TRUE(below->text().contains(QStringLiteral("as they were saved")));
}

TEST_F(SunByPlaceWindow, APlaceThatIsRenamedMarksTheAnswerAsOutdated) {
    measure();
    ASSERT_TRUE(dock().view());
    EXPECT_FALSE(dock().view()->marked);
    ASSERT_TRUE(session().rename(ProjectPart::place, "North Park", "Our park"));
    EXPECT_TRUE(dock().view()->marked);
    EXPECT_TRUE(note().contains(QStringLiteral("places have changed"))) << note().toStdString();
    workbench().document().undoStack().undo();
    EXPECT_FALSE(dock().view()->marked);
}

TEST_F(SunByPlaceWindow, AnEditMarksTheAnswerAsOutdated) {
    measure();
    ASSERT_TRUE(session().addEdits({test::newTower("Other", 50)}, QStringLiteral("tower")));
    ASSERT_TRUE(waitFor([&] { return !workbench().following().busy(); }));
    ASSERT_TRUE(dock().view());
    EXPECT_TRUE(dock().view()->marked);
}

// Without its trees nothing would have changed.
TEST_F(SunByPlaceWindow, AScenarioThatPlantsTreesIsShownWithThem) {
    Tree oak = completeTree({.sourceId = "oak", .species = "Quercus", .heightM = 20, .crownDiameterM = 20});
    oak.place = {-10, 60};
    session().goTo(existingCity);
    ASSERT_TRUE(session().addEdits({PlantTree{oak}}, QStringLiteral("plant")));
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([&] { return !workbench().following().busy() && !workbench().running().busy(); }));
    measure();
    ASSERT_EQ(sun()->compared.size(), 1U);
    EXPECT_EQ(field<QComboBox>("placesTrees").currentData().toInt(), int(TreeColumns::seasonal));
    EXPECT_TRUE(count().endsWith(QStringLiteral("with their seasons"))) << count().toStdString();
}

TEST_F(SunByPlaceWindow, HeadlineTableAndMapCountTreesByChoice) {
    auto& trees = field<QComboBox>("placesTrees");
    measure();
    EXPECT_TRUE(trees.isHidden()) << "the city has none";
    EXPECT_FALSE(count().contains(QStringLiteral("trees")));
    Project next = session().project();
    City city = *next.city;
    Tree oak = completeTree({.sourceId = "oak", .species = "Quercus", .heightM = 20, .crownDiameterM = 20});
    oak.place = {-10, 60};
    city.trees = std::make_shared<const Trees>(Trees{.trees = {oak}, .leafDays = {300, 301}});
    next.city = std::make_shared<const City>(std::move(city));
    ASSERT_TRUE(session().change(std::move(next), QStringLiteral("trees")));
    ASSERT_TRUE(waitFor([&] { return workbench().city()->city().trees != nullptr; }));
    measure();
    ASSERT_EQ(trees.count(), 3);
    EXPECT_FALSE(trees.isHidden());
    const double open = sun()->baseline.sun[0].meanHours;
    EXPECT_TRUE(count().endsWith(QStringLiteral(", without trees"))) << count().toStdString();
    const auto before = dock().view();
    trees.setCurrentIndex(1);
    const double inLeaf = sun()->baseline.sun[0].meanHours;
    EXPECT_LT(inLeaf, open);
    EXPECT_TRUE(count().endsWith(QStringLiteral(", trees as evergreens"))) << count().toStdString();
    EXPECT_NE(dock().view(), before);
    trees.setCurrentIndex(2);
    EXPECT_GT(sun()->baseline.sun[0].meanHours, inLeaf) << "bare all year but a day";
    EXPECT_LT(sun()->baseline.sun[0].meanHours, open);
    field<QDoubleSpinBox>("placesThreshold").setValue(7);
    ASSERT_TRUE(waitFor([&] { return sun()->baseline.settings.enoughHours == 7; }));
    EXPECT_EQ(trees.currentIndex(), 2) << "the answer that follows the threshold keeps the column";
    trees.setCurrentIndex(0);
    EXPECT_EQ(sun()->baseline.sun[0].meanHours, open);
}

}  // namespace
}  // namespace noonmark
