// A file geodatabase as GDAL writes it: a folder with a system of tables, of which one holds the buildings.

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogrsf_frmts.h>

#include "core/base/gdal_calls.h"
#include "core/geo/lon_lat.h"
#include "core/io/read_city.h"
#include "tests/core/io/city_reading.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

class FileGeodatabase : public tests::CityReading {
protected:
    void SetUp() override {
        const GdalCalls calls;
        driver_ = GetGDALDriverManager()->GetDriverByName("OpenFileGDB");
        if (driver_ == nullptr || driver_->GetMetadataItem(GDAL_DCAP_CREATE) == nullptr)
            GTEST_SKIP() << "this GDAL writes no file geodatabase";
        writeTown();
    }

    std::filesystem::path town_;
    tests::TemporaryFolder folder;

private:
    // Squares of 20 m at 50.1 N 14.4 E, in metres of Krovak's grid, whose axes point south-west and so on:
    // three buildings with a height, and a plot around them.
    void writeTown() {
        const GdalCalls calls;
        town_ = folder.path("town.gdb");
        const GDALDatasetUniquePtr made(driver_->Create(town_.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        ASSERT_TRUE(made);
        OGRSpatialReference krovak;
        ASSERT_EQ(krovak.importFromEPSG(5514), OGRERR_NONE);
        krovak.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        OGRLayer* buildings = made->CreateLayer("Budovy", &krovak, wkbMultiPolygon);
        OGRLayer* plots = made->CreateLayer("Parcely", &krovak, wkbMultiPolygon);
        OGRFieldDefn height("vyska", OFTReal);
        ASSERT_EQ(buildings->CreateField(&height), OGRERR_NONE);
        for (int i = 0; i < 3; ++i) add(*buildings, -744000 + 50 * i, 20, 10 + i);
        add(*plots, -744010, 200, {});
    }

    static void add(OGRLayer& layer, double westM, double sideM, std::optional<double> heightM) {
        constexpr double southM = -1041000;
        OGRLinearRing ring;
        for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}})
            ring.addPoint(westM + x * sideM, southM + y * sideM);
        OGRPolygon polygon;
        polygon.addRing(&ring);
        OGRMultiPolygon all;
        all.addGeometry(&polygon);
        const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer.GetLayerDefn()));
        feature->SetGeometry(&all);
        if (heightM) feature->SetField("vyska", *heightM);
        ASSERT_EQ(layer.CreateFeature(feature.get()), OGRERR_NONE);
    }

    GDALDriver* driver_ = nullptr;
};

TEST_F(FileGeodatabase, IsReadByTheNameOfItsFolder) {
    for (const std::string& name : {town_.string(), town_.string() + "/"}) {
        const CityRead town = read({name});
        EXPECT_EQ(town.format, "file geodatabase");
        ASSERT_EQ(town.city.buildings.size(), 3U) << "and not the plot";
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(topM(*town.city.buildings[i]), 10 + float(i));
            EXPECT_NEAR(area(town.city.buildings[i]->parts[0].footprint), 400, 1);
        }
        EXPECT_LT(computeGreatCircleM(town.city.frame.origin(), {14.4, 50.1}), 5000);
    }
}

TEST_F(FileGeodatabase, ThatIsCutIsRefused) {
    for (const auto& entry : std::filesystem::directory_iterator(town_))
        if (entry.path().extension() == ".gdbtable" && entry.file_size() > 100)
            std::filesystem::resize_file(entry.path(), entry.file_size() / 2);
    NoProgress quiet;
    const auto read = readCity({town_}, settings, quiet, {});
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().text(), HasSubstr("town.gdb"));
}

}  // namespace
}  // namespace noonmark
