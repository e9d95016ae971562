#include "app/report/sheets/text_column.h"

#include <gtest/gtest.h>

#include <QImage>

namespace noonmark {
namespace {

/// A page with a column in its centre; everything outside the column must stay white.
class Page : public ::testing::Test {
protected:
    Page() : image_(600, 400, QImage::Format_RGB32), painter_(&image_) { image_.fill(Qt::white); }

    [[nodiscard]] int inkOutside() {
        int count = 0;
        for (int y = 0; y < image_.height(); ++y)
            for (int x = 0; x < image_.width(); ++x)
                if (!column_.contains(x, y) && image_.pixelColor(x, y) != QColor(Qt::white)) ++count;
        return count;
    }

    [[nodiscard]] int inkInside() {
        int count = 0;
        for (int y = int(column_.top()); y < int(column_.bottom()); ++y)
            for (int x = int(column_.left()); x < int(column_.right()); ++x)
                if (image_.pixelColor(x, y) != QColor(Qt::white)) ++count;
        return count;
    }

    QImage image_;
    QPainter painter_;
    Canvas canvas_{painter_, 2};
    QRectF column_{100, 80, 300, 200};
};

TEST_F(Page, LongTextAndLongWordsStayInTheColumn) {
    TextBlocks blocks{heading("A heading")};
    for (int i = 0; i < 20; ++i) blocks.push_back(body(QString(500, u'W') + " and words that go on and on"));
    blocks.push_back({TextKind::code, QString(3000, u'f')});
    const double bottom = paintBlocks(canvas_, blocks, column_, 8);
    EXPECT_EQ(inkOutside(), 0);
    EXPECT_GT(inkInside(), 1000);
    EXPECT_LE(bottom, column_.bottom() + 1e-3);
}

TEST_F(Page, ShortTextEndsWhereItsHeightSays) {
    const TextBlocks blocks{heading("A heading"), body("A line."), {TextKind::code, "noonmark-cli"}};
    const double bottom = paintBlocks(canvas_, blocks, column_, 8);
    EXPECT_NEAR(bottom, column_.top() + heightOf(canvas_, blocks, column_.width(), 8), 1e-6);
    EXPECT_LT(bottom, column_.bottom());
}

TEST_F(Page, LettersShrinkUntilTheyFitButNotBelowTheLeast) {
    const TextBlocks few{body("one line")};
    EXPECT_DOUBLE_EQ(fittingPoints(canvas_, few, column_.size(), 8, 5), 8);
    TextBlocks many;
    for (int i = 0; i < 12; ++i) many.push_back(body("one line"));
    const double points = fittingPoints(canvas_, many, column_.size(), 8, 5);
    EXPECT_LT(points, 8);
    EXPECT_LE(heightOf(canvas_, many, column_.width(), points), column_.height());
    const TextBlocks endless(500, body("one line"));
    EXPECT_DOUBLE_EQ(fittingPoints(canvas_, endless, column_.size(), 8, 5), 5);
}

TEST(TextBlocks, NumbersKeepToTheirUnits) {
    const QString nbsp(QChar::Nbsp);
    EXPECT_EQ(body("at 10 °C for 5 min a day").text, "at 10" + nbsp + "°C for 5" + nbsp + "min a day");
    EXPECT_EQ(body("3 minor parts").text, "3 minor parts");
    EXPECT_EQ(body("40 % of 12 m²").text, "40" + nbsp + "% of 12" + nbsp + "m²");
}

}  // namespace
}  // namespace noonmark
