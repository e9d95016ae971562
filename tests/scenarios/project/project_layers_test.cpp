#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <glm/geometric.hpp>

#include "core/base/gdal_calls.h"
#include "core/io/places/read_places.h"
#include "core/receivers/place_names.h"
#include "scenarios/project/project_file.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/scenarios/sample_project.h"

namespace noonmark::tests {
namespace {

class ProjectLayersTest : public testing::Test {
protected:
    ProjectLayersTest() {
        EXPECT_TRUE(ProjectFile::create(file_, sampleProject()));
        vectors_.reset(GDALDataset::Open(file_.c_str(), GDAL_OF_VECTOR));
    }

    OGRLayer& layer(const char* name) { return *vectors_->GetLayerByName(name); }

    GdalCalls calls_;
    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path("town.noonmark.gpkg");
    GDALDatasetUniquePtr vectors_;
};

TEST_F(ProjectLayersTest, GisProgramsSeeLayersWithNames) {
    ASSERT_TRUE(vectors_);
    EXPECT_EQ(layer("buildings").GetFeatureCount(), 6);
    EXPECT_EQ(layer("proposals").GetFeatureCount(), 3);
    EXPECT_EQ(layer("lots").GetFeatureCount(), 2);
    EXPECT_EQ(layer("regions").GetFeatureCount(), 1);
    EXPECT_STREQ(layer("buildings").GetMetadataItem("IDENTIFIER"), "Buildings");
    EXPECT_EQ(calls_.failures(), 0U) << calls_.why();
}

TEST_F(ProjectLayersTest, TheLocalPlaneLiesOnTheEarth) {
    const OGRSpatialReference* plane = layer("lots").GetSpatialRef();
    ASSERT_NE(plane, nullptr);
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> toLonLat(
        OGRCreateCoordinateTransformation(plane, &wgs84));
    double x = 200, y = 30;
    ASSERT_TRUE(toLonLat->Transform(1, &x, &y));
    const LonLat truth = threeHouses().frame.lonLatFromLocal({200, 30});
    EXPECT_NEAR(x, truth.lonDeg, 1e-9);
    EXPECT_NEAR(y, truth.latDeg, 1e-9);
}

TEST_F(ProjectLayersTest, PlacesReadFromTheFileHaveTheSourcesOfTheProject) {
    const Project project = ProjectFile::open(file_).value().project();
    ASSERT_FALSE(project.places.empty());
    NoProgress quiet;
    const auto read = readPlaces(file_, {}, project.city->frame, quiet, {}).value();
    ASSERT_EQ(read.places.size(), project.places.size());
    for (const Place& place : project.places)
        EXPECT_EQ(findPlace(read.places, place.name).value().source, place.source);
}

TEST_F(ProjectLayersTest, EveryPolygonLayerHasAStyle) {
    for (const char* name : {"buildings", "proposals", "lots", "regions"}) {
        layer("layer_styles").SetAttributeFilter((std::string("f_table_name = '") + name + "'").c_str());
        const OGRFeatureUniquePtr style(layer("layer_styles").GetNextFeature());
        ASSERT_TRUE(style) << name;
        EXPECT_EQ(style->GetFieldAsInteger("useAsDefault"), 1);
        CPLXMLNode* tree = CPLParseXMLString(style->GetFieldAsString("styleQML"));
        EXPECT_NE(CPLGetXMLNode(tree, "=qgis.renderer-v2.symbols.symbol"), nullptr) << name;
        CPLDestroyXMLNode(tree);
    }
}

TEST_F(ProjectLayersTest, AResultIsARasterInItsPlace) {
    const std::string name = "GPKG:" + file_.string() + ":result_1_1";
    const GDALDatasetUniquePtr raster(GDALDataset::Open(name.c_str(), GDAL_OF_RASTER));
    ASSERT_TRUE(raster) << calls_.why();
    const auto result = sampleProject().results[0];
    ASSERT_EQ(raster->GetRasterXSize(), result->grid.columns);
    ASSERT_EQ(raster->GetRasterYSize(), result->grid.rows);
    std::array<double, 6> corner{};
    ASSERT_EQ(raster->GetGeoTransform(corner.data()), CE_None);
    EXPECT_EQ(corner[0], -10);
    EXPECT_EQ(corner[3], 60);
    EXPECT_EQ(corner[1], 2);
    for (const auto& [column, row] : {std::pair{1, 0}, std::pair{299, 39}, std::pair{257, 3}}) {
        float value = 0;
        ASSERT_EQ(raster->GetRasterBand(1)->RasterIO(GF_Read, column, result->grid.rows - 1 - row, 1, 1,
                                                     &value, 1, 1, GDT_Float32, 0, 0, nullptr),
                  CE_None);
        const float truth = result->layers[0].values[result->grid.index(column, row)];
        EXPECT_EQ(value, std::isnan(truth) ? -9999 : truth);
    }
}

// The centre of the cell inside the first edge of a counter-clockwise ring along cells.
glm::dvec2 besideFirstEdge(const OGRLinearRing& ring, double halfCellM) {
    const glm::dvec2 from(ring.getX(0), ring.getY(0)), to(ring.getX(1), ring.getY(1));
    const glm::dvec2 along = (to - from) / glm::length(to - from);
    return from + halfCellM * (along + glm::dvec2(-along.y, along.x));
}

TEST_F(ProjectLayersTest, ItsBandsAreColouredPolygonsOfTheSameArea) {
    const auto result = sampleProject().results[0];
    double cells = 0, polygons = 0;
    for (const float value : result->layers[0].values)
        cells += std::isnan(value) ? 0 : result->grid.cellM * result->grid.cellM;
    OGRLayer& bands = layer("result_1_1_bands");
    for (const auto& feature : bands) {
        const OGRPolygon& shape = *feature->GetGeometryRef()->toPolygon();
        EXPECT_DOUBLE_EQ(shape.get_Area(), feature->GetFieldAsDouble("area_m2"));
        polygons += shape.get_Area();
        const glm::dvec2 inside = besideFirstEdge(*shape.getExteriorRing(), result->grid.cellM / 2);
        const int column = int((inside.x - result->grid.westM) / result->grid.cellM);
        const int row = int((inside.y - result->grid.southM) / result->grid.cellM);
        const float value = result->layers[0].values[result->grid.index(column, row)];
        EXPECT_GE(value, feature->GetFieldAsDouble("low"));
        EXPECT_LE(value, feature->GetFieldAsDouble("high"));
    }
    EXPECT_NEAR(polygons, cells, 1e-6 * cells);
    layer("layer_styles").SetAttributeFilter("f_table_name = 'result_1_1_bands'");
    EXPECT_EQ(layer("layer_styles").GetFeatureCount(), 1);
}

TEST_F(ProjectLayersTest, BandsGoWithTheirResult) {
    {
        auto file = ProjectFile::open(file_).value();
        Project project = file.project();
        project.results.clear();
        ASSERT_TRUE(file.save(project));
    }
    const GDALDatasetUniquePtr after(GDALDataset::Open(file_.c_str(), GDAL_OF_VECTOR));
    EXPECT_EQ(after->GetLayerByName("result_1_1_bands"), nullptr);
    OGRLayer& styles = *after->GetLayerByName("layer_styles");
    styles.SetAttributeFilter("f_table_name LIKE 'result%'");
    EXPECT_EQ(styles.GetFeatureCount(), 0);
}

}  // namespace
}  // namespace noonmark::tests
