#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QToolButton>
#include <algorithm>

#include "app/gui/base/looks/units.h"
#include "app/gui/docks/study_form/accuracy_section.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/docks/study_form/when_form.h"
#include "app/gui/session/study/run_estimate.h"
#include "app/gui/session/study/study_document.h"
#include "app/language/language.h"
#include "core/review/library/rule_library.h"
#include "tests/gui/small_city.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using namespace std::chrono_literals;
using std::chrono::December;
using std::chrono::January;
using std::chrono::June;
using std::chrono::October;
using test::waitFor;

constexpr CivilDate anyDay{2026y, std::chrono::August, 3d};

Period inLeapYear() { return {.start = {2028y, std::chrono::May, 4d}, .days = 3, .from = 8h, .hours = 4}; }

TEST(PeriodForm, HoldsTheHoursFromSunriseToSunset) {
    PeriodForm form;
    Period period = inLeapYear();
    period.window = SolarHours{90min, 45min, SunriseRule::centre};
    form.show(period);
    EXPECT_EQ(form.period().window, period.window);
    const auto isShown = [&](const char* name) {
        return form.findChild<QWidget*>(QLatin1String(name))->isVisibleTo(&form);
    };
    EXPECT_TRUE(isShown("afterSunrise"));
    EXPECT_FALSE(isShown("from"));
    const QSignalSpy edited(&form, &PeriodForm::edited);
    form.findChild<QDoubleSpinBox*>(QStringLiteral("afterSunrise"))->setValue(2);
    EXPECT_EQ(edited.count(), 1);
    EXPECT_EQ(form.period().window->afterSunrise, 2h);
    form.show(inLeapYear());
    EXPECT_EQ(form.period(), inLeapYear());
    EXPECT_TRUE(isShown("from"));
}

TEST(PeriodPresets, SetTheDaysAndLeaveTheHours) {
    const Period year = withPresetDays(PeriodPreset::year, inLeapYear(), anyDay, 40);
    EXPECT_EQ(year.start, CivilDate(2028y, January, 1d));
    EXPECT_EQ(year.days, 366);
    EXPECT_EQ(year.from, 8h);
    EXPECT_EQ(year.hours, 4);
    EXPECT_EQ(withPresetDays(PeriodPreset::today, inLeapYear(), anyDay, 40).start, anyDay);
    EXPECT_EQ(withPresetDays(PeriodPreset::december, inLeapYear(), anyDay, 40).start,
              CivilDate(2028y, December, 21d));
    EXPECT_EQ(withPresetDays(PeriodPreset::own, inLeapYear(), anyDay, 40), inLeapYear());
}

TEST(PeriodPresets, TheGrowingSeasonIsThatOfTheHemisphere) {
    EXPECT_EQ(withPresetDays(PeriodPreset::growingSeason, inLeapYear(), anyDay, 40).days, 214)
        << "April to October";
    const Period south = withPresetDays(PeriodPreset::growingSeason, inLeapYear(), anyDay, -34);
    EXPECT_EQ(south.start, CivilDate(2028y, October, 1d));
    EXPECT_EQ(south.days, 212) << "October to April 2029";
    EXPECT_TRUE(nameOf(PeriodPreset::growingSeason, -34).contains(QStringLiteral("October to April")));
}

TEST(PeriodPresets, AreFoundAgain) {
    for (const PeriodPreset preset : allPeriodPresets)
        EXPECT_EQ(presetOf(withPresetDays(preset, inLeapYear(), anyDay, 40), anyDay, 40), preset);
    EXPECT_EQ(presetOf(inLeapYear(), anyDay, 40), PeriodPreset::own);
}

TEST(RulePeriods, HaveTheDaysAndHoursOfTheRule) {
    const RuleLibrary library = RuleLibrary::load().value();
    const Rule boston = library.find("boston-article-80").value();
    const auto june = periodOf(boston, June / 21, inLeapYear());
    ASSERT_TRUE(june);
    EXPECT_EQ(june->start, CivilDate(2028y, June, 21d));
    EXPECT_EQ(june->days, 1);
    EXPECT_EQ(june->from, 9h);
    EXPECT_EQ(june->hours, 9) << "to 18:00 on that day, to 15:00 on others";
    EXPECT_EQ(periodOf(boston, December / 21, inLeapYear()).value().hours, 6);
    EXPECT_FALSE(periodOf(boston, inLeapYear())) << "it has fixed days, no range";
    const auto season = periodOf(library.find("russia-territory").value(), inLeapYear());
    ASSERT_TRUE(season);
    EXPECT_EQ(season->days, 123) << "22 April to 22 August";
    ASSERT_TRUE(season->window);
    EXPECT_EQ(season->window->afterSunrise, 0min);
}

TEST(RulePeriods, AreNotOfferedWhereAPeriodCannotStateThem) {
    const RuleLibrary library = RuleLibrary::load().value();
    const auto first = [&library](const char* key) {
        const Rule rule = library.find(key).value();
        return periodOf(rule, rule.days.fixed.front().day, inLeapYear());
    };
    EXPECT_FALSE(first("ceqr")) << "hours in standard time";
    EXPECT_FALSE(first("japan")) << "hours in true solar time";
    EXPECT_FALSE(first("zurich")) << "hours in standard time";
}

TEST(AccuracyChoices, NameTheEngineThatSuitsTheGround) {
    StudySettings settings;
    EXPECT_EQ(choiceOf(settings, false), AccuracyChoice::quick);
    EXPECT_EQ(withAccuracy(AccuracyChoice::exact, settings, false).engine, "projected");
    EXPECT_EQ(withAccuracy(AccuracyChoice::exact, settings, true).engine, "ray")
        << "polygons take no terrain";
    settings.receivers.places = ReceiverPlaces::roofs;
    EXPECT_EQ(withAccuracy(AccuracyChoice::exact, settings, false).engine, "ray");
    EXPECT_EQ(choiceOf(asInPaper(settings), false), AccuracyChoice::own);
    settings.engineSettings["bin"] = 1;
    EXPECT_EQ(choiceOf(settings, false), AccuracyChoice::own);
    EXPECT_TRUE(withAccuracy(AccuracyChoice::quick, settings, false).engineSettings.empty());
}

/// The dock with its document.
struct StudyForm : ::testing::Test {
    StudyDocument document;
    StudyDock dock{document};

    void choose(const char* list, int entry) {
        auto* combo = dock.findChild<QComboBox*>(QString::fromLatin1(list));
        combo->setCurrentIndex(entry);
        Q_EMIT combo->activated(entry);
    }
    [[nodiscard]] int chosen(const char* list) const {
        return dock.findChild<QComboBox*>(QString::fromLatin1(list))->currentIndex();
    }
};

TEST_F(StudyForm, AChoiceOfDaysIsOneUndoStepAndTheListFollows) {
    const auto year = int(std::ranges::find(allPeriodPresets, PeriodPreset::year) - allPeriodPresets.begin());
    const int before = chosen("periodPreset");
    choose("periodPreset", year);
    EXPECT_EQ(document.settings().period.days, 365);
    EXPECT_EQ(document.undoStack().count(), 1);
    document.undoStack().undo();
    EXPECT_EQ(document.settings(), StudySettings());
    EXPECT_EQ(chosen("periodPreset"), before);
}

TEST_F(StudyForm, TheAccuracyChoosesTheMethodThatIsFoldedAway) {
    choose("accuracy", int(AccuracyChoice::reference));
    EXPECT_EQ(document.settings().engine, "ray");
    EXPECT_EQ(chosen("engine"), 0);
    choose("engine", 1);
    EXPECT_EQ(chosen("accuracy"), int(AccuracyChoice::exact)) << "projected shadows";
    EXPECT_TRUE(dock.findChild<QComboBox*>(QStringLiteral("engine"))->isHidden() ||
                !dock.findChild<QComboBox*>(QStringLiteral("engine"))->isVisibleTo(&dock));
    dock.findChild<QToolButton*>(QStringLiteral("methodDetails"))->setChecked(true);
    EXPECT_TRUE(dock.findChild<QComboBox*>(QStringLiteral("engine"))->isVisibleTo(&dock));
}

TEST_F(StudyForm, SaysBeforeTheRunWhatIsUsedAndHowLongItTakes) {
    StudySettings settings;
    settings.region = {"around", {test::square({-120, -120}, 240)}};
    settings.receivers.cellM = 2;
    settings.period.zone = "America/New_York";
    document.reset(settings);
    dock.setCity(std::make_shared<const City>(test::smallCity()));
    ASSERT_TRUE(waitFor([this] { return dock.forecast().estimate().has_value(); }));
    const RunEstimate estimate = *dock.forecast().estimate();
    EXPECT_EQ(estimate.steps, 360) << "six hours by the minute";
    EXPECT_GT(estimate.receivers, 10000);
    EXPECT_LE(estimate.receivers, 14400) << "120 x 120 cells less the buildings";
    EXPECT_GT(estimate.seconds, 0);
    const auto* line = dock.findChild<QLabel*>(QStringLiteral("forecast"));
    EXPECT_TRUE(line->text().contains(QStringLiteral("360 positions of the sun")))
        << line->text().toStdString();
    EXPECT_TRUE(line->text().contains(QStringLiteral("about a second"))) << line->text().toStdString();
    document.change(asInPaper(settings), QStringLiteral("paper"));
    EXPECT_FALSE(dock.forecast().estimate()) << "of other settings";
    ASSERT_TRUE(waitFor([this] { return dock.forecast().estimate().has_value(); }));
    EXPECT_EQ(dock.forecast().estimate()->engine, QStringLiteral("Inverse accrual map"));
}

TEST_F(StudyForm, ScoresAndReviewsLeadToTheirPanels) {
    QSignalSpy kinds(&dock, &StudyDock::kindChosen), runs(&dock, &StudyDock::runRequested);
    choose("studyKind", int(StudyKind::review));
    ASSERT_EQ(kinds.count(), 1);
    dock.findChild<QPushButton*>(QStringLiteral("run"))->click();
    EXPECT_EQ(kinds.count(), 2);
    EXPECT_EQ(runs.count(), 0);
    choose("studyKind", int(StudyKind::shadow));
    dock.findChild<QPushButton*>(QStringLiteral("run"))->click();
    EXPECT_EQ(runs.count(), 1);
    dock.setComparing(true);
    EXPECT_EQ(chosen("studyKind"), int(StudyKind::change));
}

/// The form in other languages and units. Restores English and metres, which other tests expect.
struct StudyFormWidth : ::testing::TestWithParam<std::pair<Language, UnitSystem>> {
    void SetUp() override { use(GetParam().first, GetParam().second); }
    void TearDown() override { use(Language::english, UnitSystem::metric); }
    static void use(Language language, UnitSystem units) {
        applyLanguage(language, *qApp);
        applyUnits(units);
    }
};

// How far the form could be scrolled sideways where shadow is measured at this entry of the list.
int sidewaysPx(StudyDock& dock, int place) {
    auto* places = dock.findChild<QComboBox*>(QStringLiteral("places"));
    places->setCurrentIndex(place);
    Q_EMIT places->activated(place);
    auto* direction = dock.findChild<QComboBox*>(QStringLiteral("facingDirection"));
    if (direction->isVisible()) Q_EMIT direction->activated(direction->count() - 1);
    QCoreApplication::processEvents();
    const auto* scroll = dock.findChild<QScrollArea*>();
    return scroll->widget()->minimumSizeHint().width() - scroll->viewport()->width();
}

TEST_P(StudyFormWidth, IsThatOfTheDockWhereverShadowIsMeasured) {
    StudyDocument document;
    StudyDock dock(document);
    dock.resize(dock.sizeHint().width(), 500);
    dock.show();
    auto* places = dock.findChild<QComboBox*>(QStringLiteral("places"));
    ASSERT_GE(places->count(), 8);
    for (int place = 0; place < places->count(); ++place)
        for (const char* building : {"", "a building"}) {
            dock.setBuilding(QLatin1String(building));
            EXPECT_LE(sidewaysPx(dock, place), 0)
                << places->itemText(place).toStdString() << ", " << building;
        }
}

INSTANTIATE_TEST_SUITE_P(Languages, StudyFormWidth,
                         ::testing::Values(std::pair{Language::english, UnitSystem::metric},
                                           std::pair{Language::english, UnitSystem::imperial},
                                           std::pair{Language::german, UnitSystem::metric},
                                           std::pair{Language::spanish, UnitSystem::metric},
                                           std::pair{Language::japanese, UnitSystem::metric}));

}  // namespace
}  // namespace noonmark
