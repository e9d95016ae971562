#include "core/io/meshes/mesh_placement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/meshes/ifc_site.h"
#include "core/io/pieces/read_part.h"
#include "core/io/read_city.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

// What a mesh file does not state about its axes, and what an IFC states about its place.
namespace noonmark {
namespace {

using testing::HasSubstr;

MeshPiece boxOf(glm::vec3 low, glm::vec3 high) {
    MeshPiece piece;
    for (int i = 0; i < 8; ++i)
        piece.points.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                                  (i & 4) != 0 ? high.z : low.z);
    return piece;
}

UpAxisGuess guess(std::vector<MeshPiece> pieces) { return guessUpAxis({MeshObject{"a", std::move(pieces)}}); }

TEST(UpAxis, ACityIsFlat) {
    EXPECT_EQ(guess({boxOf({0, 0, 480}, {600, 517, 570})}).axis, UpAxis::z);
    EXPECT_EQ(guess({boxOf({0, 0, -517}, {600, 90, 0})}).axis, UpAxis::y);
    EXPECT_THAT(guess({boxOf({0, 0, 480}, {600, 517, 570})}).why, HasSubstr("600 x 517 and only 90 in z"));
}

TEST(UpAxis, ATowerIsHigh) {
    EXPECT_EQ(guess({boxOf({0, 0, 0}, {40, 40, 200})}).axis, UpAxis::z);
    EXPECT_EQ(guess({boxOf({0, 0, 0}, {40, 200, 40})}).axis, UpAxis::y);
}

TEST(UpAxis, BuildingsStandOnTheirFeet) {
    std::vector<MeshPiece> houses;
    for (int i = 0; i < 6; ++i) {
        const auto x = float(30 * i), y = float(7 * i);
        houses.push_back(boxOf({x, y, 0}, {x + 10, y + 12, 6 + y / 7}));
    }
    EXPECT_EQ(guess(houses).axis, UpAxis::z);
}

// A hall, a slab and a row of towers, in both directions.
TEST(UpAxis, AFlatBottomIsAtZero) {
    for (const glm::vec3 size : {glm::vec3{80, 40, 9}, {60, 12, 30}, {140, 20, 90}}) {
        EXPECT_EQ(guess({boxOf({0, 0, 0}, size)}).axis, UpAxis::z);
        EXPECT_EQ(guess({boxOf({0, 0, -size.y}, {size.x, size.z, 0})}).axis, UpAxis::y);
        EXPECT_EQ(guess({boxOf({-7, -9, 0}, {size.x - 7, size.y - 9, size.z})}).axis, UpAxis::z);
    }
}

TEST(UpAxis, ElseItIsTheLowerOne) {
    EXPECT_EQ(guess({boxOf({5, 5, 5}, {85, 45, 14})}).axis, UpAxis::z);
    EXPECT_EQ(guess({boxOf({5, 5, 5}, {85, 14, 45})}).axis, UpAxis::y);
    EXPECT_THAT(guess({boxOf({5, 5, 5}, {85, 45, 14})}).why, HasSubstr("9 instead of 40"));
}

TEST(UpAxis, OtherwiseYIsUsual) {
    EXPECT_EQ(guess({boxOf({5, 5, 5}, {15, 15, 15})}).axis, UpAxis::y);
    EXPECT_EQ(guess({}).axis, UpAxis::y);
}

const char* const flatCity =
    "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 20\nv 10 0 20\nv 10 10 20\nv 0 10 20\n"
    "v 300 300 0\nv 310 300 0\nv 310 310 0\nv 300 310 0\nv 300 300 20\nv 310 300 20\nv 310 310 20\nv 300 310 "
    "20\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
    "f 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n";

Result<FilePiece> readMeshFile(const std::filesystem::path& file, ReadSettings settings = {}) {
    NoProgress quiet;
    settings.frame = Frame({8.4, 49});
    return readMesh(file, settings, quiet, {});
}

std::string textsOf(const Warnings& warnings) {
    std::string text;
    for (const Warning& warning : warnings) text += warning.what + " | " + warning.where + "\n";
    return text;
}

TEST(UpAxis, IsReportedWhereItIsAssumedAndStatedOtherwise) {
    const tests::TemporaryFolder folder;
    const auto file = folder.file("city.obj", flatCity);
    const auto assumed = readMeshFile(file);
    ASSERT_TRUE(assumed) << assumed.error().text();
    EXPECT_NEAR(topM(*assumed->buildings.at(0)), 20, 1e-4);
    EXPECT_THAT(textsOf(assumed->warnings),
                HasSubstr("z was taken, since the mesh is 310 x 310 and only 20 in z"));
    const auto stated = readMeshFile(file, {.upAxis = UpAxis::y});
    EXPECT_THAT(textsOf(stated->warnings), testing::Not(HasSubstr("axis is up")));
}

TEST(MeshUnits, MillimetresAndInchesAreUnits) {
    const tests::TemporaryFolder folder;
    const auto file = folder.file("city.obj", flatCity);
    const auto heightIn = [&](LengthUnit unit) {
        const auto piece = readMeshFile(file, {.upAxis = UpAxis::z, .meshUnit = unit});
        return piece ? double(topM(*piece->buildings.at(0))) : -1;
    };
    EXPECT_NEAR(heightIn(LengthUnit::inches), 20 * 0.0254, 1e-5);
    EXPECT_NEAR(heightIn(LengthUnit::millimetres), 0.02, 1e-5);
}

TEST(MeshUnits, AMeshHigherThanAnyTownIsDoubtedAndOtherUnitsAreNamed) {
    const tests::TemporaryFolder folder;
    const auto file = folder.file(
        "tower.obj",
        "v 0 0 0\nv 500 0 0\nv 500 500 0\nv 0 500 0\nv 0 0 1500\nv 500 0 1500\nv 500 500 1500\nv 0 500 1500\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    const auto read = [&](LengthUnit unit) {
        const auto piece = readMeshFile(file, {.upAxis = UpAxis::z, .meshUnit = unit});
        return piece ? textsOf(piece->warnings) : piece.error().text();
    };
    EXPECT_THAT(read(LengthUnit::metres),
                HasSubstr("in metres the mesh is 1500 m high (ft: 457.2 m, in: 38.1 m, cm: 15.0 m"));
    EXPECT_THAT(read(LengthUnit::inches), testing::Not(HasSubstr("states no unit")));
}

TEST(MeshScale, ComesBeforeTheLimitsOfABuilding) {
    const tests::TemporaryFolder folder;
    const auto file =
        folder.file("tower.obj",
                    "v 0 0 0\nv 30000 0 0\nv 30000 30000 0\nv 0 30000 0\nv 0 0 90000\nv 30000 0 90000\n"
                    "v 30000 30000 90000\nv 0 30000 90000\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\n"
                    "f 3 4 8 7\nf 4 1 5 8\n");
    NoProgress quiet;
    ReadSettings settings{.upAxis = UpAxis::z, .meshScale = 0.001, .frame = Frame({8.4, 49})};
    const auto city = readCity({file}, settings, quiet, {});
    ASSERT_TRUE(city) << city.error().text();
    EXPECT_NEAR(topM(*city->city.buildings.at(0)), 90, 1e-3);
    settings.meshScale = 1;
    EXPECT_FALSE(readCity({file}, settings, quiet, {}));
}

TEST(SeveralMeshes, OneWithoutTrianglesIsLeftOutAndReported) {
    const tests::TemporaryFolder folder;
    const auto points = folder.file(
        "points.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
        "z\nend_header\n0 0 0\n1 0 0\n0 1 0\n");
    const auto city = folder.file("city.obj", flatCity);
    NoProgress quiet;
    const ReadSettings settings{.upAxis = UpAxis::z, .frame = Frame({8.4, 49})};
    for (const auto& files : {std::vector{points, city}, std::vector{city, points}}) {
        const auto read = readCity(files, settings, quiet, {});
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(read->city.buildings.size(), 2U);
        EXPECT_THAT(textsOf(read->warnings), HasSubstr("points.ply"));
    }
    EXPECT_FALSE(readCity({points}, settings, quiet, {}));
    EXPECT_FALSE(readCity({points, points}, settings, quiet, {})) << "nothing is left";
}

TEST(IfcSite, StatesPlaceNorthAndMap) {
    const tests::TemporaryFolder folder;
    const IfcSite site = readIfcSite(
        folder.file("a.ifc",
                    "ISO-10303-21;\n#10= IFCDIRECTION((0.5,0.8660254));\n"
                    "#11=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#9,#10);\n"
                    "#12=IFCSITE('id',#1,'The site; of (a, b)',$,$,#2,$,$,.ELEMENT.,(49,6,1,566000),\n"
                    " (-8,-26,-11,-540400),110.5,$,$);\n#13=IFCPROJECTEDCRS('EPSG:25832',$,$,$,$,$,$);\n"
                    "#14=IFCMAPCONVERSION(#11,#13,428000.,5444000.,110.,1.,0.,1.);\n"),
        {});
    ASSERT_TRUE(site.place);
    EXPECT_NEAR(site.place->latDeg, 49.1004350, 1e-6);
    EXPECT_NEAR(site.place->lonDeg, -8.4365390, 1e-6);
    EXPECT_EQ(site.elevationM, 110.5);
    EXPECT_NEAR(site.trueNorthDeg.value_or(0), 30, 1e-4);
    EXPECT_THAT(site.mapConversion, HasSubstr("EPSG:25832"));
    EXPECT_THAT(describe(site), HasSubstr("--mesh-north -30"));
    EXPECT_EQ(describe(readIfcSite(folder.file("b.ifc", "ISO-10303-21;\n#1=IFCSITE($);"), {})), "");
    EXPECT_EQ(describe(readIfcSite(folder.file("c.ifc", std::string(20000, 'x')), {})), "");
}

TEST(IfcSite, ThatOfThePublishedHouseIsKnown) {
    const auto file = tests::sharedData("world/FZK.ifc");
    if (!file) GTEST_SKIP() << "shared data is missing";
    const IfcSite site = readIfcSite(*file, {});
    ASSERT_TRUE(site.place);
    EXPECT_NEAR(site.place->latDeg, 49 + 6 / 60.0 + 1.566 / 3600, 1e-7);
    EXPECT_NEAR(site.place->lonDeg, 8 + 26 / 60.0 + 11.5404 / 3600, 1e-7);
    EXPECT_EQ(site.elevationM, 110);
    EXPECT_NEAR(site.trueNorthDeg.value_or(0), 50, 0.01);
    EXPECT_THAT(describe(site), HasSubstr("--mesh-anchor 8.436539,49.100435"));
    EXPECT_THAT(describe(site), HasSubstr("--mesh-north -50"));
}

// The house is IFC4, with spaces of a kind that the mesh library does not know.
TEST(IfcSite, ThePublishedHouseStandsWhereItStates) {
    const auto file = tests::sharedData("world/FZK.ifc");
    if (!file) GTEST_SKIP() << "shared data is missing";
    NoProgress quiet;
    const auto piece = readMesh(*file, {}, quiet, {});
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_EQ(piece->buildings.size(), 1U);
    EXPECT_EQ(piece->buildings[0]->name, "FZK-Haus");
    EXPECT_NEAR(piece->frame->origin().latDeg, 49 + 6 / 60.0 + 1.566 / 3600, 1e-7);
    EXPECT_NEAR(piece->frame->origin().lonDeg, 8 + 26 / 60.0 + 11.5404 / 3600, 1e-7);
    EXPECT_THAT(textsOf(piece->warnings), HasSubstr("--mesh-anchor 8.436539,49.100435, --mesh-north -50"));
    EXPECT_THAT(textsOf(piece->warnings), HasSubstr("IfcSite (1)"));
}

TEST(IfcSite, AMapConversionTurnsFromTheMapsNorth) {
    IfcSite site;
    site.place = LonLat{1, 1};
    site.mapCrs = "EPSG:25832";
    site.mapOrigin = glm::dvec2(428'000, 5'444'000);
    site.mapAxis = {0, 1};  // the model's x points north on the map, its y west
    const auto place = findPlace(site);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->origin.latDeg, 49.144, 0.01);
    EXPECT_NEAR(place->origin.lonDeg, 8.013, 0.01);
    // West of the central meridian grid north lies west of true north: by (lon - 9) sin(lat).
    EXPECT_NEAR(place->northDeg, -90 + (8.0128 - 9) * 0.7563, 0.01);
    site.mapOrigin = *site.mapOrigin * 1000.0;
    EXPECT_NEAR(findPlace(site)->origin.latDeg, 49.144, 0.01) << "in millimetres";
    site.mapCrs = "unknown";
    EXPECT_EQ(findPlace(site)->origin, (LonLat{1, 1}));
}

}  // namespace
}  // namespace noonmark
