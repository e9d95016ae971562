#include <gtest/gtest.h>

#include <cmath>

#include "core/io/pieces/read_part.h"
#include "tests/core/io/cityjson_fixtures.h"
#include "tests/core/io/piece_checks.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using tests::CityJsonMaker;
using tests::expectClosedSolid;
using tests::Json;
using tests::read;
using tests::readText;
using tests::warns;

// The only part of the only building.
Part onlyPart(const Result<FilePiece>& piece) {
    const Part none;
    EXPECT_TRUE(piece) << piece.error().text();
    if (!piece || piece->buildings.size() != 1 || piece->buildings[0]->parts.size() != 1) {
        ADD_FAILURE() << "not one building of one part";
        return none;
    }
    return piece->buildings[0]->parts[0];
}

TEST(ReadCityJson, ACubeInEveryVersion) {
    CityJsonMaker maker;
    maker.addBuilding("cube", maker.boxSolid({0, 0, 0}, {10, 20, 30}));
    for (const char* version : {"1.0", "1.1", "2.0"})
        for (const char* crs :
             {"urn:ogc:def:crs:EPSG::7415", "https://www.opengis.net/def/crs/EPSG/0/7415", "EPSG:28992"}) {
            SCOPED_TRACE(version);
            const auto piece = read(maker.document(version, crs));
            const Part part = onlyPart(piece);
            expectClosedSolid(part, 6000);
            EXPECT_NEAR(part.bottomM, 0, 1e-4);
            EXPECT_NEAR(part.topM, 30, 1e-3);
            EXPECT_NEAR(area(part.footprint), 200, 0.1);
            EXPECT_EQ(part.footprint.outer.size(), 4U);
            EXPECT_EQ(part.heightSource, HeightSource::mesh);
            EXPECT_FALSE(part.isOverhanging);
            // By the approximation of Schreutelkamp and Strang van Hees, accurate to a metre.
            EXPECT_NEAR(piece->frame->origin().lonDeg, 4.888046, 2e-5);
            EXPECT_NEAR(piece->frame->origin().latDeg, 52.369918, 2e-5);
            EXPECT_NEAR(piece->frame->originElevationM(), 2, 1e-6);
            EXPECT_EQ(piece->format, std::string("CityJSON ") + version);
            EXPECT_TRUE(piece->warnings.empty()) << piece->warnings[0].what;
        }
}

TEST(ReadCityJson, OldVersionWithoutTransform) {
    CityJsonMaker maker;
    maker.addBuilding("cube", maker.boxSolid({0, 0, 0}, {10, 20, 30}));
    Json document = maker.document("1.0", "urn:ogc:def:crs:EPSG::7415");
    document.erase("transform");
    document["CityObjects"]["cube"]["geometry"][0]["lod"] = 2.2;
    for (Json& vertex : document["vertices"])
        vertex = {121000 + vertex[0].get<double>() / 1000, 487000 + vertex[1].get<double>() / 1000,
                  vertex[2].get<double>() / 1000};
    expectClosedSolid(onlyPart(read(document)), 6000);
}

TEST(ReadCityJson, SaysWhatGroundABuildingStandsOn) {
    // On a hillside: without terrain readCity() subtracts these elevations, otherwise light would pass under
    // the buildings.
    CityJsonMaker maker;
    maker.addBuilding("low", maker.boxSolid({0, 0, 0}, {10, 20, 30}));
    maker.addBuilding("high", maker.boxSolid({50, 0, 12}, {60, 20, 40}));
    const auto piece = read(maker.document());
    ASSERT_TRUE(piece.has_value());
    ASSERT_EQ(piece->groundM.size(), 2U);
    ASSERT_TRUE(piece->groundM[0] && piece->groundM[1]);
    EXPECT_NEAR(std::abs(*piece->groundM[0] - *piece->groundM[1]), 12, 1e-3);
}

TEST(ReadCityJson, TrueNorthIsUpAndMetresAreMetres) {
    // RD's north is 24' east of true north at Amsterdam's longitude west of the centre: a wall along it
    // deviates by that angle.
    CityJsonMaker maker;
    maker.addBuilding("wall", maker.boxSolid({0, 0, 0}, {1, 1000, 30}));
    const Part part = onlyPart(read(maker.document()));
    const Box2 box = bounds(part.footprint);
    EXPECT_NEAR(double(box.high.y - box.low.y), 1000, 0.2);
    const double leanDeg = std::atan((double(box.high.x - box.low.x) - 1) / 1000) * 57.29578;
    EXPECT_NEAR(leanDeg, 0.40, 0.05);
}

TEST(ReadCityJson, AShaftThroughATower) {
    CityJsonMaker maker;
    const int outer = maker.addBox({0, 0, 0}, {10, 10, 30});
    const int inner = maker.addBox({3, 3, 0}, {7, 7, 30});
    Json shell = CityJsonMaker::boxShell(outer);
    const Json hole = CityJsonMaker::boxShell(inner, true);
    shell[0].push_back(hole[0][0]);  // the bottom and the top have holes; the shaft's walls face inward
    shell[1].push_back(hole[1][0]);
    for (std::size_t i = 2; i < 6; ++i) shell.push_back(hole[i]);
    maker.addBuilding("shaft", CityJsonMaker::solid(Json::array({shell})));
    const Part part = onlyPart(read(maker.document()));
    expectClosedSolid(part, 3000 - 16 * 30);
    ASSERT_EQ(part.footprint.holes.size(), 1U);
    EXPECT_NEAR(area(part.footprint), 84, 0.1);
}

TEST(ReadCityJson, AnLShapeKeepsItsNotch) {
    CityJsonMaker maker;
    const std::vector<glm::dvec2> corners{{0, 0}, {20, 0}, {20, 5}, {5, 5}, {5, 20}, {0, 20}};
    Json top = Json::array();
    Json bottom = Json::array();
    for (const glm::dvec2 corner : corners) bottom.push_back(maker.addVertex({corner, 0}));
    for (const glm::dvec2 corner : corners) top.push_back(maker.addVertex({corner, 12}));
    Json shell =
        Json::array({Json::array({top}), Json::array({Json(Json::array_t(bottom.rbegin(), bottom.rend()))})});
    for (std::size_t i = 0; i < 6; ++i) {
        const std::size_t j = (i + 1) % 6;
        shell.push_back(Json::array({Json::array({bottom[i], bottom[j], top[j], top[i]})}));
    }
    maker.addBuilding("l", CityJsonMaker::solid(Json::array({shell})));
    const Part part = onlyPart(read(maker.document()));
    expectClosedSolid(part, 175 * 12);
    EXPECT_EQ(part.footprint.outer.size(), 6U);
    EXPECT_NEAR(area(part.footprint), 175, 0.1);
}

TEST(ReadCityJson, ACavityIsHollowButDoesNotHang) {
    for (const bool inward : {true, false}) {  // some files orient inner shells the wrong way
        CityJsonMaker maker;
        const int outer = maker.addBox({0, 0, 0}, {10, 10, 30});
        const int inner = maker.addBox({2, 2, 5}, {8, 8, 25});
        maker.addBuilding("hollow",
                          CityJsonMaker::solid(Json::array(
                              {CityJsonMaker::boxShell(outer), CityJsonMaker::boxShell(inner, inward)})));
        const Part part = onlyPart(read(maker.document()));
        expectClosedSolid(part, 3000 - 36 * 20);
        EXPECT_FALSE(part.isOverhanging);
        EXPECT_TRUE(part.footprint.holes.empty());
    }
}

TEST(ReadCityJson, PartsOfABuildingAreOneBuilding) {
    CityJsonMaker maker;
    maker.objects["house"] = {{"type", "Building"},
                              {"attributes", {{"name", "Town hall"}, {"status", "built"}}},
                              {"children", {"low", "high", "bridge"}}};
    maker.addBuilding("low", maker.boxSolid({0, 0, 0}, {10, 10, 12}), "BuildingPart");
    maker.addBuilding("high", maker.boxSolid({2, 2, 12}, {8, 8, 40}), "BuildingPart");
    maker.addBuilding("bridge", maker.boxSolid({10, 2, 8}, {20, 8, 11}), "BuildingPart");
    for (const char* part : {"low", "high", "bridge"}) maker.objects[part]["parents"] = {"house"};
    const auto piece = read(maker.document());
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_EQ(piece->buildings.size(), 1U);
    const Building& building = *piece->buildings[0];
    EXPECT_EQ(building.sourceId, "house");
    EXPECT_EQ(building.name, "Town hall");
    EXPECT_EQ(building.status, "built");
    ASSERT_EQ(building.parts.size(), 3U);
    for (const Part& part : building.parts)
        EXPECT_EQ(part.isOverhanging, part.sourceId == "bridge") << part.sourceId;
}

TEST(ReadCityJson, MultiSolidsAndSurfaces) {
    CityJsonMaker maker;
    const int a = maker.addBox({0, 0, 0}, {10, 10, 10});
    const int b = maker.addBox({20, 0, 0}, {30, 10, 20});
    const Json shellA = CityJsonMaker::boxShell(a);
    const Json shellB = CityJsonMaker::boxShell(b);
    Json both = shellA;
    both.insert(both.end(), shellB.begin(), shellB.end());
    maker.addBuilding("multi", {{"type", "MultiSolid"},
                                {"lod", "2"},
                                {"boundaries", {Json::array({shellA}), Json::array({shellB})}}});
    maker.addBuilding("composite", {{"type", "CompositeSolid"},
                                    {"lod", "2"},
                                    {"boundaries", {Json::array({shellA}), Json::array({shellB})}}});
    maker.addBuilding("surfaces", {{"type", "MultiSurface"}, {"lod", "2"}, {"boundaries", both}});
    maker.addBuilding("surfaces2", {{"type", "CompositeSurface"}, {"lod", "2"}, {"boundaries", both}});
    const auto piece = read(maker.document());
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_EQ(piece->buildings.size(), 4U);
    for (const auto& building : piece->buildings) {
        ASSERT_EQ(building->parts.size(), 2U) << building->sourceId;
        expectClosedSolid(building->parts[0], 1000);
        expectClosedSolid(building->parts[1], 2000);
    }
}

TEST(ReadCityJson, LevelOfDetail) {
    CityJsonMaker maker;
    maker.addBuilding("cube", maker.boxSolid({0, 0, 0}, {10, 10, 10}, "1.2"));
    maker.objects["cube"]["geometry"].push_back(maker.boxSolid({0, 0, 0}, {10, 10, 22}, "2.2"));
    maker.objects["cube"]["geometry"].push_back({{"type", "MultiPoint"}, {"lod", "3"}, {"boundaries", {0}}});
    const Json document = maker.document();
    EXPECT_NEAR(onlyPart(read(document)).topM, 22, 1e-3);
    ReadSettings settings;
    settings.lod = "1.2";
    EXPECT_NEAR(onlyPart(read(document, settings)).topM, 10, 1e-3);
    settings.lod = "1.3";
    const auto near = read(document, settings);
    EXPECT_NEAR(onlyPart(near).topM, 10, 1e-3);
    EXPECT_TRUE(warns(*near, "level of detail is missing"));
    settings.lod = "high";
    EXPECT_FALSE(read(document, settings));
}

TEST(ReadCityJson, FootprintsAreExtruded) {
    CityJsonMaker maker;
    const int first = maker.addBox({0, 0, 0}, {10, 10, 1});
    const Json flat{
        {"type", "MultiSurface"},
        {"lod", "0"},
        {"boundaries", Json::array({Json::array({Json::array({first, first + 1, first + 3, first + 2})})})}};
    for (const char* id : {"a measured", "b storeys", "c nothing", "d broken"}) maker.addBuilding(id, flat);
    maker.objects["a measured"]["attributes"] = {{"measuredHeight", 17.5}};
    maker.objects["b storeys"]["attributes"] = {{"storeysAboveGround", 4}};
    maker.objects["d broken"]["attributes"] = {{"measuredHeight", -3}};
    const auto piece = read(maker.document());
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_EQ(piece->buildings.size(), 4U);
    const double heights[] = {17.5, 12.8, 9.6, 9.6};
    const HeightSource sources[] = {HeightSource::measured, HeightSource::levels, HeightSource::assumed,
                                    HeightSource::assumed};
    for (std::size_t i = 0; i < 4; ++i) {
        const Part& part = piece->buildings[i]->parts.at(0);
        EXPECT_NEAR(part.topM - part.bottomM, heights[i], 1e-3);
        EXPECT_EQ(part.heightSource, sources[i]);
        EXPECT_EQ(part.mesh, nullptr);
        EXPECT_NEAR(area(part.footprint), 100, 0.1);
    }
    EXPECT_TRUE(warns(*piece, "a height of zero or less"));
    EXPECT_TRUE(warns(*piece, "the default is used"));
}

// The elevations of 3DBAG's LoD 0 are above NAP: the height is the difference from the ground.
TEST(ReadCityJson, HeightsOverTheGroundsElevation) {
    CityJsonMaker maker;
    const int first = maker.addBox({0, 0, 0}, {10, 10, 1});
    const Json flat{
        {"type", "MultiSurface"},
        {"lod", "0"},
        {"boundaries", Json::array({Json::array({Json::array({first, first + 1, first + 3, first + 2})})})}};
    maker.addBuilding("pand", flat);
    maker.objects["pand"]["attributes"] = {
        {"b3_h_dak_max", 19.5}, {"b3_h_dak_70p", 15.25}, {"b3_h_maaiveld", 2.5}};
    const auto piece = read(maker.document());
    ASSERT_TRUE(piece) << piece.error().text();
    const Part& part = piece->buildings.at(0)->parts.at(0);
    EXPECT_NEAR(part.topM - part.bottomM, 12.75, 1e-3);
    EXPECT_EQ(part.heightSource, HeightSource::measured);
    ASSERT_EQ(piece->heights.fields.size(), 1U);
    EXPECT_EQ(piece->heights.fields[0].field, "b3_h_dak_70p - b3_h_maaiveld");
    EXPECT_EQ(piece->heights.fields[0].meaning, "70th percentile of the roof");
}

TEST(ReadCityJson, ATinBecomesTheTerrain) {
    CityJsonMaker maker;
    Json triangles = Json::array();
    constexpr int side = 21;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) maker.addVertex({x * 5.0, y * 5.0, x * 0.5});
    for (int y = 0; y + 1 < side; ++y)
        for (int x = 0; x + 1 < side; ++x) {
            const int at = y * side + x;
            triangles.push_back(Json::array({Json::array({at, at + 1, at + side + 1})}));
            triangles.push_back(Json::array({Json::array({at, at + side + 1, at + side})}));
        }
    maker.addBuilding("ground", {{"type", "CompositeSurface"}, {"lod", "1"}, {"boundaries", triangles}},
                      "TINRelief");
    maker.addBuilding("house", maker.boxSolid({40, 40, 4}, {50, 50, 20}));
    const auto piece = read(maker.document());
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_NE(piece->terrain, nullptr);
    EXPECT_EQ(piece->buildings.size(), 1U);
    EXPECT_NEAR(piece->terrain->grid.cellM, 2.4, 0.2);
    for (const float z : piece->terrain->elevationM) EXPECT_TRUE(std::isfinite(z));
    // The slope is 1 in 10 along x; local z is 0 at the base of the only building.
    const glm::dvec2 middle =
        (glm::dvec2(bounds(*piece->buildings[0]).low) + glm::dvec2(bounds(*piece->buildings[0]).high)) / 2.0;
    EXPECT_NEAR(elevationAt(*piece->terrain, middle), 0.5, 0.1);
    EXPECT_NEAR(elevationAt(*piece->terrain, middle + glm::dvec2(20, 0)), 2.5, 0.1);
    EXPECT_FALSE(piece->buildings[0]->parts[0].isOverhanging);
}

TEST(ReadCityJson, Sequence) {
    CityJsonMaker maker;
    Json header = maker.document();
    std::string text = header.dump() + "\n";
    for (int i = 0; i < 3; ++i) {
        CityJsonMaker feature;
        const std::string id = "b" + std::to_string(i);
        feature.addBuilding(id, feature.boxSolid({i * 20.0, 0, 0}, {i * 20.0 + 10, 10, 10.0 + i}));
        text += Json{{"type", "CityJSONFeature"},
                     {"id", id},
                     {"CityObjects", feature.objects},
                     {"vertices", feature.vertices}}
                    .dump() +
                "\n";
    }
    text += "{\"type\":\"CityJSONFeature\",\"CityObj\n\n[]\n";
    const auto piece = readText(text);
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->format, "CityJSONSeq 2.0");
    ASSERT_EQ(piece->buildings.size(), 3U);
    for (int i = 0; i < 3; ++i)
        expectClosedSolid(piece->buildings[std::size_t(i)]->parts.at(0), 100 * (10 + i));
    const auto groups = groupWarnings(piece->warnings);
    ASSERT_EQ(groups.size(), 1U);
    EXPECT_EQ(groups[0].where, (std::vector<std::string>{"city.json: line 5", "city.json: line 7"}));
}

TEST(ReadCityJson, FeetByTheVerticalSystem) {
    CityJsonMaker maker;
    maker.addBuilding("cube", maker.boxSolid({0, 0, 0}, {100, 100, 1000}));
    Json document = maker.document("2.0", "EPSG:2263+6360");
    document["transform"]["translate"] = {987000, 211000, 0};
    const Part part = onlyPart(read(document));
    EXPECT_NEAR(part.topM, 1000 * 1200.0 / 3937, 0.01);
    EXPECT_NEAR(area(part.footprint), 10000 * std::pow(1200.0 / 3937, 2), 1);
    document["metadata"]["referenceSystem"] = "EPSG:2263";
    const auto assumed = read(document);
    EXPECT_NEAR(onlyPart(assumed).topM, 1000 * 1200.0 / 3937, 0.01);
    EXPECT_TRUE(warns(*assumed, "no unit"));
}

TEST(ReadCityJson, WhatIsLeftOutIsReported) {
    CityJsonMaker maker;
    maker.addBuilding("cube", maker.boxSolid({0, 0, 0}, {10, 10, 10}));
    maker.addBuilding("cube2", maker.boxSolid({30, 0, 0}, {40, 10, 10}));
    maker.addBuilding("far", maker.boxSolid({90000, 0, 0}, {90010, 10, 10}));
    maker.addBuilding("bench", maker.boxSolid({20, 0, 0}, {21, 1, 5}), "CityFurniture");
    maker.addBuilding("stamp", {{"type", "GeometryInstance"}, {"template", 0}, {"boundaries", {0}}});
    maker.objects["empty"] = {{"type", "Building"}};
    maker.objects["odd"] = 5;
    const auto piece = read(maker.document());
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->buildings.size(), 2U);
    EXPECT_EQ(piece->features, 7U);
    for (const char* what : {"far from the middle", "CityFurniture", "geometry templates",
                             "no usable geometry", "without a type"})
        EXPECT_TRUE(warns(*piece, what)) << what;
}

}  // namespace
}  // namespace noonmark
