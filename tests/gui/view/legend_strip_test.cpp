#include "app/gui/view/panel/legend_strip.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include "app/gui/view/panel/legend_editor.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

const QString note = QStringLiteral(
    "With the proposal: all 175,200 steps, within 0.25° of azimuth; continuous shadow follows. Shape of 0.6 "
    "s "
    "ago");

TEST(LegendStrip, NoteAndLegendHaveRoomOfTheirOwnAtEveryWidth) {
    LegendStrip strip;
    // A window server may restore an earlier size when it answers late.
    strip.setAttribute(Qt::WA_DontShowOnScreen);
    strip.show();
    for (int width = 320; width <= 1800; width += 20) {
        strip.resize(width, strip.height());
        QCoreApplication::processEvents();
        strip.setNote(note, width % 40 == 0);
        const QRectF legend = strip.legendArea(), words = strip.noteArea();
        ASSERT_FALSE(legend.intersects(words)) << width;
        ASSERT_GE(legend.width(), 200) << width;
        ASSERT_TRUE(QRectF(strip.rect()).contains(legend)) << width;
        ASSERT_TRUE(QRectF(strip.rect()).contains(words)) << width;
        ASSERT_TRUE(width < 400 || words.width() >= 100) << "room for a word, at " << width;
        ASSERT_GE(words.left(), 190) << "beside the measure, at " << width;
        ASSERT_EQ(strip.toolTip(), strip.paintedNote() == note ? QString() : note) << width;
    }
    EXPECT_EQ(strip.paintedNote(), note) << "a wide strip shows all of it";
    strip.resize(330, strip.height());
    QCoreApplication::processEvents();
    EXPECT_TRUE(strip.paintedNote().endsWith(QChar(0x2026))) << strip.paintedNote().toStdString();
    strip.setNote({}, false);
    EXPECT_TRUE(strip.noteArea().isEmpty());
    EXPECT_EQ(strip.toolTip(), QString());
}

Legend legendOf(const LegendChoice& choice) {
    return makeLegend(ShadowMeasure::gross, choice, 600, 600, std::vector<float>{0, 60, 300, 600});
}

TEST(LegendStrip, SwitchesBetweenShadowAndSunAndBack) {
    LegendStrip strip;
    strip.setLegend(legendOf({}));
    strip.findChild<QToolButton*>(QStringLiteral("showSun"))->click();
    EXPECT_EQ(strip.choice().show, ShownAs::sun);
    strip.undoChoice();
    EXPECT_EQ(strip.choice().show, ShownAs::shadow);
    EXPECT_TRUE(strip.findChild<QToolButton*>(QStringLiteral("showShadow"))->isChecked());
}

TEST(LegendStrip, AClickOnTheLegendOpensItsEditorAndUndoTakesChangesBack) {
    LegendStrip strip;
    strip.resize(1000, strip.height());
    strip.setLegend(legendOf({}));
    QTest::mouseClick(&strip, Qt::LeftButton, {}, strip.legendArea().center().toPoint());
    auto* editor = strip.findChild<LegendEditor*>();
    ASSERT_TRUE(editor);
    EXPECT_TRUE(editor->isVisible());
    editor->findChild<QComboBox*>(QStringLiteral("legendRamp"))->setCurrentIndex(int(Ramp::viridis));
    EXPECT_EQ(strip.choice().ramp, Ramp::viridis);
    editor->findChild<QCheckBox*>(QStringLiteral("legendLocked"))->click();
    EXPECT_EQ(strip.choice().range, (LegendRange{0, 600}));
    editor->findChild<QComboBox*>(QStringLiteral("legendClasses"))
        ->setCurrentIndex(int(LegendClasses::Kind::breaks));
    EXPECT_EQ(strip.choice().classes, LegendClasses()) << "no numbers yet: the map keeps its colours";
    auto* breaks = editor->findChild<QLineEdit*>(QStringLiteral("legendBreaks"));
    QTest::keyClicks(breaks, QStringLiteral("120"));
    QTest::keyClick(breaks, Qt::Key_Return);
    EXPECT_EQ(strip.choice().classes.breaks, std::vector<double>{120});
    for (int i = 0; i < 3; ++i) strip.undoChoice();
    EXPECT_EQ(strip.choice(), LegendChoice());
    EXPECT_FALSE(editor->findChild<QPushButton*>(QStringLiteral("legendUndo"))->isEnabled());
}

TEST(LegendStrip, HasTheKeysAgainWhenItsEditorCloses) {
    QWidget window;
    auto* strip = new LegendStrip(&window);
    window.resize(1000, 200);
    strip->resize(1000, strip->height());
    strip->setLegend(legendOf({}));
    window.show();
    strip->edit();
    auto* editor = strip->findChild<LegendEditor*>();
    ASSERT_TRUE(test::waitFor([&] { return editor->isActiveWindow(); }));
    editor->findChild<QPushButton*>(QStringLiteral("legendClose"))->click();
    EXPECT_TRUE(test::waitFor([&] { return window.isActiveWindow() && strip->hasFocus(); }));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_TRUE(editor->isVisible()) << "Enter opens it again";
}

}  // namespace
}  // namespace noonmark
