#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <fstream>

#include "app/gui/frame/main_window.h"
#include "app/gui/view/panel/view_panel.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

constexpr const char* houses = R"({"type":"FeatureCollection","features":[{"type":"Feature",
"properties":{"height":12},"geometry":{"type":"Polygon","coordinates":
[[[10.0001,50.0001],[10.0003,50.0001],[10.0003,50.0003],[10.0001,50.0003],[10.0001,50.0001]]]}}]})";
constexpr const char* wgs84 =
    R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],)"
    R"(UNIT["degree",0.0174532925199433]])";

/// The window with one house; a level terrain of 40 m lies beside its file.
struct OpeningWindow : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    MainWindow window{settings};
    QString city = folder.filePath(QStringLiteral("houses.geojson"));
    QString terrain = folder.filePath(QStringLiteral("ground.asc"));

    void SetUp() override {
        std::ofstream(city.toStdString()) << houses;
        std::ofstream(folder.filePath(QStringLiteral("ground.prj")).toStdString()) << wgs84;
        std::ofstream grid(terrain.toStdString());
        grid << "ncols 20\nnrows 20\nxllcorner 9.999\nyllcorner 49.999\ncellsize 0.0002\n";
        for (int row = 0; row < 20; ++row)
            for (int column = 0; column < 20; ++column) grid << 40 << (column == 19 ? '\n' : ' ');
        grid.close();
        window.saving().setUnsavedQuestion([] { return SavingActions::Unsaved::discard; });
        window.show();
        window.open({city});
        ASSERT_TRUE(waitFor([this] { return window.workbench().city() != nullptr; }));
    }

    [[nodiscard]] const City& shown() { return window.workbench().city()->city(); }
    [[nodiscard]] QString message() { return window.panel().messages().text(); }
    void click(const char* button) {
        window.panel().messages().findChild<QPushButton*>(QString::fromUtf8(button))->click();
    }
};

TEST_F(OpeningWindow, ATerrainDoesNotTakeThePlaceOfTheCity) {
    window.open({terrain});
    EXPECT_TRUE(message().contains(QStringLiteral("ground.asc is a terrain"))) << message().toStdString();
    EXPECT_EQ(shown().buildings.size(), 1U);
    click("remedy");
    ASSERT_TRUE(waitFor([this] { return shown().terrain != nullptr; })) << message().toStdString();
    EXPECT_EQ(shown().buildings.size(), 1U);
    EXPECT_EQ(window.workbench().source().files, (QStringList{city, terrain}));
}

TEST_F(OpeningWindow, ATerrainIsAddedOnceAndNeverReplaced) {
    window.places().addFiles({terrain});
    ASSERT_TRUE(waitFor([this] { return shown().terrain != nullptr; })) << message().toStdString();
    EXPECT_EQ(shown().buildings.size(), 1U);
    const auto before = window.workbench().city();
    window.places().addFiles({terrain});
    EXPECT_TRUE(message().contains(QStringLiteral("has a terrain already"))) << message().toStdString();
    EXPECT_EQ(window.workbench().city(), before);
}

TEST_F(OpeningWindow, ATerrainOpensAloneWhereThatIsWanted) {
    window.open({terrain});
    click("otherRemedy");
    ASSERT_TRUE(waitFor([this] { return shown().buildings.empty(); })) << message().toStdString();
    EXPECT_NE(shown().terrain, nullptr);
}

TEST_F(OpeningWindow, AFolderNamesItsTerrainsAndOffersToAddOne) {
    window.opening().openFilesOf(folder.path());
    ASSERT_TRUE(waitFor([this] { return !window.opening().terrainsBeside().isEmpty(); }));
    EXPECT_EQ(window.opening().terrainsBeside(), QStringList{terrain});
    ASSERT_TRUE(waitFor([this] { return message().contains(QStringLiteral("ground.asc")); }))
        << message().toStdString();
    EXPECT_EQ(shown().terrain, nullptr);
    click("otherRemedy");
    ASSERT_TRUE(waitFor([this] { return shown().terrain != nullptr; })) << message().toStdString();
    EXPECT_TRUE(window.opening().terrainsBeside().isEmpty()) << "it is in the city";
}

TEST_F(OpeningWindow, SaysAtAGlanceWhatWasRead) {
    window.open({city});
    ASSERT_TRUE(waitFor([this] { return message().contains(QStringLiteral("Changed in reading: ")); }))
        << message().toStdString();
    EXPECT_TRUE(message().contains(QStringLiteral("GeoJSON (WGS 84, as the file states), ")))
        << message().toStdString();
    EXPECT_TRUE(message().contains(QStringLiteral("Buildings: 1, parts: 1, up to ")))
        << message().toStdString();
}

void turnWheel(QWidget& field) {
    const QPointF middle = field.rect().center();
    QWheelEvent wheel(middle, field.mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&field, &wheel);
}

TEST(WheelGuard, OnlyAFieldWithFocusFollowsTheWheel) {
    QWidget form;
    auto* column = new QVBoxLayout(&form);
    auto* number = new QSpinBox;
    auto* list = new QComboBox;
    number->setValue(50);
    list->addItems({QStringLiteral("Quick"), QStringLiteral("Exact"), QStringLiteral("Reference")});
    column->addWidget(number);
    column->addWidget(list);
    form.show();
    form.activateWindow();
    ASSERT_TRUE(waitFor([&] { return form.isActiveWindow(); }));
    list->setFocus();
    turnWheel(*number);
    EXPECT_EQ(number->value(), 50);
    EXPECT_EQ(number->focusPolicy(), Qt::StrongFocus);  // the wheel does not give it either
    turnWheel(*list);
    EXPECT_EQ(list->currentIndex(), 1);
    number->setFocus();
    turnWheel(*list);
    EXPECT_EQ(list->currentIndex(), 1);
    turnWheel(*number);
    EXPECT_EQ(number->value(), 49);
}

TEST(EmptyWindow, SavingSaysThatNoCityIsOpen) {
    const QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    MainWindow window{settings};
    window.saving().actions().front()->trigger();
    EXPECT_TRUE(window.panel().messages().text().startsWith(QStringLiteral("No city is open")))
        << window.panel().messages().text().toStdString();
}

}  // namespace
}  // namespace noonmark
