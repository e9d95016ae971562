#include "app/gui/session/project/recent_files.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QMenu>
#include <QSettings>
#include <QTemporaryDir>

#include "app/gui/frame/actions/opening_actions.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {
namespace {

struct RecentFilesTest : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    RecentFiles recent{settings};
};

TEST_F(RecentFilesTest, NewestFirstEachOnce) {
    recent.add({QStringLiteral("/a.gpkg")});
    recent.add({QStringLiteral("/b.gpkg")});
    recent.add({QStringLiteral("/a.gpkg")});
    EXPECT_EQ(recent.entries(), (QStringList{QStringLiteral("/a.gpkg"), QStringLiteral("/b.gpkg")}));
}

TEST_F(RecentFilesTest, KeepsNoMoreThanItSays) {
    for (int i = 0; i < 30; ++i) recent.add({QStringLiteral("/%1.gpkg").arg(i)});
    EXPECT_EQ(recent.entries().size(), RecentFiles::maximum);
    EXPECT_EQ(recent.entries().front(), QStringLiteral("/29.gpkg"));
}

TEST_F(RecentFilesTest, FilesOpenedTogetherStayTogether) {
    const QStringList files{QStringLiteral("/city.gpkg"), QStringLiteral("/ground.tif")};
    recent.add(files);
    EXPECT_EQ(RecentFiles::filesOf(recent.entries().front()), files);
    EXPECT_EQ(RecentFiles::nameOf(recent.entries().front()), QStringLiteral("city.gpkg and 1 more"));
}

ReadSettings everyOption() {
    ReadSettings reading;
    reading.heightField = "ROOF";
    reading.heightUnit = LengthUnit::feet;
    reading.metresPerLevel = 3.5;
    reading.defaultHeightM = 12;
    reading.layer = "buildings";
    reading.crs = "EPSG:2263";
    reading.lod = "2.2";
    reading.farAwayM = 5000;
    reading.upAxis = UpAxis::z;
    reading.meshUnit = LengthUnit::usSurveyFeet;
    reading.meshNorthDeg = -29.1;
    reading.meshAnchor = LonLat{-73.98, 40.76};
    return reading;
}

TEST_F(RecentFilesTest, HowAFileWasReadComesBackWithIt) {
    const ReadSettings every = everyOption();
    recent.add({QStringLiteral("/mesh.obj")}, every);
    recent.add({QStringLiteral("/plain.gpkg")});
    const ReadSettings back = recent.readingOf(QStringLiteral("/mesh.obj"));
    EXPECT_EQ(formatText(back), formatText(every));
    EXPECT_EQ(back.crs, every.crs);
    EXPECT_EQ(back.heightUnit, every.heightUnit);
    EXPECT_EQ(back.meshUnit, every.meshUnit);
    EXPECT_EQ(back.meshNorthDeg, every.meshNorthDeg);
    EXPECT_EQ(back.meshAnchor->lonDeg, every.meshAnchor->lonDeg);
    EXPECT_EQ(back.upAxis, UpAxis::z);
    EXPECT_EQ(recent.readingTextOf(QStringLiteral("/plain.gpkg")), QString());
    EXPECT_FALSE(recent.readingOf(QStringLiteral("/plain.gpkg")).crs);
}

TEST_F(RecentFilesTest, TheLastWayOfReadingCounts) {
    recent.add({QStringLiteral("/mesh.obj")}, everyOption());
    recent.add({QStringLiteral("/mesh.obj")});
    EXPECT_EQ(recent.readingTextOf(QStringLiteral("/mesh.obj")), QString());
}

TEST_F(RecentFilesTest, TheMenuHandsTheSettingsOn) {
    QMenu menu;
    RecentMenu entries(menu, settings);
    entries.add({QStringLiteral("/mesh.obj")}, everyOption());
    ASSERT_EQ(menu.actions().size(), 1);
    EXPECT_EQ(menu.actions()[0]->text(), QStringLiteral("mesh.obj, with options"));
    std::optional<ReadSettings> chosen;
    QObject::connect(&entries, &RecentMenu::chosen,
                     [&](const QStringList&, const ReadSettings& reading) { chosen = reading; });
    menu.actions()[0]->trigger();
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->crs, "EPSG:2263");
}

TEST_F(RecentFilesTest, SamplesStayNames) {
    recent.add({QStringLiteral("sample:grid")});
    EXPECT_EQ(recent.entries().front(), QStringLiteral("sample:grid"));
}

TEST_F(RecentFilesTest, TheMenuLeavesOutSamples) {
    recent.add({QStringLiteral("/tmp/mine.gpkg")});
    recent.add({QStringLiteral("sample:grid")});
    QMenu menu;
    const RecentMenu entries(menu, settings);
    ASSERT_EQ(menu.actions().size(), 1);
    EXPECT_EQ(menu.actions()[0]->text(), QStringLiteral("mine.gpkg"));
}

}  // namespace
}  // namespace noonmark
