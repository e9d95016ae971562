#include "core/io/styles/qgis_style.h"

#include <gtest/gtest.h>

#include <QXmlStreamReader>

#include "app/report/maps/answer_legends.h"
#include "tests/report/synthetic_study.h"

namespace noonmark {
namespace {

struct ReadStyle {
    bool sound = false;
    QString type;
    QStringList values, labels;
    bool zeroIsFree = false;
};

ReadStyle readStyle(const Legend& legend) {
    ReadStyle read;
    QXmlStreamReader xml(QString::fromStdString(rasterStyle(coloursOf(legend))));
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("colorrampshader"))
            read.type = xml.attributes().value(QLatin1String("colorRampType")).toString();
        if (xml.name() == QLatin1String("pixelListEntry")) read.zeroIsFree = true;
        if (xml.name() != QLatin1String("item")) continue;
        read.values << xml.attributes().value(QLatin1String("value")).toString();
        read.labels << xml.attributes().value(QLatin1String("label")).toString();
    }
    read.sound = !xml.hasError();
    return read;
}

Legend legendOf(ShownAs show, const LegendClasses& classes = {}) {
    return makeLegend(tests::syntheticStudy().field, ShadowMeasure::gross,
                      {show, Ramp::noonmark, false, std::nullopt, classes});
}

TEST(RasterStyle, ClassesHaveTheBreaksOfTheLegendInMinutesOfTheFile) {
    const LegendClasses breaks{LegendClasses::Kind::breaks, 5, {2, 4}};
    const ReadStyle style = readStyle(legendOf(ShownAs::sun, breaks));
    EXPECT_TRUE(style.sound);
    EXPECT_EQ(style.type, QStringLiteral("DISCRETE"));
    EXPECT_EQ(style.values,
              (QStringList{QStringLiteral("120"), QStringLiteral("240"), QStringLiteral("inf")}))
        << "of 360 sunlit minutes";
    EXPECT_EQ(style.labels, (QStringList{QStringLiteral("4 h and more"), QStringLiteral("2 to 4 h"),
                                         QStringLiteral("below 2 h")}));
    EXPECT_FALSE(style.zeroIsFree) << "full sun has its colour";
}

TEST(RasterStyle, AContinuousLegendIsInterpolatedAndLeavesZeroFree) {
    const ReadStyle style = readStyle(legendOf(ShownAs::shadow));
    EXPECT_TRUE(style.sound);
    EXPECT_EQ(style.type, QStringLiteral("INTERPOLATED"));
    EXPECT_EQ(style.values.front(), QStringLiteral("0"));
    EXPECT_EQ(style.values.back(), QStringLiteral("360"));
    EXPECT_TRUE(style.zeroIsFree);
}

}  // namespace
}  // namespace noonmark
