#include "core/io/styles/qgis_style.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "core/base/gdal_calls.h"
#include "core/io/shadows/write_shadows.h"
#include "core/io/write_city.h"
#include "core/study/contributions/contributions.h"
#include "core/study/elements/element_tables.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using tests::cityOf;
using tests::TemporaryFolder;

// The default style of a layer, as QGIS finds it.
std::string styleIn(const std::filesystem::path& file, const std::string& layer) {
    const GdalCalls calls;
    const GDALDatasetUniquePtr read(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR));
    OGRLayer* styles = read ? read->GetLayerByName("layer_styles") : nullptr;
    if (styles == nullptr) return {};
    styles->SetAttributeFilter(("f_table_name = '" + layer + "' AND useAsDefault").c_str());
    const OGRFeatureUniquePtr style(styles->GetNextFeature());
    if (!style || read->GetLayerByName(layer.c_str()) == nullptr) return {};
    EXPECT_STREQ(style->GetFieldAsString("f_geometry_column"),
                 read->GetLayerByName(layer.c_str())->GetGeometryColumn());
    return style->GetFieldAsString("styleQML");
}

std::vector<double> lowsOf(const std::vector<ColourClass>& classes) {
    std::vector<double> lows;
    for (const ColourClass& one : classes) lows.push_back(one.low);
    return lows;
}

TEST(LayerStyles, ClassesAreThoseOfTheScaleInTheUnitOfTheColumn) {
    ColourScale hours = makeColourScale({.show = ShownAs::sun}, {ShownAs::sun, 480}, 480, {});
    ASSERT_TRUE(hours.breaks.empty());
    const auto ticks = styleClasses(hours, 60);
    ASSERT_EQ(ticks.size(), std::size_t(hours.high / hours.tick));
    EXPECT_EQ(ticks[1].low, 60 * hours.tick);
    hours.breaks = {2, 4};
    EXPECT_THAT(lowsOf(styleClasses(hours, 60)),
                ElementsAre(-std::numeric_limits<double>::infinity(), 120, 240));
    EXPECT_EQ(styleClasses(hours, 60)[1].label, "2 to 4 h");
    EXPECT_EQ(styleClasses(hours)[2].colour, hours.classes()[2].colour);
}

TEST(LayerStyles, TextsAreSafeInXmlAndSql) {
    const std::vector<ColourClass> classes{{0, 1, {1, 2, 3}, "< 1 \"O'Hare\""}};
    const std::string qml = graduatedStyle(StyledShape::polygons, "share", classes);
    EXPECT_THAT(qml, HasSubstr(R"(label="&lt; 1 &quot;O'Hare&quot;")"));
    EXPECT_THAT(qml, HasSubstr(R"(name="color" value="1,2,3,255")"));
    EXPECT_THAT(addStyleSql("it's", "geom", {"Style", qml}), HasSubstr("'it''s'"));
}

TEST(LayerStyles, ContributionsAreColouredByTheirShare) {
    const TemporaryFolder folder;
    const City city = cityOf({tests::Box3{{0, 0, 0}, {10, 10, 20}}});
    ASSERT_TRUE(writeCityGeoPackage(folder.path("c.gpkg"), city, {{"share", {0.2}}}, contributionStyle()));
    const std::string qml = styleIn(folder.path("c.gpkg"), "buildings");
    EXPECT_THAT(qml, HasSubstr(R"(attr="share")"));
    EXPECT_THAT(qml, HasSubstr("15 to 30 %"));
    ASSERT_TRUE(writeCityGeoPackage(folder.path("plain.gpkg"), city));
    EXPECT_EQ(styleIn(folder.path("plain.gpkg"), "buildings"), "");
}

TEST(LayerStyles, PointsAreColouredByWhatTheLegendShows) {
    const TemporaryFolder folder;
    const auto styleOf = [&](ShownAs show) {
        const auto file = folder.path(std::string(keyOf(shownChoices(), show)) + ".gpkg");
        const ColourScale scale = makeColourScale({.show = show}, {show, 600}, 600, {});
        EXPECT_TRUE(writeElementsGeoPackage(file, ElementTable{{{"sunlit_min", 0.0}}, {{300.0}}, {{0, 0, 0}}},
                                            makeStyle(scale)));
        return styleIn(file, "elements");
    };
    EXPECT_THAT(styleOf(ShownAs::shadow), HasSubstr(R"(attr="gross_min")"));
    EXPECT_THAT(styleOf(ShownAs::sun), HasSubstr(R"(attr="sunlit_min")"));
    EXPECT_THAT(styleOf(ShownAs::share), HasSubstr(R"(attr="sunlit_pct")"));
}

TEST(LayerStyles, LinesOfEqualMinutesHaveTheColoursOfMapsOfShadow) {
    const TemporaryFolder folder;
    ShadowDrawing drawing;
    drawing.frame = Frame({-73.98, 40.75});
    drawing.isochrones.push_back(
        {"2026-03-21", 2, {{120, {{0, 0}, {30, 0}, {30, 40}}, true}, {60, {{0, 0}, {50, 0}}, false}}});
    ASSERT_TRUE(writeShadowsGeoPackage(folder.path("s.gpkg"), drawing, DrawingPlane::local));
    const std::string qml = styleIn(folder.path("s.gpkg"), "isochrones");
    const Rgb darkest = plainScale(120).colourOf(120);
    EXPECT_THAT(qml, HasSubstr(R"(attr="minutes")"));
    EXPECT_THAT(qml, HasSubstr(R"(<category value="120")"));
    EXPECT_THAT(qml, HasSubstr("line_color\" value=\"" + std::to_string(darkest.red) + ","));
}

}  // namespace
}  // namespace noonmark
