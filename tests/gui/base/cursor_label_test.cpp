#include "app/gui/base/widgets/cursor_label.h"

#include <gtest/gtest.h>

#include <QWindow>

namespace noonmark {
namespace {

TEST(CursorLabel, StandsOnTheSideThatIsFreeOfShadow) {
    QWindow view;
    view.setGeometry(300, 200, 600, 400);
    view.show();
    CursorLabel label(view, nullptr);
    const QPoint cursor = view.mapToGlobal(QPoint(300, 200));
    label.show({300, 200}, QStringLiteral("40 m"));
    EXPECT_GT(label.geometry().left(), cursor.x());
    EXPECT_GT(label.geometry().top(), cursor.y());
    label.setFreeSide({-1, -1});
    label.show({300, 200}, QStringLiteral("40 m"));
    EXPECT_LT(label.geometry().right(), cursor.x());
    EXPECT_LT(label.geometry().bottom(), cursor.y());
    label.show({2, 2}, QStringLiteral("a long line that would reach beyond the left edge of any screen"));
    EXPECT_GE(label.geometry().left(), 0) << "unless it would leave the screen";
}

}  // namespace
}  // namespace noonmark
