#include "app/gui/base/files/file_endings.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

QStringList patternsOf(const QString& filter) {
    return filter.section(u'(', 1).section(u')', 0, 0).split(u' ');
}

TEST(FileEndings, TheCityFilterHoldsEveryFormatOfTheGuide) {
    // One per format of docs/user/data.md; a file geodatabase is a folder.
    const QStringList patterns = patternsOf(makeCityFilters());
    for (const char* pattern :
         {"*.noonmark.gpkg", "*.gpkg", "*.geojson",  "*.geojsonl", "*.shp", "*.fgb", "*.gml",
          "*.kml",           "*.csv",  "*.topojson", "*.json",     "*.osm", "*.pbf", "*.jsonl",
          "*.obj",           "*.ply",  "*.gltf",     "*.glb",      "*.tif", "*.asc", "*.img",
          "*.hgt",           "*.dem",  "*.dt2",      "*.bil",      "*.xyz"})
        EXPECT_EQ(patterns.count(QString::fromLatin1(pattern)), 1) << pattern;
}

TEST(FileEndings, KindsAreFiltersOfTheirOwn) {
    const QStringList filters = makeCityFilters().split(QStringLiteral(";;"));
    ASSERT_EQ(filters.size(), 6);
    EXPECT_EQ(patternsOf(filters[1]), QStringList{QStringLiteral("*.noonmark.gpkg")});
    EXPECT_FALSE(patternsOf(filters[2]).contains(QStringLiteral("*.obj")));
    EXPECT_TRUE(patternsOf(filters[3]).contains(QStringLiteral("*.obj")));
    EXPECT_TRUE(patternsOf(filters[4]).contains(QStringLiteral("*.tif")));
    EXPECT_EQ(filters.last(), QStringLiteral("All files (*)"));
}

}  // namespace
}  // namespace noonmark
