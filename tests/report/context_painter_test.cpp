#include "app/report/maps/city_painter.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <QPicture>

namespace noonmark {
namespace {

TEST(ContextPainter, PaintsAreasLinesAndTreesWhereTheyAre) {
    MapContext context;
    const auto square = [](float west, float south, float side) {
        return Ring{{west, south}, {west + side, south}, {west + side, south + side}, {west, south + side}};
    };
    context.areas.push_back({ContextKind::park, "", {{square(0, 0, 40), {square(10, 10, 10)}}}});
    context.lines.push_back({ContextKind::street, "", 6, {{0, 70}, {100, 70}}});
    context.trees.push_back({80, 20});
    QImage image(100, 100, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    paintContext(painter, context, QTransform(1, 0, 0, -1, 0, 100), 1);  // y up
    painter.end();
    const auto alphaAt = [&](int x, int y) { return qAlpha(image.pixel(x, 99 - y)); };
    EXPECT_EQ(alphaAt(5, 5), 255);    // park
    EXPECT_EQ(alphaAt(15, 15), 0);    // its hole
    EXPECT_EQ(alphaAt(50, 70), 255);  // street, 6 m wide
    EXPECT_EQ(alphaAt(50, 75), 0);
    EXPECT_GT(alphaAt(80, 20), 100);  // tree
    EXPECT_EQ(alphaAt(60, 40), 0);
}

MapContext parkStreetAndTreeAt(float x) {
    MapContext context;
    context.areas.push_back({ContextKind::park, "", {{{{x, 0}, {x + 40, 0}, {x + 40, 40}, {x, 40}}, {}}}});
    context.lines.push_back({ContextKind::street, "", 6, {{x, 70}, {x + 50, 70}}});
    context.trees.push_back({x + 20, 20});
    return context;
}

/// Bytes of a vector picture of 100 x 100 units that shows the context.
unsigned pictureBytes(const MapContext& context) {
    QPicture picture;
    QPainter painter(&picture);
    painter.setClipRect(0, 0, 100, 100);
    paintContext(painter, context, QTransform(1, 0, 0, -1, 0, 100), 1);
    painter.end();
    return picture.size();
}

TEST(ContextPainter, LeavesOutWhatTheClipHides) {
    const unsigned nothing = pictureBytes({});
    EXPECT_GT(pictureBytes(parkStreetAndTreeAt(10)), pictureBytes(parkStreetAndTreeAt(500)));
    // Each pass over a kind sets pens and brushes, so even an empty context takes some bytes.
    EXPECT_EQ(pictureBytes(parkStreetAndTreeAt(500)), nothing);
    // A street that ends 2 units outside, but is 6 wide, is still seen.
    MapContext beside;
    beside.lines.push_back({ContextKind::street, "", 6, {{102, 0}, {102, 90}}});
    EXPECT_GT(pictureBytes(beside), nothing);
}

}  // namespace
}  // namespace noonmark
