#include "app/gui/view/panel/legend_strip.h"

#include <gtest/gtest.h>

#include <QCoreApplication>

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

}  // namespace
}  // namespace noonmark
