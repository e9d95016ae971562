#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/sheets/sheet_form.h"
#include "app/gui/frame/help/start_page.h"
#include "app/gui/frame/preferences/preferences_dialog.h"
#include "app/language/language.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

struct PreferencesWindow : test::ProjectWindow {
    QPalette before = QApplication::palette();
    void TearDown() override {
        QApplication::setPalette(before);
        applyUnits(UnitSystem::metric);
    }
    PreferencesDialog* openDialog() {
        window->preferences().action()->trigger();
        return window->findChild<PreferencesDialog*>();
    }
    static void choose(const PreferencesDialog& dialog, const char* name, int value) {
        auto* list = dialog.findChild<QComboBox*>(QLatin1String(name));
        ASSERT_NE(list, nullptr) << name;
        list->setCurrentIndex(list->findData(value));
        EXPECT_EQ(list->currentData().toInt(), value) << name;
    }
    static void press(const PreferencesDialog& dialog, QDialogButtonBox::StandardButton button) {
        dialog.findChild<QDialogButtonBox*>()->button(button)->click();
    }
};

TEST_F(PreferencesWindow, AreSavedByTheFunctionsThatReadThem) {
    auto* dialog = openDialog();
    ASSERT_NE(dialog, nullptr);
    choose(*dialog, "preferredLanguage", int(Language::japanese));
    choose(*dialog, "preferredColours", int(ThemeChoice::dark));
    choose(*dialog, "preferredUnits", int(UnitSystem::imperial));
    choose(*dialog, "preferredPaper", int(Paper::a3));
    choose(*dialog, "preferredOrientation", 1);
    dialog->findChild<QCheckBox*>(QStringLiteral("preferredStart"))->setChecked(false);
    press(*dialog, QDialogButtonBox::Ok);
    EXPECT_EQ(readLanguage(settings), Language::japanese);
    EXPECT_EQ(readThemeChoice(settings), ThemeChoice::dark);
    EXPECT_EQ(themeInUse(), Theme::dark) << "colours apply at once";
    EXPECT_EQ(readUnits(settings), UnitSystem::imperial);
    EXPECT_EQ(readPageSetup(settings), (PageSetup{Paper::a3, true}));
    EXPECT_FALSE(readShowStart(settings));
}

TEST_F(PreferencesWindow, ACancelledDialogChangesNothing) {
    auto* dialog = openDialog();
    ASSERT_NE(dialog, nullptr);
    const auto theme = themeInUse();
    choose(*dialog, "preferredColours", int(ThemeChoice::dark));
    choose(*dialog, "preferredLanguage", int(Language::german));
    press(*dialog, QDialogButtonBox::Cancel);
    EXPECT_EQ(readLanguage(settings), Language::system);
    EXPECT_EQ(themeInUse(), theme);
    EXPECT_TRUE(readShowStart(settings)) << "at first it is shown";
}

TEST_F(PreferencesWindow, LengthsAndAreasAreShownInTheChosenUnits) {
    EXPECT_EQ(describeLength(100), QStringLiteral("100.0 m"));
    applyUnits(UnitSystem::imperial);
    EXPECT_EQ(describeLength(100), QStringLiteral("328.1 ft"));
    EXPECT_EQ(describeSmallArea(1000), QStringLiteral("10,764 sq ft"));
    applyUnits(UnitSystem::both);
    EXPECT_EQ(describeLength(100, 0), QStringLiteral("100 m (328 ft)"));
}

}  // namespace
}  // namespace noonmark
