#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/city/terrain/terrain.h"
#include "core/io/files/plain_file.h"
#include "tests/core/io/citygml_fixtures.h"
#include "tests/core/io/piece_checks.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using tests::bonn;
using tests::cityGml;
using tests::expectClosedSolid;
using tests::gmlBoxFaces;
using tests::gmlBoxSolid;
using tests::gmlBuilding;
using tests::gmlMembers;
using tests::gmlMultiSurface;
using tests::gmlPolygon;
using tests::gmlSolid;
using tests::readGmlText;
using tests::sharedData;
using tests::TemporaryFolder;
using tests::warns;

double riseOf(const Building& building) {
    const auto lowest = std::ranges::min_element(building.parts, {}, &Part::bottomM);
    return double(topM(building)) - double(lowest->bottomM);
}

// The only part of the only building.
Part partOf(const Result<FilePiece>& piece) {
    EXPECT_TRUE(piece) << piece.error().text();
    if (!piece || piece->buildings.size() != 1 || piece->buildings[0]->parts.size() != 1) {
        ADD_FAILURE() << "not one building of one part";
        return {};
    }
    return piece->buildings[0]->parts[0];
}

TEST(ReadCityGml, ACubeInEveryVersion) {
    for (const char* version : {"1.0", "2.0", "3.0"}) {
        SCOPED_TRACE(version);
        const auto piece =
            readGmlText(cityGml(gmlBuilding("cube", gmlBoxSolid({0, 0, 0}, {10, 20, 30})), version));
        const Part part = partOf(piece);
        expectClosedSolid(part, 6000);
        EXPECT_NEAR(part.topM - part.bottomM, 30, 1e-3);
        EXPECT_EQ(piece->format, std::string("CityGML ") + version);
        EXPECT_EQ(piece->buildings[0]->sourceId, "cube");
        EXPECT_NEAR(piece->frame->originElevationM(), 60, 1e-6);
        EXPECT_NEAR(piece->frame->origin().latDeg, 50.735, 0.01);
        EXPECT_TRUE(piece->warnings.empty()) << piece->warnings[0].what;
    }
}

TEST(ReadCityGml, IsRecognisedByItsContent) {
    const TemporaryFolder folder;
    for (const char* name : {"city.gml", "city.xml", "city.dat"}) {
        const auto format = detectFormat(folder.file(name, cityGml("")));
        ASSERT_TRUE(format) << format.error().text();
        EXPECT_EQ((*format)->name, "CityGML");
    }
}

TEST(ReadCityGml, OfSeveralLevelsOfDetailTheWantedOneCounts) {
    const std::string text = cityGml(gmlBuilding(
        "house", gmlBoxSolid({0, 0, 0}, {10, 10, 8}, 1) + gmlBoxSolid({0, 0, 0}, {10, 10, 9}, 2)));
    EXPECT_NEAR(riseOf(*readGmlText(text)->buildings.at(0)), 9, 1e-3);
    EXPECT_EQ(readGmlText(text)->buildings[0]->parts.size(), 1U);
    EXPECT_NEAR(riseOf(*readGmlText(text, {.lod = "1"})->buildings.at(0)), 8, 1e-3);
    EXPECT_TRUE(warns(*readGmlText(text, {.lod = "3"}), "the wanted level of detail is missing"));
}

TEST(ReadCityGml, WallsAndRoofsMakeABodyWhereThereIsNoSolid) {
    const auto faces = gmlBoxFaces(bonn, bonn + glm::dvec3(10, 10, 7));
    std::string surfaces;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const char* kind = i == 0 ? "GroundSurface" : i == 1 ? "RoofSurface" : "WallSurface";
        surfaces += fmt::format(
            "<bldg:boundedBy><bldg:{0}><bldg:lod2MultiSurface>{1}</bldg:lod2MultiSurface></bldg:{0}>"
            "</bldg:boundedBy>",
            kind, gmlMultiSurface({faces[i]}));
    }
    expectClosedSolid(partOf(readGmlText(cityGml(gmlBuilding("house", surfaces)))), 700);
}

TEST(ReadCityGml, SolidsReferToSurfacesBeforeAndAfterThem) {
    const auto faces = gmlBoxFaces(bonn, bonn + glm::dvec3(10, 10, 7), "f");
    const std::string walls = "<bldg:boundedBy><bldg:WallSurface><bldg:lod2MultiSurface>" +
                              gmlMultiSurface(faces) +
                              "</bldg:lod2MultiSurface></bldg:WallSurface></bldg:boundedBy>";
    const std::string solid =
        "<bldg:lod2Solid>" + gmlSolid({"#f0", "#f1", "#f2", "#f3", "#f4", "#f5"}) + "</bldg:lod2Solid>";
    for (const std::string& content : {walls + solid, solid + walls})
        expectClosedSolid(partOf(readGmlText(cityGml(gmlBuilding("house", content)))), 700);
}

TEST(ReadCityGml, ReferencesThatLeadNowhereAreListed) {
    auto faces = gmlBoxFaces(bonn, bonn + glm::dvec3(10, 10, 7));
    faces.emplace_back("#nowhere");
    faces.emplace_back(
        "<gml:OrientableSurface><gml:baseSurface xlink:href=\"https://example.org/a.gml#b\"/>"
        "</gml:OrientableSurface>");
    const auto piece = readGmlText(
        cityGml(gmlBuilding("house", "<bldg:lod2Solid>" + gmlSolid(faces) + "</bldg:lod2Solid>")));
    expectClosedSolid(partOf(piece), 700);
    EXPECT_TRUE(warns(*piece, "refer to ids that the object does not have"));
    EXPECT_TRUE(warns(*piece, "refer to other files, which are not opened"));
}

// Two houses of 10 x 10 m share the wall between them: a surface of one, to which the other refers; what
// refers comes last, then first.
TEST(ReadCityGml, SurfacesOfOtherBuildingsAreFoundInTheFile) {
    std::vector<std::string> other = gmlBoxFaces(bonn + glm::dvec3(10, 0, 0), bonn + glm::dvec3(20, 10, 6));
    other[4] =
        "<gml:OrientableSurface orientation=\"-\"><gml:baseSurface xlink:href=\"#shared5\"/>"
        "</gml:OrientableSurface>";  // at x = 10
    const auto solidOf = [](const std::vector<std::string>& faces) {
        return "<bldg:lod2Solid>" + gmlSolid(faces) + "</bldg:lod2Solid>";
    };
    const std::string owner =
        gmlBuilding("owner", solidOf(gmlBoxFaces(bonn, bonn + glm::dvec3(10, 10, 6), "shared")));
    const std::string borrower = gmlBuilding("borrower", solidOf(other));
    for (const std::string& members : {owner + borrower, borrower + owner}) {
        const auto piece = readGmlText(cityGml(members));
        ASSERT_TRUE(piece) << piece.error().text();
        ASSERT_EQ(piece->buildings.size(), 2U) << "each once";
        for (const auto& building : piece->buildings) expectClosedSolid(building->parts.at(0), 600);
        EXPECT_TRUE(piece->warnings.empty()) << piece->warnings[0].what;
    }
    const auto lost = readGmlText(cityGml(borrower));
    ASSERT_TRUE(lost) << lost.error().text();
    EXPECT_TRUE(warns(*lost, "refer to ids that"));
}

TEST(ReadCityGml, ReferencesInCirclesEnd) {
    std::string surfaces = gmlMembers(gmlBoxFaces(bonn, bonn + glm::dvec3(10, 10, 7)));
    for (int i = 0; i < 40; ++i) surfaces += "<gml:surfaceMember xlink:href=\"#all\"/>";
    const auto piece = readGmlText(
        cityGml(gmlBuilding("house", "<bldg:lod2MultiSurface><gml:MultiSurface gml:id=\"all\">" + surfaces +
                                         "</gml:MultiSurface></bldg:lod2MultiSurface>")));
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_NEAR(riseOf(*piece->buildings.at(0)), 7, 1e-3);
    EXPECT_TRUE(warns(*piece, "refer to ids that the object does not have"));
}

TEST(ReadCityGml, FacesTurnedAroundAreTurnedBack) {
    auto faces = gmlBoxFaces(bonn, bonn + glm::dvec3(10, 10, 7));
    const glm::dvec3 high = bonn + glm::dvec3(10, 10, 7);
    faces[1] = "<gml:OrientableSurface orientation=\"-\"><gml:baseSurface>" +
               gmlPolygon({{bonn.x, bonn.y, high.z},
                           {bonn.x, high.y, high.z},
                           {high.x, high.y, high.z},
                           {high.x, bonn.y, high.z}}) +
               "</gml:baseSurface></gml:OrientableSurface>";
    expectClosedSolid(partOf(readGmlText(cityGml(
                          gmlBuilding("house", "<bldg:lod2Solid>" + gmlSolid(faces) + "</bldg:lod2Solid>")))),
                      700);
}

TEST(ReadCityGml, PartsAndInstallationsBelongToTheirBuilding) {
    const std::string part =
        "<bldg:consistsOfBuildingPart><bldg:BuildingPart gml:id=\"wing\">" +
        gmlBoxSolid({10, 0, 0}, {20, 10, 5}) + "</bldg:BuildingPart></bldg:consistsOfBuildingPart>" +
        "<bldg:outerBuildingInstallation><bldg:BuildingInstallation gml:id=\"chimney\"><bldg:lod2Geometry>" +
        gmlMultiSurface(gmlBoxFaces(bonn + glm::dvec3(4, 4, 9), bonn + glm::dvec3(5, 5, 12))) +
        "</bldg:lod2Geometry></bldg:BuildingInstallation></bldg:outerBuildingInstallation>";
    const auto piece = readGmlText(cityGml(gmlBuilding("house", gmlBoxSolid({0, 0, 0}, {10, 10, 9}) + part)));
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_EQ(piece->buildings.size(), 1U);
    EXPECT_EQ(piece->buildings[0]->parts.size(), 3U);
    EXPECT_NEAR(riseOf(*piece->buildings[0]), 12, 1e-3);
}

TEST(ReadCityGml, ACoarseWholeGivesWayToItsFinerParts) {
    const std::string part = "<bldg:consistsOfBuildingPart><bldg:BuildingPart gml:id=\"wing\">" +
                             gmlBoxSolid({0, 0, 0}, {10, 10, 5}, 2) +
                             "</bldg:BuildingPart></bldg:consistsOfBuildingPart>";
    const std::string text = cityGml(gmlBuilding("house", gmlBoxSolid({0, 0, 0}, {10, 10, 9}, 1) + part));
    EXPECT_NEAR(riseOf(*readGmlText(text)->buildings.at(0)), 5, 1e-3);
    EXPECT_NEAR(riseOf(*readGmlText(text, {.lod = "1"})->buildings.at(0)), 9, 1e-3);
}

std::string outlineOfBonn(const std::string& property, double z) {
    const auto corner = [z](double x, double y) { return glm::dvec3(bonn.x + x, bonn.y + y, z); };
    return fmt::format(
        "<bldg:{0}>{1}</bldg:{0}>", property,
        gmlMultiSurface({gmlPolygon({corner(0, 0), corner(10, 0), corner(10, 10), corner(0, 10)})}));
}

TEST(ReadCityGml, OutlinesOfLevel0AreAsHighAsTheirAttributesSay) {
    const auto heightWith = [](const std::string& attributes) {
        return riseOf(
            *readGmlText(cityGml(gmlBuilding("house", attributes + outlineOfBonn("lod0FootPrint", 60))))
                 ->buildings.at(0));
    };
    EXPECT_NEAR(heightWith("<bldg:measuredHeight uom=\"#m\">9.3</bldg:measuredHeight>"), 9.3, 1e-3);
    EXPECT_NEAR(heightWith("<bldg:measuredHeight uom=\"ft\">100</bldg:measuredHeight>"), 30.48, 1e-3);
    EXPECT_NEAR(heightWith("<con:height><con:Height><con:status>measured</con:status>"
                           "<con:value uom=\"m\">9.5</con:value></con:Height></con:height>"),
                9.5, 1e-3);
    EXPECT_NEAR(heightWith("<bldg:storeysAboveGround>4</bldg:storeysAboveGround>"),
                4 * ReadSettings{}.metresPerLevel, 1e-3);
    EXPECT_NEAR(
        heightWith("<gen:measureAttribute name=\"building_height\"><gen:value uom=\"m\">11</gen:value>"
                   "</gen:measureAttribute>"),
        11, 1e-3);
}

TEST(ReadCityGml, AnOutlineOfTheRoofHangsAtItsTop) {
    const auto piece = readGmlText(cityGml(gmlBuilding(
        "a", "<bldg:measuredHeight uom=\"m\">9</bldg:measuredHeight>" + outlineOfBonn("lod0RoofEdge", 69))));
    ASSERT_TRUE(piece) << piece.error().text();
    const Part& part = piece->buildings.at(0)->parts.at(0);
    EXPECT_NEAR(part.bottomM + piece->frame->originElevationM(), 60, 1e-3);
}

TEST(ReadCityGml, ImplicitShapesAreMovedToTheirPlace) {
    const auto shape = [](const std::string& geometry, double x) {
        return fmt::format(
            "<bldg:outerBuildingInstallation><bldg:BuildingInstallation><bldg:lod3ImplicitRepresentation>"
            "<core:ImplicitGeometry><core:transformationMatrix>2 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"
            "</core:transformationMatrix><core:relativeGMLGeometry{}"
            "<core:referencePoint><gml:Point><gml:pos>{:.9g} {:.9g} 60</gml:pos></gml:Point>"
            "</core:referencePoint></core:ImplicitGeometry></bldg:lod3ImplicitRepresentation>"
            "</bldg:BuildingInstallation></bldg:outerBuildingInstallation>",
            geometry, bonn.x + x, bonn.y);
    };
    std::string faces = gmlMultiSurface(gmlBoxFaces({0, 0, 0}, {1, 1, 20}));
    faces.insert(faces.find('>'), " gml:id=\"mast\"");
    const auto piece = readGmlText(cityGml(gmlBuilding(
        "house", gmlBoxSolid({0, 0, 0}, {4, 4, 4}) + shape(">" + faces + "</core:relativeGMLGeometry>", 10) +
                     shape(" xlink:href=\"#mast\"/>", 30))));
    ASSERT_TRUE(piece) << piece.error().text();
    const auto& parts = piece->buildings.at(0)->parts;
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_NEAR(area(parts[1].footprint), 2, 0.01);
    EXPECT_NEAR(parts[2].topM - parts[2].bottomM, 20, 1e-3);
    EXPECT_NEAR(bounds(parts[2].footprint).low.x - bounds(parts[1].footprint).low.x, 20, 0.1);
}

TEST(ReadCityGml, TinReliefIsTheTerrain) {
    std::string triangles;
    const auto corner = [](double x, double y) { return bonn + glm::dvec3(x, y, x / 10); };
    for (const auto& corners : {std::vector{corner(0, 0), corner(100, 0), corner(100, 100)},
                                {corner(0, 0), corner(100, 100), corner(0, 100)}}) {
        std::string triangle = gmlPolygon(corners);
        for (std::size_t at = 0; (at = triangle.find("gml:Polygon", at)) != triangle.npos;)
            triangle.replace(at, 11, "gml:Triangle");
        triangles += triangle;
    }
    const auto piece = readGmlText(cityGml(
        "<core:cityObjectMember><dem:ReliefFeature><dem:lod>1</dem:lod><dem:reliefComponent><dem:TINRelief>"
        "<dem:tin><gml:TriangulatedSurface><gml:trianglePatches>" +
        triangles +
        "</gml:trianglePatches></gml:TriangulatedSurface></dem:tin></dem:TINRelief></dem:reliefComponent>"
        "</dem:ReliefFeature></core:cityObjectMember>"));
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_NE(piece->terrain, nullptr);
    EXPECT_NEAR(elevationAt(*piece->terrain, {0, 0}), 5, 0.2) << "in the middle, above the lowest point";
}

// Rows of three posts from south to north, 50 m apart, that rise by 5 m to the east.
std::string gmlRaster(const std::string& elevations) {
    return fmt::format(
        "<core:cityObjectMember><dem:ReliefFeature><dem:reliefComponent><dem:RasterRelief gml:id=\"raster\">"
        "<dem:grid><gml:RectifiedGridCoverage><gml:rectifiedGridDomain><gml:RectifiedGrid dimension=\"2\">"
        "<gml:limits><gml:GridEnvelope><gml:low>0 0</gml:low><gml:high>2 2</gml:high></gml:GridEnvelope>"
        "</gml:limits><gml:axisName>x</gml:axisName><gml:origin><gml:Point><gml:pos>{:.9g} {:.9g}</gml:pos>"
        "</gml:Point></gml:origin><gml:offsetVector>50 0</gml:offsetVector><gml:offsetVector>0 50"
        "</gml:offsetVector></gml:RectifiedGrid></gml:rectifiedGridDomain><gml:rangeSet>{}</gml:rangeSet>"
        "</gml:RectifiedGridCoverage></dem:grid></dem:RasterRelief></dem:reliefComponent>"
        "</dem:ReliefFeature></core:cityObjectMember>",
        bonn.x, bonn.y, elevations);
}

std::string gmlDataBlock(const std::string& tuples) {
    return "<gml:DataBlock><gml:rangeParameters/><gml:tupleList>" + tuples +
           "</gml:tupleList></gml:DataBlock>";
}

TEST(ReadCityGml, RasterReliefIsTheTerrain) {
    const auto piece = readGmlText(cityGml(gmlRaster(gmlDataBlock("60,65,70\n60,65,70\n60,65,-9999"))));
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_NE(piece->terrain, nullptr);
    EXPECT_NEAR(elevationAt(*piece->terrain, {0, 0}), 5, 0.2)
        << "at the post in the middle, above the lowest";
    EXPECT_NEAR(elevationAt(*piece->terrain, {40, -25}), 9, 0.2) << "40 m east of it";
    EXPECT_TRUE(piece->warnings.size() <= 1) << "the missing post is filled";
}

TEST(ReadCityGml, RastersThatCannotBeUsedAreListed) {
    const std::string house = gmlBuilding("house", gmlBoxSolid({0, 0, 0}, {10, 10, 9}));
    for (const auto& [elevations, fault] :
         {std::pair(gmlDataBlock("60 65 70"), "raster, it has 3 elevations for a grid of 3 x 3"),
          {std::string("<gml:File><gml:fileName>dem.tif</gml:fileName></gml:File>"),
           "raster, its elevations are in dem.tif"},
          {std::string(), "raster, it holds no grid"}}) {
        const auto piece = readGmlText(cityGml(gmlRaster(elevations) + house));
        ASSERT_TRUE(piece) << piece.error().text();
        EXPECT_EQ(piece->terrain, nullptr);
        ASSERT_TRUE(warns(*piece, "name it as a GeoTIFF beside this file"));
        EXPECT_THAT(piece->warnings.front().where, testing::HasSubstr(fault));
    }
}

TEST(ReadCityGml, WhatIsNoBuildingIsListed) {
    const auto member = [](const char* name) {
        return fmt::format(
            "<core:cityObjectMember><{0} gml:id=\"x\"><deep><lod1Solid/></deep></{0}>"
            "</core:cityObjectMember>",
            name);
    };
    const std::string relief =
        "<core:cityObjectMember><dem:ReliefFeature gml:id=\"r\"><dem:reliefComponent>"
        "<dem:RasterRelief "
        "gml:id=\"raster\"><dem:grid><gml:RectifiedGridCoverage/></dem:grid></dem:RasterRelief>"
        "</dem:reliefComponent></dem:ReliefFeature></core:cityObjectMember>";
    const auto piece =
        readGmlText(cityGml(member("veg:SolitaryVegetationObject") + member("veg:PlantCover") +
                            member("frn:CityFurniture") + member("tran:Road") + relief +
                            gmlBuilding("house", gmlBoxSolid({0, 0, 0}, {10, 10, 9}) +
                                                     "<bldg:interiorRoom><bldg:Room/></bldg:interiorRoom>")));
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->features, 6U);
    EXPECT_TRUE(warns(*piece, "name it as a GeoTIFF beside this file"));
    for (const char* name : {"CityFurniture", "Road"})
        EXPECT_TRUE(warns(*piece, std::string("not a building but ") + name)) << name;
    EXPECT_TRUE(warns(*piece, "a tree without a place"));
    EXPECT_TRUE(piece->trees.empty());
    EXPECT_TRUE(warns(*piece, "inside of buildings"));
}

TEST(ReadCityGml, TreesHaveTheMeasuresThatTheyOrTheirShapesState) {
    const auto tree = [](const char* type, const char* id, const std::string& inside) {
        return fmt::format(
            "<core:cityObjectMember><veg:{0} gml:id=\"{1}\">{2}</veg:{0}></core:cityObjectMember>", type, id,
            inside);
    };
    const auto shape = [](glm::dvec3 low, glm::dvec3 high) {
        return "<veg:lod1Geometry>" + gmlSolid(gmlBoxFaces(low, high)) + "</veg:lod1Geometry>";
    };
    const auto piece = readGmlText(
        cityGml(gmlBuilding("house", gmlBoxSolid({0, 0, 0}, {10, 10, 9})) +
                tree("SolitaryVegetationObject", "shaped", shape({20, 0, 0}, {26, 6, 14})) +
                tree("SolitaryVegetationObject", "stated",
                     "<veg:species>Acer platanoides</veg:species><veg:height uom=\"ft\">50</veg:height>"
                     "<veg:trunkDiameter uom=\"m\">0.4</veg:trunkDiameter>" +
                         shape({40, 0, 0}, {46, 6, 14})) +
                tree("PlantCover", "grove",
                     "<veg:averageHeight uom=\"m\">7</veg:averageHeight><veg:lod1MultiSolid>" +
                         gmlSolid(gmlBoxFaces({60, 0, 0}, {100, 24, 9})) + "</veg:lod1MultiSolid>")));
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->buildings.size(), 1U);
    ASSERT_GT(piece->trees.size(), 2U);
    EXPECT_NEAR(*piece->trees[0].facts.heightM, 14, 1e-3);
    EXPECT_NEAR(*piece->trees[0].facts.crownDiameterM, 6, 0.1);
    EXPECT_NEAR(*piece->trees[1].facts.heightM, 15.24, 1e-3);
    EXPECT_NEAR(*piece->trees[1].facts.stemDiameterM, 0.4, 1e-9);
    EXPECT_EQ(piece->trees[1].facts.species, "Acer platanoides");
    EXPECT_NEAR(double(piece->trees.size() - 2) * 64, 40 * 24, 8 * 40);
    EXPECT_EQ(*piece->trees.back().facts.heightM, 7);
}

// A box of some 10 m near Bonn or Tokyo, in degrees.
std::string boxInDegrees(glm::dvec2 lonLat, bool latitudeFirst) {
    glm::dvec3 low(latitudeFirst ? glm::dvec2(lonLat.y, lonLat.x) : lonLat, 3);
    glm::dvec3 high = low + glm::dvec3(1e-4, 1e-4, 9);
    if (latitudeFirst) std::swap(low.x, high.x);  // turned back, the faces look outward
    return gmlBuilding("house", "<bldg:lod1Solid>" + gmlSolid(gmlBoxFaces(low, high)) + "</bldg:lod1Solid>");
}

TEST(ReadCityGml, TheOrderOfTheAxesIsTheAuthoritysUnlessThePlaceSaysOtherwise) {
    const glm::dvec2 tokyo{139.77, 35.54}, cologne{6.95, 50.94};
    struct Case {
        const char* reference;
        bool latitudeFirst;
        glm::dvec2 place;
        bool isSaid;
    };
    for (const Case& one :
         {Case{"http://www.opengis.net/def/crs/EPSG/0/6697", true, tokyo, false},
          Case{"urn:ogc:def:crs:EPSG::6697", false, tokyo, true}, Case{"EPSG:6697", true, tokyo, false},
          Case{"EPSG:4979", false, tokyo, false}, Case{"urn:ogc:def:crs:EPSG::4979", false, tokyo, true},
          Case{"urn:ogc:def:crs:EPSG::4979", true, cologne, false},
          Case{"EPSG:4979", false, cologne, true}}) {
        SCOPED_TRACE(one.reference);
        const auto piece =
            readGmlText(cityGml(boxInDegrees(one.place, one.latitudeFirst), "2.0", one.reference));
        ASSERT_TRUE(piece) << piece.error().text();
        EXPECT_NEAR(piece->frame->origin().lonDeg, one.place.x, 0.01);
        EXPECT_NEAR(piece->frame->origin().latDeg, one.place.y, 0.01);
        EXPECT_NEAR(riseOf(*piece->buildings.at(0)), 9, 1e-3);
        EXPECT_EQ(warns(*piece, "not in the order of") || warns(*piece, "longitude or easting first"),
                  one.isSaid);
    }
}

TEST(ReadCityGml, CoordinatesTurnedAgainstTheirEnvelopeAreTurnedBack) {
    const auto piece =
        readGmlText(cityGml(boxInDegrees({6.95, 50.94}, false), "2.0", "urn:ogc:def:crs:EPSG::4979",
                            "<gml:lowerCorner>50.9 6.9 0</gml:lowerCorner>"
                            "<gml:upperCorner>51 7 99</gml:upperCorner>"));
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_NEAR(piece->frame->origin().lonDeg, 6.95, 0.01);
    EXPECT_TRUE(warns(*piece, "not in the order of their reference system"));
}

// Both orders lie on earth: 6.95 N 50.94 E is in the Indian Ocean. A city read in the wrong order is a
// mirror image, whose faces look inward.
TEST(ReadCityGml, CoordinatesThatMirrorTheBuildingsAreTurnedBack) {
    for (const char* envelope : {"",
                                 "<gml:lowerCorner>6.9 50.9 0</gml:lowerCorner>"
                                 "<gml:upperCorner>7 51 99</gml:upperCorner>"}) {
        const auto piece = readGmlText(
            cityGml(boxInDegrees({6.95, 50.94}, false), "2.0", "urn:ogc:def:crs:EPSG::4979", envelope));
        ASSERT_TRUE(piece) << piece.error().text();
        EXPECT_NEAR(piece->frame->origin().lonDeg, 6.95, 0.01);
        EXPECT_NEAR(piece->frame->origin().latDeg, 50.94, 0.01);
        EXPECT_TRUE(warns(*piece, "in which the buildings are mirror images"));
        EXPECT_FALSE(warns(*piece, "pointed inward"));
    }
}

TEST(ReadCityGml, TheNamesOfTheGermanSurveysAreKnown) {
    for (const char* reference : {"urn:adv:crs:ETRS89_UTM32*DE_DHHN2016_NH", "urn:adv:crs:ETRS89_UTM32",
                                  "urn:ogc:def:crs,crs:EPSG::25832,crs:EPSG::5783", "EPSG:25832"}) {
        const auto piece =
            readGmlText(cityGml(gmlBuilding("cube", gmlBoxSolid({0, 0, 0}, {10, 20, 30})), "1.0", reference));
        ASSERT_TRUE(piece) << reference << ": " << piece.error().text();
        EXPECT_NEAR(piece->frame->origin().latDeg, 50.735, 0.01) << reference;
    }
}

TEST(ReadCityGml, AReferenceSystemThatIsMissingOrUnknownIsAskedFor) {
    const std::string cube = gmlBuilding("cube", gmlBoxSolid({0, 0, 0}, {10, 20, 30}));
    for (const char* reference : {"", "my own system"}) {
        const std::string text = cityGml(cube, "2.0", reference);
        const auto refused = readGmlText(text);
        ASSERT_FALSE(refused);
        EXPECT_THAT(refused.error().advice, testing::HasSubstr("--crs"));
        const auto piece = readGmlText(text, {.crs = "EPSG:25832"});
        ASSERT_TRUE(piece) << piece.error().text();
        EXPECT_NEAR(piece->frame->origin().latDeg, 50.735, 0.01);
    }
}

TEST(ReadCityGml, TwoObjectsOfTheSameIdAreBothRead) {
    const std::string part = "<bldg:consistsOfBuildingPart><bldg:BuildingPart gml:id=\"a\">" +
                             gmlBoxSolid({0, 0, 0}, {10, 10, 5}, 2) +
                             "</bldg:BuildingPart></bldg:consistsOfBuildingPart>";
    const auto piece = readGmlText(cityGml(gmlBuilding("a", part + part)));
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->buildings.at(0)->parts.size(), 2U);
}

// A published file; the test is skipped without it.
class PublishedCityGml : public testing::Test {
protected:
    bool readFile(const char* file, const std::string& lod = {}) {
        const auto path = sharedData(file);
        if (!path) return false;
        NoProgress quiet;
        auto result = readCityGml(*path, {.lod = lod}, quiet, {});
        EXPECT_TRUE(result) << result.error().text();
        if (result) piece = *std::move(result);
        return result.has_value();
    }
    [[nodiscard]] std::vector<Part> parts() const {
        std::vector<Part> all;
        for (const auto& building : piece.buildings)
            all.insert(all.end(), building->parts.begin(), building->parts.end());
        return all;
    }
    [[nodiscard]] double lowestM() const {
        return piece.frame->originElevationM() +
               double(std::ranges::min(parts(), {}, &Part::bottomM).bottomM);
    }
    FilePiece piece;
};

TEST_F(PublishedCityGml, BerlinGlienickeHas43BuildingsOf88Solids) {
    if (!readFile("world/berlin_glienicke_lod1.xml")) GTEST_SKIP() << "shared data is missing";
    EXPECT_EQ(piece.buildings.size(), 43U);
    EXPECT_EQ(piece.features, 43U + 56U);
    EXPECT_EQ(parts().size(), 88U);
    double tallest = 0;
    for (const Part& part : parts()) tallest = std::max(tallest, double(part.topM) - double(part.bottomM));
    EXPECT_NEAR(tallest, 31.206, 0.01);
    EXPECT_NEAR(lowestM(), 29.57, 0.02);
    const Part highest = std::ranges::max(parts(), {}, &Part::topM);
    EXPECT_NEAR(piece.frame->originElevationM() + double(highest.topM), 62.85, 0.02);
    EXPECT_NEAR(piece.frame->origin().latDeg, 52.41, 0.02);
    EXPECT_NEAR(piece.frame->origin().lonDeg, 13.09, 0.02);
}

TEST_F(PublishedCityGml, TheTileOfHanedaHas8BuildingsOnABaseOf2466Millimetres) {
    if (!readFile("world/53392642_bldg_6697_op2.gml", "1")) GTEST_SKIP() << "shared data is missing";
    EXPECT_EQ(piece.buildings.size(), 8U);
    EXPECT_NEAR(lowestM(), 2.466, 0.001);
    EXPECT_NEAR(piece.frame->origin().lonDeg, 139.777, 0.005);
    EXPECT_NEAR(piece.frame->origin().latDeg, 35.54, 0.005);
}

// Its roofs are drawn up to 0.73 m below the heights that were measured.
TEST_F(PublishedCityGml, RoofsOfHanedaAreAsHighAsMeasured) {
    if (!readFile("world/53392642_bldg_6697_op2.gml")) GTEST_SKIP() << "shared data is missing";
    std::vector<double> heights;
    for (const auto& building : piece.buildings) heights.push_back(riseOf(*building));
    EXPECT_THAT(heights, testing::Pointwise(testing::DoubleNear(0.75),
                                            std::vector{2.8, 3.6, 3.6, 16.1, 9.3, 3.9, 11.6, 5.1}));
}

}  // namespace
}  // namespace noonmark
