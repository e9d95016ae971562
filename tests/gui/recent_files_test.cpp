#include "app/window/recent_files.h"

#include <gtest/gtest.h>

#include <QSettings>
#include <QTemporaryDir>

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
    EXPECT_EQ(recent.entries().size(), RecentFiles::most);
    EXPECT_EQ(recent.entries().front(), QStringLiteral("/29.gpkg"));
}

TEST_F(RecentFilesTest, FilesOpenedTogetherStayTogether) {
    const QStringList files{QStringLiteral("/city.gpkg"), QStringLiteral("/ground.tif")};
    recent.add(files);
    EXPECT_EQ(RecentFiles::filesOf(recent.entries().front()), files);
    EXPECT_EQ(RecentFiles::nameOf(recent.entries().front()), QStringLiteral("city.gpkg and 1 more"));
}

TEST_F(RecentFilesTest, SamplesStayNames) {
    recent.add({QStringLiteral("sample:grid")});
    EXPECT_EQ(recent.entries().front(), QStringLiteral("sample:grid"));
}

}  // namespace
}  // namespace noonmark
