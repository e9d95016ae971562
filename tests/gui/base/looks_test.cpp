#include "app/gui/base/looks/application_theme.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>
#include <QWindow>
#include <cmath>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/docks/review/verdict_table.h"
#include "app/report/maps/style.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::ProjectWindow;

/// Restores the palette of the application, which other tests share.
struct Themes : ::testing::Test {
    QPalette before = QApplication::palette();
    ~Themes() override { QApplication::setPalette(before); }
};

// WCAG 2: relative luminance and contrast.
double luminance(const QColor& colour) {
    const auto linear = [](double v) {
        return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}
double contrastOf(const QColor& a, const QColor& b) {
    const double high = std::max(luminance(a), luminance(b)), low = std::min(luminance(a), luminance(b));
    return (high + 0.05) / (low + 0.05);
}

/// The middle of a button as the window's style draws it.
QColor drawnMiddle(QAbstractButton& button, bool checked) {
    button.setCheckable(true);
    button.setChecked(checked);
    button.resize(80, 28);
    const QImage image = button.grab().toImage();
    return image.pixelColor(image.width() / 2, image.height() / 2);
}

TEST_F(Themes, AButtonThatIsPressedDiffersFromOthersInBothColours) {
    WindowStyle style;
    for (const Theme theme : {Theme::light, Theme::dark}) {
        QApplication::setPalette(makePalette(theme));
        QPushButton push;
        QToolButton tool;
        for (QAbstractButton* button : std::initializer_list<QAbstractButton*>{&push, &tool}) {
            button->setStyle(&style);
            EXPECT_GE(contrastOf(drawnMiddle(*button, true), drawnMiddle(*button, false)), 1.3)
                << int(theme) << button->metaObject()->className();
        }
    }
}

TEST_F(Themes, AreReadableInBothColours) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
        const QPalette palette = makePalette(theme);
        EXPECT_EQ(themeOf(palette), theme);
        for (const auto& [text, ground] :
             {std::pair{QPalette::WindowText, QPalette::Window}, std::pair{QPalette::Text, QPalette::Base},
              std::pair{QPalette::ButtonText, QPalette::Button}, std::pair{QPalette::Link, QPalette::Base},
              std::pair{QPalette::HighlightedText, QPalette::Highlight},
              std::pair{QPalette::PlaceholderText, QPalette::Base}})
            EXPECT_GE(contrastOf(palette.color(text), palette.color(ground)), 4.5)
                << int(theme) << ", role " << int(text);
        for (const NoteColours& colours : {noteColours(theme), errorColours(theme), warningColours(theme)})
            EXPECT_GE(contrastOf(colours.text, colours.background), 4.5);
    }
}

TEST_F(Themes, VerdictsAreReadableInBothColours) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
        QApplication::setPalette(makePalette(theme));
        const QColor base = QApplication::palette().color(QPalette::Base);
        for (const Verdict verdict :
             {Verdict::pass, Verdict::borderline, Verdict::fail, Verdict::notApplicable, Verdict::notChecked})
            EXPECT_GE(contrastOf(verdictColour(verdict), base), 4.5) << int(theme) << ' ' << int(verdict);
    }
}

TEST_F(Themes, LegendsAndChartsAreReadableInBothColours) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
        const Inks inks = inksOf(theme);
        for (const QColor& colour : {inks.text, inks.quiet}) EXPECT_GE(contrastOf(colour, inks.paper), 4.5);
        for (const QColor& colour : {shade::proposal, shade::incremental, shade::baseline}) {
            const QColor shown = readableOn(inks.paper, colour);
            EXPECT_GE(contrastOf(shown, inks.paper), 1.8) << int(theme) << ' ' << colour.name().toStdString();
            EXPECT_TRUE(theme == Theme::dark || shown == colour) << "as printed";
        }
        EXPECT_GE(contrastOf(readableOn(inks.paper, shade::proposal), inks.paper), 3) << "a thin line";
        // Sunlight gained is the yellow of sunlight; only areas, and on white as pale as printed.
        EXPECT_GE(contrastOf(readableOn(inks.paper, shade::gained), inks.paper), 1.3);
    }
}

TEST_F(Themes, TheChoiceOutlivesTheWindowAndBeatsTheSystem) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("settings.ini"));
    {
        QSettings settings(file, QSettings::IniFormat);
        EXPECT_EQ(readThemeChoice(settings), ThemeChoice::system);
        saveThemeChoice(ThemeChoice::dark, settings);
    }
    const QSettings settings(file, QSettings::IniFormat);
    EXPECT_EQ(readThemeChoice(settings), ThemeChoice::dark);
    applyTheme(ThemeChoice::dark, makePalette(Theme::light));
    EXPECT_EQ(themeInUse(), Theme::dark);
    applyTheme(ThemeChoice::system, makePalette(Theme::light));
    EXPECT_EQ(themeInUse(), Theme::light);
    applyTheme(ThemeChoice::system, QPalette(QColor(30, 30, 30)));
    EXPECT_EQ(themeInUse(), Theme::dark) << "a dark desktop of other colours";
}

TEST_F(Themes, WidgetsFollowWhileTheyAreShown) {
    applyTheme(ThemeChoice::light, {});
    QLabel label(QStringLiteral("Error"));
    showAsError(label);
    label.show();
    const QString light = label.styleSheet();
    applyTheme(ThemeChoice::dark, {});
    QCoreApplication::processEvents();
    EXPECT_NE(label.styleSheet(), light);
    applyTheme(ThemeChoice::light, {});
    QCoreApplication::processEvents();
    EXPECT_EQ(label.styleSheet(), light);
}

/// A desktop whose preference a test sets.
struct FakeDesktop final : ThemeSource {
    std::optional<Theme> preferred;
    [[nodiscard]] std::optional<Theme> theme() const override { return preferred; }
    void prefer(std::optional<Theme> theme) {
        preferred = theme;
        Q_EMIT changed();
    }
};

TEST_F(Themes, FollowTheDesktopWhileTheWindowIsOpenUnlessTheUserChose) {
    auto source = std::make_unique<FakeDesktop>();
    FakeDesktop& desktop = *source;
    ApplicationTheme theme(*qApp, ThemeChoice::system, makePalette(Theme::light), std::move(source));
    EXPECT_EQ(themeInUse(), Theme::light) << "by its palette, since the desktop states nothing";
    desktop.prefer(Theme::dark);
    EXPECT_EQ(themeInUse(), Theme::dark);
    theme.choose(ThemeChoice::light);
    EXPECT_EQ(themeInUse(), Theme::light);
    desktop.prefer(std::nullopt);
    desktop.prefer(Theme::dark);
    EXPECT_EQ(themeInUse(), Theme::light) << "the user's choice stays";
    theme.choose(ThemeChoice::system);
    EXPECT_EQ(themeInUse(), Theme::dark);
    desktop.prefer(std::nullopt);
    EXPECT_EQ(themeInUse(), Theme::light);
}

TEST_F(Themes, APaletteThatThePlatformChangesIsReadAgain) {
    // The palette at the start was dark; the platform of the test has a light one.
    ApplicationTheme theme(*qApp, ThemeChoice::system, makePalette(Theme::dark), nullptr);
    EXPECT_EQ(themeInUse(), Theme::dark);
    QWindow window;
    QEvent change(QEvent::ThemeChange);
    QCoreApplication::sendEvent(&window, &change);
    QCoreApplication::processEvents();
    EXPECT_EQ(themeInUse(), Theme::light);
}

TEST_F(Themes, CheckBoxesHaveAnOutlineOnDarkWindows) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
        applyTheme(theme == Theme::dark ? ThemeChoice::dark : ThemeChoice::light, {});
        QCheckBox box;
        box.resize(box.sizeHint());
        const QImage image = box.grab().toImage();
        const QColor window = box.palette().color(QPalette::Window);
        double maximum = 1;
        for (int x = 0; x < image.width() / 2; ++x)
            maximum = std::max(maximum, contrastOf(image.pixelColor(x, image.height() / 2), window));
        EXPECT_GE(maximum, theme == Theme::dark ? 3 : 1.5) << int(theme);
    }
}

TEST(WindowStyles, ButtonsOfDialogsHaveNoIcons) {
    const QDialogButtonBox buttons(QDialogButtonBox::Close | QDialogButtonBox::Cancel);
    for (const QAbstractButton* button : buttons.buttons()) EXPECT_TRUE(button->icon().isNull());
}

double meanLightness(const QImage& image) {
    double sum = 0;
    int seen = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (qAlpha(image.pixel(x, y)) > 200) {
                sum += qGray(image.pixel(x, y));
                ++seen;
            }
    return seen > 0 ? sum / seen : -1;
}

TEST_F(Themes, IconsHaveTheColourOfTheText) {
    const QIcon icon = makeIcon(QStringLiteral("save"));
    applyTheme(ThemeChoice::light, {});
    const double onLight = meanLightness(icon.pixmap(48).toImage());
    applyTheme(ThemeChoice::dark, {});
    const double onDark = meanLightness(icon.pixmap(48).toImage());
    EXPECT_GE(onLight, 0);
    EXPECT_LT(onLight, 80);
    EXPECT_GT(onDark, 180);
    const double off = meanLightness(icon.pixmap(QSize(48, 48), QIcon::Disabled).toImage());
    EXPECT_LT(off, onDark - 40) << "greyed";
}

TEST(Icons, AllArePicturesThatFitTheirSquare) {
    const QStringList names = QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")});
    EXPECT_GT(names.size(), 30);
    for (const QString& name : names) {
        const QImage image = makeIcon(name.chopped(4)).pixmap(48).toImage();
        int inside = 0, atEdge = 0;
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 48; ++x) {
                const bool edge = x == 0 || y == 0 || x == 47 || y == 47;
                (edge ? atEdge : inside) += qAlpha(image.pixel(x, y)) > 40 ? 1 : 0;
            }
        EXPECT_GT(inside, 60) << name.toStdString();
        EXPECT_EQ(atEdge, 0) << name.toStdString();
    }
    EXPECT_TRUE(makeIcon(QStringLiteral("none of them")).isNull());
}

TEST_F(ProjectWindow, EveryToolHasAnIconATipAndItsKey) {
    const auto* bar = window->findChild<QToolBar*>(QStringLiteral("toolBar"));
    ASSERT_NE(bar, nullptr);
    int tools = 0;
    for (const QAction* action : bar->actions()) {
        if (action->isSeparator()) continue;
        ++tools;
        EXPECT_FALSE(action->icon().isNull()) << action->text().toStdString();
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        EXPECT_TRUE(action->toolTip().contains(keys)) << action->toolTip().toStdString();
    }
    EXPECT_GE(tools, 8);
}

TEST(MessageBars, ShowTheFirstOfSeveralLinesAndTheOthersOnRequest) {
    MessageBar bar;
    bar.resize(600, 40);
    bar.showHelp(QStringLiteral("First line.\nSecond line.\nThird line."));
    const auto shows = [&bar](const char* words) {
        for (const QLabel* label : bar.findChildren<QLabel*>())
            if (label->text().contains(QLatin1String(words))) return true;
        return false;
    };
    auto* more = bar.findChild<QToolButton*>(QStringLiteral("messageMore"));
    EXPECT_TRUE(shows("First") && !shows("Second"));
    EXPECT_TRUE(bar.text().contains(QStringLiteral("Third"))) << "nothing is lost";
    more->click();
    EXPECT_TRUE(shows("Third"));
    more->click();
    EXPECT_FALSE(shows("Third"));
    bar.showHelp(QStringLiteral("One line."));
    EXPECT_TRUE(more->isHidden());
}

}  // namespace
}  // namespace noonmark
