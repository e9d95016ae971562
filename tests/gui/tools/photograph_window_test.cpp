#include <gmock/gmock.h>

#include <QCheckBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <iterator>

#include "app/gui/tools/photograph/photograph_dialog.h"
#include "core/city/map_context.h"
#include "core/io/pictures/ground_raster_file.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::waitFor;
using testing::HasSubstr;

struct PhotographWindow : test::ProjectWindow {
    // All of one colour, about 400 m around the project's origin.
    GroundPictureFile made(const char* name, std::uint8_t red) {
        const Frame& frame = session().project().city->frame;
        const LonLat low = frame.lonLatFromLocal({-400, -400}), high = frame.lonLatFromLocal({400, 400});
        PlacedPicture picture{100, 100, {}, "EPSG:4326"};
        picture.geoTransform = {low.lonDeg, (high.lonDeg - low.lonDeg) / 100, 0, high.latDeg,
                                0,          (low.latDeg - high.latDeg) / 100};
        for (int pixel = 0; pixel < 100 * 100; ++pixel) {
            const std::uint8_t colour[]{red, 0, 0, 255};
            picture.rgba.insert(picture.rgba.end(), std::begin(colour), std::end(colour));
        }
        const std::string path = folder.filePath(QString::fromLatin1(name)).toStdString();
        EXPECT_TRUE(writePicture(path, picture));
        return {path, {}, "(c) Survey of Test"};
    }

    bool isDrawn() {
        const auto& context = workbench().city()->city().context;
        return context && context->picture;
    }

    void show(const GroundPictureFile& picture) {
        window->photograph().set(picture);
        ASSERT_TRUE(waitFor([this] { return isDrawn(); })) << message().toStdString();
    }

    // Pixels of the photograph's colour in a view of the whole city.
    int redPixels() {
        QImage image;
        window->panel().view().capture([&image](const QImage& made) { image = made; });
        EXPECT_TRUE(waitFor([&image] { return !image.isNull(); }));
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QColor seen = image.pixelColor(x, y);
                count += seen.red() > 150 && seen.blue() < 120 && seen.green() < 120 ? 1 : 0;
            }
        return count;
    }
};

TEST_F(PhotographWindow, APhotographIsDrawnHiddenUndoneAndSaved) {
    window->mode().setMode(ViewMode::analysis);  // exploration paints the ground
    show(made("red.tif", 220));
    EXPECT_TRUE(window->photograph().showAction()->isChecked());
    EXPECT_TRUE(waitFor([this] { return redPixels() > 1000; })) << redPixels();
    window->photograph().showAction()->trigger();
    EXPECT_TRUE(waitFor([this] { return !isDrawn(); }));
    EXPECT_FALSE(session().project().groundPicture->shown);
    workbench().document().undoStack().undo();
    EXPECT_TRUE(waitFor([this] { return isDrawn(); }));
    save();
    open(file);
    EXPECT_TRUE(isDrawn());
    EXPECT_EQ(session().project().groundPicture->attribution, "(c) Survey of Test");
    window->photograph().set(std::nullopt);
    EXPECT_TRUE(waitFor([this] { return !isDrawn(); }));
    EXPECT_FALSE(session().project().groundPicture);
}

TEST_F(PhotographWindow, AFileThatHasChangedIsNotDrawnAndReported) {
    show(made("red.tif", 220));
    save();
    (void)made("red.tif", 90);
    open(file);
    EXPECT_FALSE(isDrawn());
    ASSERT_FALSE(workbench().placeWarnings().empty());
    EXPECT_THAT(workbench().placeWarnings().front().what, HasSubstr("has changed"));
    EXPECT_TRUE(session().project().groundPicture) << "stays in the project";
}

TEST_F(PhotographWindow, AFileThatIsNoPhotographIsRefused) {
    const QString text = folder.filePath(QStringLiteral("text.tif"));
    QFile out(text);
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write("not a picture");
    out.close();
    window->photograph().set(GroundPictureFile{text.toStdString(), {}, {}});
    EXPECT_TRUE(waitFor([this] { return message().contains(QStringLiteral("text.tif")); }));
    EXPECT_FALSE(session().project().groundPicture);
}

TEST_F(PhotographWindow, ADroppedPhotographIsDrawn) {
    window->places().takeDropped({QString::fromStdString(made("red.tif", 220).path.string())});
    EXPECT_TRUE(waitFor([this] { return isDrawn(); })) << message().toStdString();
}

TEST(PhotographDialog, ReturnsWhatIsTyped) {
    PhotographDialog dialog(GroundPictureFile{"/a/b.tif", "00ff", "(c) A", 0.4, true},
                            [] { return QStringLiteral("/c/d.tif"); });
    EXPECT_EQ(dialog.picture(), (GroundPictureFile{"/a/b.tif", "00ff", "(c) A", 0.4, true}));
    dialog.findChild<QLineEdit*>(QStringLiteral("photographAttribution"))->setText(QStringLiteral(" (c) B "));
    dialog.findChild<QSpinBox*>(QStringLiteral("photographOpacity"))->setValue(75);
    dialog.findChild<QCheckBox*>(QStringLiteral("photographShown"))->setChecked(false);
    dialog.findChild<QPushButton*>(QStringLiteral("photographChoose"))->click();
    EXPECT_EQ(dialog.picture(), (GroundPictureFile{"/c/d.tif", "", "(c) B", 0.75, false}));
    dialog.findChild<QPushButton*>(QStringLiteral("photographRemove"))->click();
    EXPECT_FALSE(dialog.picture());
}

}  // namespace
}  // namespace noonmark
