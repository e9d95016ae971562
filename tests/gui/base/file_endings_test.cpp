#include "app/gui/base/files/file_dialogs.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

QStringList patternsOf(const QString& filter) {
    return filter.section(u'(', 1).section(u')', 0, 0).split(u' ');
}

TEST(FileEndings, TheCityFilterHoldsEveryFormatOnce) {
    const QStringList patterns = patternsOf(makeCityFilters());
    EXPECT_EQ(patterns.count(QStringLiteral("*.noonmark.gpkg")), 1);
    for (const Format& format : coreFormats()) {
        if (!format.isRead()) continue;
        for (const std::string_view ending : format.endings)
            EXPECT_EQ(patterns.count(u'*' + QString::fromLatin1(ending.data(), qsizetype(ending.size()))), 1)
                << ending;
    }
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
