#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/city/meshes/mesh_topology.h"
#include "core/io/pieces/read_part.h"
#include "tests/core/city/mesh_fixtures.h"
#include "tests/core/io/piece_checks.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using tests::box;
using tests::warns;

const LonLat anchor{-73.98, 40.75};

std::string objText(const TriangleMesh& mesh, const std::string& header = "o tower\n") {
    std::string text = header;
    for (const glm::vec3 v : mesh.vertices)
        text += "v " + std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
    for (const glm::uvec3 t : mesh.triangles)
        text += "f " + std::to_string(t.x + 1) + " " + std::to_string(t.y + 1) + " " +
                std::to_string(t.z + 1) + "\n";
    return text;
}

std::string plyText(const TriangleMesh& mesh) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(mesh.triangles.size()) +
                       "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const glm::vec3 v : mesh.vertices)
        text += std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
    for (const glm::uvec3 t : mesh.triangles)
        text += "3 " + std::to_string(t.x) + " " + std::to_string(t.y) + " " + std::to_string(t.z) + "\n";
    return text;
}

template <class T>
std::string bytesOf(const T* data, std::size_t count) {
    return {reinterpret_cast<const char*>(data), count * sizeof(T)};
}

std::string chunk(std::string content, const char* type, char padding) {
    content.resize((content.size() + 3) / 4 * 4, padding);
    const auto length = std::uint32_t(content.size());
    return bytesOf(&length, 1) + std::string(type, 4) + content;
}

// Binary glTF with a node that lifts the mesh by 5 along y, its up axis.
std::string glbBytes(const TriangleMesh& mesh) {
    const std::string points = bytesOf(mesh.vertices.data(), mesh.vertices.size());
    const std::string faces = bytesOf(mesh.triangles.data(), mesh.triangles.size());
    const std::string json =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"lifted","mesh":0,"translation":[0,5,0]}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
        R"({"bufferView":0,"componentType":5126,"count":)" +
        std::to_string(mesh.vertices.size()) +
        R"(,"type":"VEC3","min":[0,0,0],"max":[10,30,20]},{"bufferView":1,"componentType":5125,"count":)" +
        std::to_string(mesh.triangles.size() * 3) +
        R"(,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":)" +
        std::to_string(points.size()) + R"(},{"buffer":0,"byteOffset":)" + std::to_string(points.size()) +
        R"(,"byteLength":)" + std::to_string(faces.size()) + R"(}],"buffers":[{"byteLength":)" +
        std::to_string(points.size() + faces.size()) + "}]}";
    const std::string body = chunk(json, "JSON", ' ') + chunk(points + faces, "BIN\0", '\0');
    const std::uint32_t header[] = {2, std::uint32_t(body.size() + 12)};
    return "glTF" + bytesOf(header, 2) + body;
}

ReadSettings placed(UpAxis up = UpAxis::z) {
    ReadSettings settings;
    settings.upAxis = up;
    settings.meshAnchor = anchor;
    return settings;
}

Result<FilePiece> read(const std::filesystem::path& file, const ReadSettings& settings) {
    NoProgress progress;
    return readMesh(file, settings, progress, {});
}

Result<FilePiece> read(const std::string& name, const std::string& content, const ReadSettings& settings) {
    const tests::TemporaryFolder folder;
    return read(folder.file(name, content), settings);
}

TEST(ReadMesh, ObjInFeetYUpTurnedToTrueNorth) {
    ReadSettings settings = placed(UpAxis::y);
    settings.meshUnit = LengthUnit::feet;
    settings.meshNorthDeg = 90;  // the mesh's north, -z of a y-up mesh, points east
    const auto piece = read("cube.obj", objText(box({0, 0, -200}, {100, 300, 0})), settings);
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_EQ(piece->buildings.size(), 1U);
    EXPECT_EQ(piece->frame->origin(), anchor);
    const Part& part = piece->buildings[0]->parts.at(0);
    EXPECT_EQ(piece->buildings[0]->name, "tower");
    const Box2 bounds2 = bounds(part.footprint);
    EXPECT_NEAR(bounds2.low.x, 0, 1e-4);
    EXPECT_NEAR(bounds2.high.x, 60.96, 1e-4);
    EXPECT_NEAR(bounds2.low.y, -30.48, 1e-4);
    EXPECT_NEAR(bounds2.high.y, 0, 1e-4);
    EXPECT_NEAR(part.topM, 91.44, 1e-4);
    tests::expectClosedSolid(part, 60.96 * 30.48 * 91.44);
    EXPECT_TRUE(piece->warnings.empty());
}

TEST(ReadMesh, NorthIsAnAzimuth) {
    ReadSettings settings = placed();
    settings.meshNorthDeg = 29;
    const auto piece = read("cube.obj", objText(box({-1, 0, 0}, {1, 100, 10})), settings);
    ASSERT_TRUE(piece);
    const Box2 bounds2 = bounds(*piece->buildings.at(0));
    const double azimuth = 29 * std::numbers::pi / 180;
    EXPECT_NEAR(bounds2.high.x, 100 * std::sin(azimuth) + std::cos(azimuth), 1e-3);
    EXPECT_NEAR(bounds2.high.y, 100 * std::cos(azimuth) + std::sin(azimuth), 1e-3);
}

TEST(ReadMesh, ACityInOneObjectBecomesBuildings) {
    TriangleMesh city = box({0, 0, 0}, {10, 10, 20});              // a podium
    append(city, box({2, 2, 20}, {8, 8, 60}));                     // its tower, not welded to it
    append(city, tests::unshared(box({12, 0, 0}, {20, 10, 15})));  // loose triangles
    append(city, box({20.5F, 0, 0}, {30, 10, 15}));                // a neighbour
    TriangleMesh ground;
    ground.vertices = {{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}};
    ground.triangles = {{0, 1, 2}, {0, 2, 3}};
    append(city, ground);
    const auto piece = read("city.obj", objText(city, ""), placed());
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_EQ(piece->buildings.size(), 3U);
    EXPECT_EQ(topM(*piece->buildings[0]), 60);
    EXPECT_TRUE(warns(*piece, "flat ground"));
    EXPECT_FALSE(warns(*piece, "not closed"));
    double volume = 0;
    for (const auto& building : piece->buildings)
        for (const Part& part : building->parts) volume += signedVolume(*part.mesh);
    EXPECT_NEAR(volume, 2000 + 36 * 40 + 1200 + 9.5 * 150, 1e-2);
}

TEST(ReadMesh, PolygonFacesAndNegativeIndices) {
    const auto piece = read("quads.obj",
                            "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 9\nv 4 0 9\nv 4 4 9\nv 0 4 9\n"
                            "f -5 -6 -7 -8\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n",
                            placed());
    ASSERT_TRUE(piece) << piece.error().text();
    tests::expectClosedSolid(piece->buildings.at(0)->parts.at(0), 144);
}

// Six quads around the last eight points of an OBJ.
constexpr const char* objQuads =
    "f -5 -6 -7 -8\nf -4 -3 -2 -1\nf -8 -7 -3 -4\nf -7 -6 -2 -3\nf -6 -5 -1 -2\nf -5 -8 -4 -1\n";

// Points of a box of 10 x 10 x height m with its western side at `west`.
std::string objBoxPoints(int west, int height) {
    std::string text;
    for (const int z : {0, height})
        for (const auto& [x, y] : {std::pair(0, 0), std::pair(10, 0), std::pair(10, 10), std::pair(0, 10)})
            text +=
                "v " + std::to_string(west + x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    return text;
}

std::string objBoxAt(int west, int height) { return objBoxPoints(west, height) + objQuads; }

std::vector<std::string> idsOf(const FilePiece& piece) {
    std::vector<std::string> ids;
    for (const auto& building : piece.buildings) ids.push_back(building->sourceId);
    return ids;
}

TEST(ReadObj, NamesOfObjectsMayHaveBlanks) {
    const auto piece = read(
        "a.obj",
        "o House 1\n" + objBoxAt(0, 5) + "o House 2\n" + objBoxAt(30, 7) + "o House 1\n" + objBoxAt(60, 5),
        placed());
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_THAT(idsOf(*piece), testing::UnorderedElementsAre("House 1 1", "House 1 2", "House 2"));
}

// As Rhino (a layer before each object), Maya ("default" before the points) and 3ds Max write them.
TEST(ReadObj, AGroupBeforeAnObjectIsNotItsName) {
    const auto piece =
        read("a.obj", "g layer\no object_1\n" + objBoxAt(0, 5) + "g layer\no object_2\n" + objBoxAt(30, 7),
             placed());
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_THAT(idsOf(*piece), testing::ElementsAre("object_1", "object_2"));
    const auto maya = read("b.obj",
                           "g default\n" + objBoxPoints(0, 5) + "g pCube1\n" + objQuads + "g default\n" +
                               objBoxPoints(30, 7) + "g pCube2\n" + objQuads,
                           placed());
    ASSERT_TRUE(maya) << maya.error().text();
    EXPECT_THAT(idsOf(*maya), testing::ElementsAre("pCube1", "pCube2"));
}

TEST(ReadObj, GroupsOfAnObjectAreItsSurfaces) {
    const std::string walls = "g walls\nf -8 -7 -3 -4\nf -7 -6 -2 -3\nf -6 -5 -1 -2\nf -5 -8 -4 -1\n",
                      roof = "g roof\nf -4 -3 -2 -1\n";
    std::string text;
    for (const int i : {0, 1})
        text += "o house" + std::to_string(i) + "\n" + objBoxPoints(30 * i, 5 + i) + walls + roof;
    const auto piece = read("a.obj", text, placed());
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_THAT(idsOf(*piece), testing::ElementsAre("house0", "house1"));
    EXPECT_FLOAT_EQ(piece->buildings[1]->parts.at(0).topM, 6);
}

TEST(ReadObj, StatementsMayContinueAndPointsMayHaveColoursOrWeights) {
    std::string text =
        "\xEF\xBB\xBF# a comment\r\nmtllib a.mtl\r\no a\r\nv 0 0 0 0.5 0.5 0.5\r\nv 20 0 0 2\r\n";
    text +=
        "v 10 10 0\r\nv 0 10 0\r\nv 0 0 9\r\nv 10 0 9\r\nv 10 10 9\r\nv 0 10 9\r\nf -5/1/2 -6 \\\r\n -7 "
        "-8//3\r\n";
    text += "f -4 -3 -2 -1\r\nf -8 -7 -3 -4\r\nf -7 -6 -2 -3\r\nf -6 -5 -1 -2\r\nf -5 -8 -4 -1\r\n";
    const auto piece = read("a.obj", text, placed());
    ASSERT_TRUE(piece) << piece.error().text();
    tests::expectClosedSolid(piece->buildings.at(0)->parts.at(0), 900);
}

TEST(ReadObj, DecimalCommasAreAnError) {
    const auto piece = read("a.obj", "o a\nv 391800,5 5820000,25 35,0\n", placed());
    ASSERT_FALSE(piece);
    EXPECT_EQ(piece.error().what, "The OBJ writes numbers with decimal commas");
    EXPECT_THAT(piece.error().where, testing::EndsWith("a.obj: line 2"));
}

TEST(ReadObj, CornersWithoutAPointAreCounted) {
    const auto piece = read("a.obj", "o a\n" + objBoxAt(0, 5) + "f 1 2 99\nf a b c\n", placed());
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_THAT(piece->warnings,
                testing::Contains(testing::AllOf(testing::Field(&Warning::what, "faces with missing corners"),
                                                 testing::Field(&Warning::where, "a.obj: a (2)"))));
}

TEST(ReadMesh, Ply) {
    const auto piece = read("box.ply", plyText(box({0, 0, 0}, {10, 20, 30})), placed());
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->format, "PLY");
    tests::expectClosedSolid(piece->buildings.at(0)->parts.at(0), 6000);
}

TEST(ReadMesh, IsOfTheFormatOfItsContentWhateverItIsCalled) {
    const auto piece = read("box.model", plyText(box({0, 0, 0}, {10, 20, 30})), placed());
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->format, "PLY");
}

TEST(ReadMesh, GlbWithANodeTransform) {
    const auto piece = read("box.glb", glbBytes(box({0, 0, 0}, {10, 30, 20})), placed(UpAxis::y));
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->format, "glTF");
    EXPECT_EQ(piece->buildings.at(0)->name, "lifted");
    const Part& part = piece->buildings[0]->parts.at(0);
    EXPECT_NEAR(part.bottomM, 5, 1e-5);
    EXPECT_NEAR(part.topM, 35, 1e-5);
    EXPECT_TRUE(part.isOverhanging);  // 5 m above the ground, not carried
    tests::expectClosedSolid(part, 6000);
}

TEST(ReadMesh, OpenMeshIsUsedAndReported) {
    TriangleMesh open = box({0, 0, 0}, {10, 10, 10});
    open.triangles.pop_back();
    const auto piece = read("open.obj", objText(open), placed());
    ASSERT_TRUE(piece);
    EXPECT_EQ(piece->buildings.size(), 1U);
    EXPECT_TRUE(warns(*piece, "not closed"));
}

TEST(ReadMesh, JoinsAProject) {
    ReadSettings settings = placed();
    settings.frame = Frame({anchor.lonDeg - 0.01, anchor.latDeg});
    const auto piece = read("cube.obj", objText(box({0, 0, 0}, {10, 10, 10})), settings);
    ASSERT_TRUE(piece);
    EXPECT_FALSE(piece->frame);
    const glm::dvec2 expected = settings.frame->localFromLonLat(anchor);
    EXPECT_NEAR(bounds(*piece->buildings.at(0)).low.x, expected.x, 1e-3);
    settings.meshAnchor.reset();
    const auto atOrigin = read("cube.obj", objText(box({0, 0, 0}, {10, 10, 10})), settings);
    ASSERT_TRUE(atOrigin);
    EXPECT_TRUE(warns(*atOrigin, "project's origin"));
}

TEST(ReadMesh, NoPlaceIsAnErrorThatSaysWhatToGive) {
    const auto piece = read("cube.obj", objText(box({0, 0, 0}, {1, 1, 1})), {});
    ASSERT_FALSE(piece);
    EXPECT_NE(piece.error().advice.find("longitude and latitude"), std::string::npos);
}

TEST(ReadMesh, MapCoordinatesAreRefused) {
    const auto piece = read("utm.obj", objText(box({585000, 4511000, 0}, {585010, 4511010, 10})), placed());
    ASSERT_FALSE(piece);
    EXPECT_NE(piece.error().what.find("from its own origin"), std::string::npos);
}

TEST(ReadMesh, TrianglesFarBeyondTheCityAreDropped) {
    const std::string text = objText(box({0, 0, 0}, {10, 20, 30})) + "v 4e25 0 5\nf 1 2 9\nf 2 3 9\n";
    const FilePiece piece = read("far.obj", text, placed()).value();
    ASSERT_EQ(piece.buildings.size(), 1U);
    tests::expectClosedSolid(piece.buildings[0]->parts.at(0), 6000);
    EXPECT_TRUE(warns(piece, "more than 1,000 km away"));
}

TEST(ReadMesh, BrokenFilesAreErrors) {
    for (const char* name : {"a.obj", "a.ply", "a.glb", "a.gltf"})
        for (const char* content : {"", "v", "{}", "ply\n", "glTF", "f 1 2 3\n", "v 1 2 3\n", "\xff\xfe\xfd"})
            EXPECT_FALSE(read(name, content, placed())) << name << ' ' << content;
}

TEST(ReadMesh, WrongIndicesAndNumbersNeverCrash) {
    const std::string good = objText(box({0, 0, 0}, {10, 10, 10}));
    for (const char* bad :
         {"f 1 2 99\n", "f 0 1 2\n", "f -99 1 2\n", "f 1 1 1\n", "f 1\n", "f 1 2\n", "f a b c\n",
          "v nan nan nan\nf 9 1 2\n", "v 1e99 0 0\nf 9 1 2\n", "o\n", "f 99999999999999999999 1 2\n"}) {
        SCOPED_TRACE(bad);
        const auto piece = read("bad.obj", good + bad, placed());
        if (!piece) continue;  // the library may refuse the file, with an error
        for (const auto& building : piece->buildings)
            for (const Part& part : building->parts) EXPECT_LE(part.topM, 1e6F) << bad;
    }
}

TEST(ReadMesh, SpoiledBytesNeverCrash) {
    const TriangleMesh mesh = box({0, 0, 0}, {10, 30, 20});
    const std::pair<const char*, std::string> files[] = {
        {"a.obj", objText(mesh)}, {"a.ply", plyText(mesh)}, {"a.glb", glbBytes(mesh)}};
    const tests::TemporaryFolder folder;
    std::mt19937 random(5);
    for (const auto& [name, content] : files)
        for (int i = 0; i < 300; ++i) {
            std::string spoiled = content;
            for (int j = 0; j < 3; ++j) spoiled[random() % spoiled.size()] = char(random() % 256);
            const auto piece = read(folder.file(name, spoiled), placed());
            EXPECT_TRUE(piece || !piece.error().text().empty());
        }
}

TEST(ReadMesh, TruncatedAnywhereNeverCrashes) {
    const TriangleMesh mesh = box({0, 0, 0}, {10, 30, 20});
    const std::pair<const char*, std::string> files[] = {
        {"a.obj", objText(mesh)}, {"a.ply", plyText(mesh)}, {"a.glb", glbBytes(mesh)}};
    const tests::TemporaryFolder folder;
    for (const auto& [name, content] : files)
        for (std::size_t length = 0; length < content.size(); length += 7) {
            const auto piece = read(folder.file(name, content.substr(0, length)), placed());
            EXPECT_TRUE(piece || !piece.error().text().empty());
        }
}

}  // namespace
}  // namespace noonmark
