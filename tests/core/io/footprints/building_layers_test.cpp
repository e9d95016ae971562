#include <gmock/gmock.h>

#include "tests/core/io/footprint_files.h"

// Which polygon layers of a file are buildings.
namespace noonmark {
namespace {

using namespace tests;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

struct TestLayer {
    std::string name;
    std::string field;  // empty: none
    float sideM;        // of its squares, 20 m apart: 20 leaves no gaps
};

// Each layer has 25 squares.
void writeLayers(const std::filesystem::path& file, const std::vector<TestLayer>& layers) {
    const GdalCalls calls;
    OGRSpatialReference system;
    system.importFromEPSG(32618);
    const GDALDatasetUniquePtr dataset(
        GetGDALDriverManager()->GetDriverByName("GPKG")->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    for (const TestLayer& wanted : layers) {
        OGRLayer* layer = dataset->CreateLayer(wanted.name.c_str(), &system, wkbPolygon, nullptr);
        if (!wanted.field.empty()) {
            OGRFieldDefn field(wanted.field.c_str(), OFTReal);
            layer->CreateField(&field);
        }
        for (int i = 0; i < 25; ++i) {
            const double x = 585000 + 20 * (i % 5), y = 4511000 + 20 * (i / 5), side = double(wanted.sideM);
            OGRLinearRing line;
            for (const auto& [dx, dy] :
                 {std::pair(0.0, 0.0), {side, 0.0}, {side, side}, {0.0, side}, {0.0, 0.0}})
                line.addPoint(x + dx, y + dy);
            OGRPolygon polygon;
            polygon.addRing(&line);
            OGRFeature made(layer->GetLayerDefn());
            if (!wanted.field.empty()) made.SetField(0, 12.0);
            made.SetGeometry(&polygon);
            ASSERT_EQ(layer->CreateFeature(&made), OGRERR_NONE);
        }
    }
}

class BuildingLayers : public ReadFootprints {
protected:
    FilePiece readLayers(const std::vector<TestLayer>& layers) {
        writeLayers(folder.path("city.gpkg"), layers);
        return read(folder.path("city.gpkg"));
    }
    static std::vector<std::string> leftOut(const FilePiece& piece) {
        std::vector<std::string> names;
        for (const Warning& warning : piece.warnings)
            if (warning.kind == WarningKind::leftOut && warning.what.find("layer") != std::string::npos)
                names.push_back(warning.where);
        return names;
    }
};

TEST_F(BuildingLayers, TheNameDecides) {
    const FilePiece piece = readLayers({{"plots", "", 19}, {"gebäude", "", 10}, {"zones", "height", 10}});
    EXPECT_EQ(piece.buildings.size(), 25U);
    EXPECT_THAT(leftOut(piece), ElementsAre("plots", "zones"));
    EXPECT_THAT(whats(piece.warnings), Contains(HasSubstr("--layer")));
}

TEST_F(BuildingLayers, FieldsDecideWhereNoNameDoes) {
    const FilePiece piece = readLayers({{"a", "owner", 10}, {"b", "height", 10}});
    EXPECT_EQ(piece.buildings.size(), 25U);
    EXPECT_THAT(leftOut(piece), ElementsAre("a"));
    EXPECT_EQ(piece.buildings.at(0)->parts.at(0).topM, 12);
}

TEST_F(BuildingLayers, PolygonsWithoutGapsAreNoBuildings) {
    const FilePiece piece = readLayers({{"a", "", 20}, {"b", "", 10}});
    EXPECT_EQ(piece.buildings.size(), 25U);
    EXPECT_THAT(leftOut(piece), ElementsAre("a"));
}

// The highest that may be built in each zone.
TEST_F(BuildingLayers, ZonesWithHeightsAreNoBuildings) {
    EXPECT_THAT(leftOut(readLayers({{"Bauten", "", 10}, {"Bebauungsplan", "Hoehe", 20}})),
                ElementsAre("Bebauungsplan"));
    EXPECT_THAT(leftOut(readLayers({{"a", "", 10}, {"b", "max_height", 20}})), ElementsAre("b"));
}

TEST_F(BuildingLayers, OneThatIsLeftOutCanBeNamed) {
    settings.layer = "plots";
    EXPECT_EQ(readLayers({{"plots", "", 19}, {"buildings", "", 10}}).buildings.size(), 25U);
}

TEST_F(BuildingLayers, TheOnlyOneIsTakenWhateverItsName) {
    const FilePiece piece = readLayers({{"plots", "", 19}});
    EXPECT_EQ(piece.buildings.size(), 25U);
    EXPECT_TRUE(leftOut(piece).empty());
}

TEST_F(BuildingLayers, SeveralOfBuildingsAreAllRead) {
    const FilePiece piece =
        readLayers({{"houses_north", "", 10}, {"houses_south", "", 10}, {"lots", "", 19}});
    EXPECT_EQ(piece.features, 50U);
    EXPECT_THAT(leftOut(piece), ElementsAre("lots"));
}

TEST_F(BuildingLayers, UnknownOnesAreAllReadAndReported) {
    const FilePiece piece = readLayers({{"a", "", 10}, {"b", "", 10}});
    EXPECT_EQ(piece.features, 50U);
    EXPECT_THAT(whats(piece.warnings), Contains(HasSubstr("one of several polygon layers")));
}

}  // namespace
}  // namespace noonmark
