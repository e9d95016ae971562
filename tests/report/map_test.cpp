#include <gtest/gtest.h>

#include <QBuffer>
#include <QImage>
#include <QPdfWriter>

#include "app/report/maps/legend_painter.h"
#include "app/report/maps/map_painter.h"
#include "app/report/maps/map_view.h"
#include "tests/report/book/recorded_page.h"
#include "tests/report/synthetic_study.h"

namespace noonmark {
namespace {

constexpr QSize size{1200, 840};

QImage mapOf(const Study& study) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::green);
    QPainter painter(&image);
    paintMap({painter, 2}, makeMapView(study, QRectF(image.rect())), study, ShadowMeasure::gross);
    return image;
}

QColor colourAt(const QImage& image, const Study& study, double x, double y) {
    return image.pixelColor(makeMapView(study, QRectF(image.rect())).at({x, y}).toPoint());
}

TEST(Map, EachQuarterHasItsColourInItsPlace) {
    const Study study = tests::syntheticStudy();
    const QImage image = mapOf(study);
    EXPECT_EQ(colourAt(image, study, 10.5, 10.5), QColor(Qt::white)) << "south-west: no shadow, no colour";
    EXPECT_EQ(colourAt(image, study, 110.5, 10.5), shadowColour(0.5)) << "south-east";
    EXPECT_EQ(colourAt(image, study, 10.5, 70.5), shadowColour(60.0 / 360)) << "north-west";
    EXPECT_EQ(colourAt(image, study, 110.5, 70.5), shadowColour(1)) << "north-east";
}

// Where there is little room the names of the patches shrink as the title does, before the unit is cut.
TEST(Map, ALegendWithPatchesKeepsItsUnit) {
    const auto isWhole = [](int width) {
        tests::RecordedPage page({width, 40});
        QPainter painter(&page);
        Legend legend{"Change of gross shadow", "min a day", {60, 15}, false, true};
        legend.patches = {{Qt::gray, "built over"}, {Qt::yellow, "building absent"}};
        paintLegend({painter, 1}, QRectF(0, 0, width, legendHeightPt), legend);
        painter.end();
        return page.allText().contains(QStringLiteral("min a day"));
    };
    int width = 500;
    while (isWhole(width)) width -= 2;
    EXPECT_LT(width, 226) << "with the names of patches at their full size it needs 250";
}

TEST(Map, NorthIsUpAndEastIsRight) {
    const MapView view = makeMapView(tests::syntheticStudy(), QRectF(QPointF(0, 0), size));
    EXPECT_LT(view.at({60, 80}).y(), view.at({60, 0}).y());
    EXPECT_GT(view.at({120, 40}).x(), view.at({0, 40}).x());
    EXPECT_NEAR(view.at({120, 40}).x() - view.at({0, 40}).x(), 120 * view.unitsPerM(), 1e-6);
    EXPECT_NEAR(view.at({60, 0}).y() - view.at({60, 80}).y(), 80 * view.unitsPerM(), 1e-6);
}

TEST(Map, BuildingsAreGreyAndPaleOutsideTheRegion) {
    const Study study = tests::syntheticStudy();
    const QImage image = mapOf(study);
    EXPECT_EQ(colourAt(image, study, 55, 35), ink::building);
    EXPECT_EQ(colourAt(image, study, -3.8, 40), ink::context);
    EXPECT_EQ(colourAt(image, study, 60.5, 55.5), shadowColour(1)) << "the ground below an overhang is shown";
}

TEST(Map, ProposalsAreTintedAndWhatIsDemolishedIsOutlined) {
    Study study = tests::syntheticStudy();
    const auto box = [](float west, float south) {
        Building building{.sourceId = "b"};
        building.parts.push_back(
            {.footprint = {{{west, south}, {west + 8, south}, {west + 8, south + 8}, {west, south + 8}}, {}},
             .topM = 30,
             .heightSource = HeightSource::designed});
        return std::make_shared<const Building>(std::move(building));
    };
    study.city.buildings.push_back(box(80, 10));
    MapScene scene = makeMapScene(study, ShadowMeasure::gross);
    City removed = study.city;
    removed.buildings = {box(20, 60)};
    scene.removed = std::make_shared<const City>(std::move(removed));
    QImage image(1200, 900, QImage::Format_RGB32);
    QPainter painter(&image);
    const MapView view = makeMapView(scene, QRectF(image.rect()));
    const auto at = [&](double x, double y) { return image.pixelColor(view.at({x, y}).toPoint()); };
    paintMap({painter, 6}, view, scene);  // lines of several pixels
    EXPECT_EQ(at(84, 14), shade::proposal);
    EXPECT_EQ(at(20, 64), shade::incremental) << "its western wall";
    const QColor inside = at(24, 64);
    scene.removed.reset();
    paintMap({painter, 6}, view, scene);  // lines of several pixels
    EXPECT_EQ(at(24, 64), inside) << "the ground is shown where it stood";
}

TEST(Map, AChangedBuildingIsNotDemolished) {
    City before = tests::syntheticStudy().city;
    before.buildings.clear();
    for (const char* id : {"changed", "removed"})
        before.buildings.push_back(std::make_shared<const Building>(Building{.sourceId = id}));
    City after = before;
    after.buildings.pop_back();
    const auto absent = findAbsent(before, after);
    ASSERT_TRUE(absent);
    ASSERT_EQ(absent->buildings.size(), 1U);
    EXPECT_EQ(absent->buildings[0]->sourceId, "removed");
    EXPECT_FALSE(findAbsent(before, before));
}

TEST(Map, EdgesOfCellsAreExact) {
    const Study study = tests::syntheticStudy();
    const QImage image = mapOf(study);
    EXPECT_EQ(colourAt(image, study, 59.8, 20.5), QColor(Qt::white));
    EXPECT_EQ(colourAt(image, study, 60.2, 20.5), shadowColour(0.5));
    EXPECT_EQ(colourAt(image, study, 100.5, 39.8), shadowColour(0.5));
    EXPECT_EQ(colourAt(image, study, 100.5, 40.2), shadowColour(1));
}

/// The study's map without lines, zoomed on a square around a place.
MapScene zoomedOn(Study& study, glm::vec2 middle, float halfM) {
    study.settings.region.polygons.clear();
    study.city.buildings.clear();
    MapScene scene = makeMapScene(study, ShadowMeasure::gross);
    scene.shown = Box2{middle - halfM, middle + halfM};
    return scene;
}

TEST(Map, EdgesOfCellsAreExactHoweverFarItIsZoomed) {
    Study study = tests::syntheticStudy();
    QImage image({800, 800}, QImage::Format_RGB32);
    const auto colourAround = [&](glm::vec2 middle, glm::dvec2 at) {
        const MapScene scene = zoomedOn(study, middle, 1);
        const MapView view = makeMapView(scene, QRectF(image.rect()));
        QPainter painter(&image);
        paintMap({painter, 2}, view, scene);
        return image.pixelColor(view.at(at).toPoint());
    };
    EXPECT_EQ(colourAround({60, 20}, {59.98, 20.02}), QColor(Qt::white));
    EXPECT_EQ(colourAround({60, 20}, {60.02, 20.02}), shadowColour(0.5));
    EXPECT_EQ(colourAround({100, 40}, {100.02, 39.98}), shadowColour(0.5));
    EXPECT_EQ(colourAround({100, 40}, {100.02, 40.02}), shadowColour(1));
}

TEST(Map, ZoomedFarIsPrintedWithoutThePictureOfAllCells) {
    Study study = tests::syntheticStudy();
    const MapScene scene = zoomedOn(study, {100, 40}, 0.1F);  // the whole field would be 5 million units wide
    QBuffer pdf;
    pdf.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&pdf);
        writer.setResolution(1200);
        QPainter painter(&writer);
        paintMap({painter, 1200.0 / 72}, makeMapView(scene, QRectF(0, 0, 8000, 8000)), scene);
    }
    EXPECT_TRUE(pdf.data().contains("/Subtype /Image"));
    EXPECT_LT(pdf.size(), 1'000'000);
}

TEST(FieldImage, LargeGridsAreReducedByMeans) {
    const Study study = tests::syntheticStudy();
    const QImage image =
        makeFieldImage(study.field, study.receivers, ShadowMeasure::gross, plainScale(360), 12).image;
    EXPECT_EQ(image.size(), QSize(12, 8));
    EXPECT_EQ(image.pixelColor(0, 7), shadowColour(0));
    EXPECT_EQ(image.pixelColor(11, 0), shadowColour(1));
    EXPECT_EQ(image.pixelColor(5, 4), QColor(Qt::white)) << "a block without receivers";
}

TEST(FieldImage, BlocksThatAreCutAtTheEdgeKeepTheirPlace) {
    const Study study = tests::syntheticStudy();
    const QImage image =
        makeFieldImage(study.field, study.receivers, ShadowMeasure::continuous, plainScale(360), 17)
            .image;  // squares of 7 x 7 cells
    EXPECT_EQ(image.size(), QSize(18, 12));
    EXPECT_EQ(image.pixelColor(0, 11), shadowColour(0));
    EXPECT_EQ(image.pixelColor(17, 0), shadowColour(0.5));
}

TEST(Map, BlocksThatAreCutAtTheEdgeDoNotStretchTheMap) {
    Study study = tests::syntheticStudy();
    study.settings.region.polygons.clear();  // lines would cover everything at this point size
    study.city.buildings.clear();
    QImage image({400, 280}, QImage::Format_RGB32);
    QPainter painter(&image);
    const MapView view = makeMapView(study, QRectF(image.rect()));
    // Like coarse print: for 17 pixels, squares of 7 x 7 cells, the last one cell wide.
    const double unitsAPoint = 4 * view.rectOf(study.field.grid).width() / 16.5;
    paintMap({painter, unitsAPoint}, view, study, ShadowMeasure::gross);
    const auto colour = [&](double x, double y) { return image.pixelColor(view.at({x, y}).toPoint()); };
    EXPECT_EQ(colour(55, 10), QColor(Qt::white));
    EXPECT_NE(colour(62, 10), shadowColour(0.5)) << "the block from 56 to 63 lies in both quarters";
    EXPECT_EQ(colour(64, 10), shadowColour(0.5));
}

TEST(FieldImage, NoWhiteStepsUnderTheWalls) {
    const Study study = tests::syntheticStudy();
    const QImage image =
        makeFieldImage(study.field, study.receivers, ShadowMeasure::gross, plainScale(360), 1000).image;
    EXPECT_EQ(image.pixelColor(50, 79 - 32), shadowColour(0)) << "a covered cell that touches receivers";
    EXPECT_EQ(image.pixelColor(60, 79 - 40), QColor(Qt::white)) << "one that touches none";
}

static QImage paintedLegend(const Legend& legend, const QSize& size) {
    QImage image(size, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    const double point = image.height() / legendHeightPt;
    QPainter painter(&image);
    paintLegend({painter, point}, QRectF(image.rect()).adjusted(point, 0, -point, 0), legend);
    return image;
}

TEST(LegendPainter, BarRunsFromSunToShadow) {
    const Legend legend = makeLegend(tests::syntheticStudy().field, ShadowMeasure::gross);
    EXPECT_EQ(legend.scale.top, 360);
    const QImage image = paintedLegend(legend, {1200, 144});
    EXPECT_EQ(image.size(), QSize(1200, 144));
    const int middle = int(17.5 * 4);
    EXPECT_GT(image.pixelColor(20, middle).lightness(), 180);
    EXPECT_LT(image.pixelColor(1180, middle).lightness(), 70);
    EXPECT_EQ(image.pixelColor(600, 143).alpha(), 0);
}

TEST(LegendPainter, AMomentHasTwoPatches) {
    Study study = tests::syntheticStudy();
    study.field.sunlitMinutesPerDay = 1;
    EXPECT_TRUE(makeLegend(study.field, ShadowMeasure::gross).instant);
    EXPECT_FALSE(paintedLegend(makeLegend(study.field, ShadowMeasure::gross), {300, 60}).isNull());
}

struct BarCase {
    double longest, length;
};

TEST(ScaleBar, LengthsAreRound) {
    for (const BarCase& c :
         {BarCase{100, 100}, {99, 50}, {250, 200}, {199, 100}, {720, 500}, {3, 2}, {12000, 10000}})
        EXPECT_DOUBLE_EQ(scaleBarWithin(c.longest).lengthM(), c.length) << c.longest;
}

TEST(ScaleBar, LengthsAreRoundInFeetAndMiles) {
    // 100 m are 328 ft, 1,600 m are 5,249 ft, 1,700 m are 1.06 miles of 5,280 ft.
    for (const BarCase& c : {BarCase{100, 200 * 0.3048}, {1600, 5000 * 0.3048}, {1700, 5280 * 0.3048}})
        EXPECT_DOUBLE_EQ(scaleBarWithin(c.longest, UnitSystem::imperial).lengthM(), c.length) << c.longest;
    EXPECT_FALSE(scaleBarWithin(100, UnitSystem::both).inFeet);
}

}  // namespace
}  // namespace noonmark
