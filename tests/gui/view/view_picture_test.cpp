#include "app/gui/view/panel/view_picture.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDoubleSpinBox>

#include "app/gui/tools/editing/mesh_placing.h"

namespace noonmark {
namespace {

int darkPixels(const QImage& image, const QRect& area) {
    int dark = 0;
    for (int y = area.top(); y <= area.bottom(); ++y)
        for (int x = area.left(); x <= area.right(); ++x) dark += qGray(image.pixel(x, y)) < 120 ? 1 : 0;
    return dark;
}

/// A white view with all elements around it.
struct SavedPicture : ::testing::Test {
    QImage view{900, 500, QImage::Format_RGB32};
    PictureFrame frame{.title = QStringLiteral("Monaco: Proposal A"),
                       .when = QStringLiteral("21 March 2026, 09:00 to 15:00"),
                       .note = QStringLiteral("Short note"),
                       .credit = QStringLiteral("Data: somebody"),
                       .pixelsPerM = 2};
    SavedPicture() { view.fill(Qt::white); }

    [[nodiscard]] static QRect foot(const QImage& picture) {
        return {picture.width() / 2, picture.height() - 130, picture.width() / 2, 80};
    }
};

TEST_F(SavedPicture, HasTitleTimeScaleAndNorth) {
    const QImage picture = viewPicture(view, frame);
    EXPECT_EQ(picture.width(), view.width());
    EXPECT_GT(darkPixels(picture, {0, 0, picture.width(), 30}), 200) << "the title";
    EXPECT_GT(darkPixels(picture, foot(picture)), 200) << "scale bar and north arrow";
    frame.title.clear();
    frame.when.clear();
    EXPECT_LT(viewPicture(view, frame).height(), picture.height());
    frame.headingDeg = 90;
    const QImage turned = viewPicture(view, frame);
    frame.headingDeg = 0;
    EXPECT_NE(viewPicture(view, frame), turned) << "north is not up";
}

TEST_F(SavedPicture, WrapsItsNoteInsteadOfCuttingIt) {
    const int before = viewPicture(view, frame).height();
    frame.note =
        QStringLiteral("A caption that says at length what is shown and what it is not. ").repeated(8);
    const QImage picture = viewPicture(view, frame);
    EXPECT_GE(picture.height(), before + 3 * 12) << "four lines or more";
    EXPECT_EQ(darkPixels(picture, {0, 0, 8, picture.height()}), 0) << "and a margin";
    EXPECT_EQ(darkPixels(picture, {picture.width() - 8, 0, 8, picture.height()}), 0);
}

TEST(PlacingPanels, FieldsStayUnderTheCursorWhateverIsReported) {
    PlacingPanel panel;
    panel.resize(300, 500);
    panel.show();
    const auto places = [&panel] {
        std::vector<int> y;
        for (int i = 0; i < 10; ++i) QCoreApplication::processEvents();
        for (const QWidget* field : panel.findChildren<QDoubleSpinBox*>()) y.push_back(field->y());
        return y;
    };
    panel.begin(QStringLiteral("t.obj"));
    panel.showWarnings({});
    const auto before = places();
    panel.showPlaced(40, 0);
    EXPECT_EQ(places(), before);
    panel.begin(QStringLiteral("a tower with a rather long name of its file, twice.obj"));
    EXPECT_EQ(places(), before);
    panel.showWarnings(
        {{WarningKind::assumed, "the project's origin is used as the mesh's origin", "t.obj"}});
    EXPECT_EQ(places(), before);
}

}  // namespace
}  // namespace noonmark
