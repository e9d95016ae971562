#include "app/gui/frame/help/help_actions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QHelpEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBrowser>
#include <QWhatsThisClickedEvent>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/docks/export/movie_actions.h"
#include "app/gui/frame/help/guide_window.h"
#include "app/gui/frame/preferences/preferences_dialog.h"
#include "app/gui/session/study/open_options.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// The fields in a part of the window that say nothing of themselves.
QStringList silentFieldsOf(const QWidget& part) {
    QStringList silent;
    for (const QWidget* field : part.findChildren<QWidget*>())
        if (isField(*field) && describeField(*field).isEmpty() && field->toolTip().isEmpty())
            silent << QStringLiteral("%1 '%2'").arg(QString::fromLatin1(field->metaObject()->className()),
                                                    field->objectName());
    return silent;
}

struct FieldWindow : test::ProjectWindow {};

TEST_F(FieldWindow, EveryFieldOfEveryDockSaysWhatItIsFor) {
    build();
    window->tools().building().select(1);
    int fields = 0;
    for (const QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        EXPECT_EQ(silentFieldsOf(*dock->widget()).join(QStringLiteral(", ")).toStdString(), "")
            << dock->objectName().toStdString();
        for (const QWidget* field : dock->widget()->findChildren<QWidget*>())
            fields += isField(*field) ? 1 : 0;
    }
    EXPECT_GT(fields, 60);
    EXPECT_EQ(silentFieldsOf(window->panel()).join(QStringLiteral(", ")).toStdString(), "") << "bars";
}

TEST_F(FieldWindow, EveryFieldOfDialogsSaysWhatItIsFor) {
    const ReadingForm reading;
    EXPECT_EQ(silentFieldsOf(reading).join(QStringLiteral(", ")).toStdString(), "");
    window->preferences().action()->trigger();
    const auto* preferences = window->findChild<PreferencesDialog*>();
    ASSERT_NE(preferences, nullptr);
    for (const QComboBox* list : preferences->findChildren<QComboBox*>())
        EXPECT_THAT(describeField(*list).toStdString(), HasSubstr("guide:window#Preferences"));
}

TEST_F(FieldWindow, WhatsThisStatesLabelRangeAndGuide) {
    const auto* cell = window->findChild<QDoubleSpinBox*>(QStringLiteral("cell"));
    ASSERT_NE(cell, nullptr);
    const std::string text = describeField(*cell).toStdString();
    EXPECT_THAT(text, HasSubstr("<b>Cell size</b>"));
    EXPECT_THAT(text, HasSubstr("0.25 m to 10.00 m"));
    EXPECT_THAT(text, HasSubstr("guide:window#A study"));
}

TEST_F(FieldWindow, TheTextIsThereWhenItIsAskedForAndItsLinkOpensTheGuide) {
    auto* cell = window->findChild<QDoubleSpinBox*>(QStringLiteral("cell"));
    EXPECT_TRUE(cell->whatsThis().isEmpty());
    QHelpEvent ask(QEvent::QueryWhatsThis, {}, {});
    QCoreApplication::sendEvent(cell, &ask);
    EXPECT_FALSE(cell->whatsThis().isEmpty());
    QWhatsThisClickedEvent click(guideLink(findGuidePlace(cell)));
    QCoreApplication::sendEvent(cell, &click);
    auto* guide = window->findChild<GuideWindow*>();
    ASSERT_NE(guide, nullptr);
    EXPECT_EQ(guide->page(), QStringLiteral("window"));
}

TEST_F(FieldWindow, F1OpensTheGuideAtTheSectionOfTheFocusedDock) {
    const std::pair<const char*, const char*> pages[] = {{"resultsDock", "results"},
                                                         {"warningsDock", "data"},
                                                         {"buildingDock", "window"},
                                                         {"reviewDock", "window"}};
    for (const auto& [dock, page] : pages)
        EXPECT_EQ(findGuidePlace(window->findChild<QDockWidget*>(QLatin1String(dock))).page,
                  QLatin1String(page))
            << dock;
    GuideWindow& guide = window->help().showGuide(
        findGuidePlace(window->findChild<QDockWidget*>(QStringLiteral("reviewDock"))));
    EXPECT_TRUE(test::waitFor([&] { return guide.text().verticalScrollBar()->value() > 100; }))
        << "at the section, not at the beginning";
}

TEST(GuidePlaces, AllNameAPageAndAHeadingThatThereAre) {
    const char* const parts[] = {"studyDock",         "resultsDock",   "scenariosDock", "projectDock",
                                 "weightsDock",       "warningsDock",  "reviewDock",    "pointDock",
                                 "buildingDock",      "towerDock",     "modeBar",       "timeStrip",
                                 "contributionsDock", "reviewFormDock"};
    QWidget part;
    for (const char* name : parts) {
        part.setObjectName(QString::fromLatin1(name));
        const GuidePlace place = findGuidePlace(&part);
        QFile file(QStringLiteral(":/guide/user/%1.md").arg(place.page));
        ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << name;
        EXPECT_TRUE(place.section.isEmpty() ||
                    QString::fromUtf8(file.readAll()).contains(QStringLiteral("# %1\n").arg(place.section)))
            << name << ": " << place.section.toStdString();
        EXPECT_EQ(parseGuideLink(guideLink(place)).section, place.section);
    }
}

}  // namespace
}  // namespace noonmark
