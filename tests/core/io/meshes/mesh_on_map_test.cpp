#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/geo/crs.h"
#include "core/io/pieces/read_part.h"
#include "tests/core/city/mesh_fixtures.h"
#include "tests/core/io/piece_checks.h"
#include "tests/core/io/temporary_folder.h"

// Meshes in map coordinates, in each format.
namespace noonmark {
namespace {

using testing::HasSubstr;
using tests::warns;

constexpr glm::dvec3 rdPlace{121'687.123, 487'484.456, 1.25};  // Amsterdam, EPSG:28992, metres
constexpr glm::dvec3 boxSize{20, 12, 30};

// The corners of a closed box and its twelve triangles.
std::vector<glm::dvec3> cornersAt(glm::dvec3 low, glm::dvec3 extent = boxSize) {
    std::vector<glm::dvec3> corners;
    for (const glm::vec3 unit : tests::box({0, 0, 0}, {1, 1, 1}).vertices)
        corners.push_back(low + glm::dvec3(unit) * extent);
    return corners;
}

const std::vector<glm::uvec3>& facesOfBox() {
    static const std::vector<glm::uvec3> faces = tests::box({0, 0, 0}, {1, 1, 1}).triangles;
    return faces;
}

std::string objOf(const std::vector<glm::dvec3>& corners, const std::string& name = "tower") {
    std::string text = "o " + name + "\n";
    for (const glm::dvec3& p : corners) text += fmt::format("v {:.4f} {:.4f} {:.4f}\n", p.x, p.y, p.z);
    for (const glm::uvec3 t : facesOfBox()) text += fmt::format("f {} {} {}\n", t.x + 1, t.y + 1, t.z + 1);
    return text;
}

std::string stlOf(const std::vector<glm::dvec3>& corners) {
    std::string text = "solid tower\n";
    for (const glm::uvec3 t : facesOfBox()) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (int i = 0; i < 3; ++i)
            text += fmt::format("  vertex {:.4f} {:.4f} {:.4f}\n", corners[t[i]].x, corners[t[i]].y,
                                corners[t[i]].z);
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid tower\n";
}

std::string plyOf(const std::vector<glm::dvec3>& corners) {
    std::string text = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty uchar kind\nproperty double x\nproperty double "
        "y\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        corners.size(), facesOfBox().size());
    for (const glm::dvec3& p : corners) text += fmt::format("7 {:.4f} {:.4f} {:.4f}\n", p.x, p.y, p.z);
    for (const glm::uvec3 t : facesOfBox()) text += fmt::format("3 {} {} {}\n", t.x, t.y, t.z);
    return text;
}

template <class Number>
void appendNumber(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::string binaryPlyOf(const std::vector<glm::dvec3>& corners) {
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double "
        "y\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        corners.size(), facesOfBox().size());
    for (const glm::dvec3& p : corners)
        for (int axis = 0; axis < 3; ++axis) appendNumber(bytes, p[axis]);
    for (const glm::uvec3 t : facesOfBox()) {
        bytes.push_back(3);
        for (int i = 0; i < 3; ++i) appendNumber(bytes, std::int32_t(t[i]));
    }
    return bytes;
}

std::string binaryStlOf(const std::vector<glm::dvec3>& corners) {
    std::string bytes(80, ' ');
    appendNumber(bytes, std::uint32_t(facesOfBox().size()));
    for (const glm::uvec3 t : facesOfBox()) {
        bytes.append(12, '\0');
        for (int i = 0; i < 3; ++i)
            for (int axis = 0; axis < 3; ++axis) appendNumber(bytes, float(corners[t[i]][axis]));
        bytes.append(2, '\0');
    }
    return bytes;
}

std::string daeOf(const std::vector<glm::dvec3>& corners, const std::string& axis, const std::string& meter) {
    std::string positions, faces;
    for (const glm::dvec3& p : corners) positions += fmt::format("{:.4f} {:.4f} {:.4f} ", p.x, p.y, p.z);
    for (const glm::uvec3 t : facesOfBox()) faces += fmt::format("{} {} {} ", t.x, t.y, t.z);
    return fmt::format(
        R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="u" meter="{}"/><up_axis>{}</up_axis></asset>
<library_geometries><geometry id="g" name="tower"><mesh>
<source id="p"><float_array id="a" count="{}">{}</float_array><technique_common><accessor source="#a" count="{}" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="{}"><input semantic="VERTEX" source="#v" offset="0"/><p>{}</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="tower"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)",
        meter, axis, corners.size() * 3, positions, corners.size(), facesOfBox().size(), faces);
}

ReadSettings onMap(const std::string& crs) {
    ReadSettings settings;
    settings.crs = crs;
    return settings;
}

Result<FilePiece> readMapMesh(const std::string& name, const std::string& content,
                              const ReadSettings& settings) {
    const tests::TemporaryFolder folder;
    NoProgress progress;
    return readMesh(folder.file(name, content), settings, progress, {});
}

// Where a building's south-western corner lies on the map, and how large it is.
void expectAt(const Result<FilePiece>& piece, const std::string& crs, glm::dvec2 corner, glm::dvec3 sizeM,
              double toleranceM) {
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_EQ(piece->buildings.size(), 1U);
    const LonLat place = CrsToLonLat::of(crs)->lonLat(std::vector{corner}).front();
    const glm::dvec2 expected = piece->frame->localFromLonLat(place);
    const Part& part = piece->buildings[0]->parts.at(0);
    double awayM = 1e9;
    for (const glm::vec3 vertex : part.mesh->vertices)
        awayM = std::min(awayM, glm::distance(glm::dvec2(vertex.x, vertex.y), expected));
    EXPECT_LE(awayM, toleranceM);
    constexpr double turnM = 0.7;  // the map's north is not true north
    const Box2 box = bounds(*piece->buildings[0]);
    EXPECT_NEAR(box.high.x - box.low.x, sizeM.x, toleranceM + turnM);
    EXPECT_NEAR(box.high.y - box.low.y, sizeM.y, toleranceM + turnM);
    EXPECT_NEAR(part.topM - part.bottomM, sizeM.z, toleranceM);
}

TEST(MeshOnMap, TextFormatsKeepMillimetres) {
    const auto corners = cornersAt(rdPlace);
    const ReadSettings settings = onMap("EPSG:28992");
    for (const auto& [name, content] : {std::pair("a.obj", objOf(corners)),
                                        {"a.stl", stlOf(corners)},
                                        {"a.ply", plyOf(corners)},
                                        {"b.ply", binaryPlyOf(corners)}}) {
        const auto piece = readMapMesh(name, content, settings);
        expectAt(piece, "EPSG:28992", glm::dvec2(rdPlace), boxSize, 0.002);
        ASSERT_TRUE(piece);
        EXPECT_NEAR(piece->buildings[0]->parts[0].bottomM, 1.25, 0.002) << name;
        EXPECT_TRUE(warns(*piece,
                          "the file does not state which axis is up; z was taken, since its "
                          "coordinates along y are those of a map"))
            << name;
        EXPECT_FALSE(warns(*piece, "float32")) << name;
    }
}

TEST(MeshOnMap, BinaryFloatsAreReadAndTheirRoundingIsReported) {
    const auto piece =
        readMapMesh("a.stl", binaryStlOf(cornersAt({350'000.3, 5'800'000.4, 30})), onMap("EPSG:25833"));
    expectAt(piece, "EPSG:25833", {350'000.3, 5'800'000.4}, boxSize, 0.6);
    EXPECT_TRUE(warns(*piece, "float32, which rounds them to 0.5 m"));
}

TEST(MeshOnMap, NewYorkIsInSurveyFeet) {
    constexpr double foot = 1200.0 / 3937;
    const glm::dvec3 place{987'654.25, 211'234.75, 40};
    const auto piece = readMapMesh("a.obj", objOf(cornersAt(place, {100, 80, 600})), onMap("EPSG:2263"));
    expectAt(piece, "EPSG:2263", glm::dvec2(place), {100 * foot, 80 * foot, 600 * foot}, 0.02);
    EXPECT_TRUE(warns(*piece, "0.3048006"));
}

TEST(MeshOnMap, HeightsTakeTheVerticalUnit) {
    const auto piece = readMapMesh("a.obj", objOf(cornersAt({987'654.25, 211'234.75, 10}, {100, 80, 60})),
                                   onMap("EPSG:2263+5703"));
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_NEAR(topM(*piece->buildings[0]), 70, 0.01);
}

TEST(MeshOnMap, MillimetresAreScaledBeforeAnyLimit) {
    ReadSettings settings = onMap("EPSG:28992");
    settings.meshUnit = LengthUnit::millimetres;
    const auto piece = readMapMesh("a.obj", objOf(cornersAt(rdPlace * 1000.0, boxSize * 1000.0)), settings);
    expectAt(piece, "EPSG:28992", glm::dvec2(rdPlace), boxSize, 0.05);
}

TEST(MeshOnMap, ColladaStatesItsAxisAndUnit) {
    ReadSettings settings;
    settings.meshAnchor = LonLat{4.9, 52.37};
    const auto piece =
        readMapMesh("a.dae", daeOf(cornersAt({0, 0, 0}, boxSize / 0.0254), "Z_UP", "0.0254"), settings);
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->format, "COLLADA");
    EXPECT_NEAR(topM(*piece->buildings.at(0)), 30, 0.01);
    EXPECT_NEAR(bounds(*piece->buildings[0]).high.x, 20, 0.01);
    EXPECT_NEAR(bounds(*piece->buildings[0]).high.y, 12, 0.01);
    const auto y = readMapMesh("b.dae", daeOf(cornersAt({0, 0, 0}, boxSize), "Y_UP", "1"), settings);
    ASSERT_TRUE(y) << y.error().text();
    EXPECT_NEAR(topM(*y->buildings.at(0)), 12, 0.01);
}

TEST(MeshOnMap, AnUnnamedNodeOfColladaIsCalledByItsShape) {
    ReadSettings settings;
    settings.meshAnchor = LonLat{4.9, 52.37};
    std::string text = daeOf(cornersAt({0, 0, 0}, boxSize), "Z_UP", "1");
    constexpr std::string_view named = R"(<node id="n" name="tower">)";
    text.replace(text.find(named), named.size(), "<node>");
    const auto piece = readMapMesh("a.dae", text, settings);
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->buildings.at(0)->sourceId, "tower");
}

TEST(MeshOnMap, ACoordinateSystemThatCannotBeIsRefused) {
    const auto piece = readMapMesh("a.obj", objOf(cornersAt(rdPlace)), onMap("EPSG:25833"));
    ASSERT_FALSE(piece);
    EXPECT_THAT(piece.error().what, HasSubstr("cannot belong to"));
    const auto local = readMapMesh("a.obj", objOf(cornersAt({0, 0, 0})), onMap("EPSG:28992"));
    ASSERT_FALSE(local);
    EXPECT_THAT(local.error().what, HasSubstr("near its own origin"));
}

TEST(MeshOnMap, AMeshAboutItsOriginStaysBesideACity) {
    ReadSettings settings = onMap("EPSG:28992");
    settings.frame = Frame({4.9, 52.37});
    const auto piece = readMapMesh("a.obj", objOf(cornersAt({0, 0, 0})), settings);
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_TRUE(warns(*piece, std::string(originAsAnchor).c_str()));
    settings.frame = Frame({-74, 40.7});
    const auto far = readMapMesh("a.obj", objOf(cornersAt(rdPlace)), settings);
    ASSERT_FALSE(far);
    EXPECT_THAT(far.error().what, HasSubstr("from the other files"));
}

TEST(MeshOnMap, StlAndColladaThatPromiseTooMuchAreRefused) {
    ReadSettings settings;
    settings.meshAnchor = LonLat{4.9, 52.37};
    std::string stl = binaryStlOf(cornersAt({0, 0, 0}));
    stl.replace(80, 4, "\xFF\xFF\xFF\x7F");
    EXPECT_FALSE(readMapMesh("a.stl", stl, settings));
    const std::string dae = daeOf(cornersAt({0, 0, 0}), "Z_UP", "1");
    for (std::size_t length = 0; length < dae.size(); length += 97)
        EXPECT_FALSE(readMapMesh("a.dae", dae.substr(0, length), settings)) << length;
    std::string wrong = dae;
    wrong.replace(wrong.find("<p>0 "), 5, "<p>4000000000 ");
    const auto piece = readMapMesh("a.dae", wrong, settings);
    EXPECT_TRUE(!piece || !piece->buildings.empty());
}

TEST(MeshOnMap, BrokenNumbersEndInAWarningOrAnError) {
    std::string text = objOf(cornersAt(rdPlace));
    text.insert(text.find("f "), "v 1e400 nan x\nv 5\n");
    const auto piece = readMapMesh("a.obj", text, onMap("EPSG:28992"));
    EXPECT_TRUE(!piece || !piece->buildings.empty());
    const auto cut =
        readMapMesh("b.ply", binaryPlyOf(cornersAt(rdPlace)).substr(0, 300), onMap("EPSG:28992"));
    EXPECT_FALSE(cut);
}

// For which PLY has no field: the points are those of a box at the model's zero.
TEST(MeshOnMap, TheOffsetInACommentOfAPlyCounts) {
    std::string ply = plyOf(cornersAt({0.123, 0.456, 1.25}));
    ply.replace(ply.find("element vertex"), 0, "comment offset 121687 487484 0\n");
    const auto piece = readMapMesh("tower.ply", ply, onMap("EPSG:28992"));
    ASSERT_TRUE(piece) << piece.error().text();
    expectAt(piece, "EPSG:28992", glm::dvec2(rdPlace), boxSize, 0.02);
    EXPECT_TRUE(warns(*piece, "offset in a comment"));
    ply.replace(ply.find("comment offset"), 14, "comment colour");
    EXPECT_FALSE(readMapMesh("tower.ply", ply, onMap("EPSG:28992"))) << "near its own origin";
}

}  // namespace
}  // namespace noonmark
