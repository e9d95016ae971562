#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "core/io/files/plain_file.h"
#include "core/io/meshes/stated_axes.h"
#include "core/io/pieces/read_part.h"
#include "tests/core/io/piece_checks.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

std::string groups(std::initializer_list<std::pair<int, std::string>> pairs) {
    std::string text;
    for (const auto& [code, value] : pairs) text += std::to_string(code) + "\n" + value + "\n";
    return text;
}

std::string header(int units) {
    return groups(
        {{0, "SECTION"}, {2, "HEADER"}, {9, "$INSUNITS"}, {70, std::to_string(units)}, {0, "ENDSEC"}});
}

std::string drawing(const std::string& entities, const std::string& before = {}) {
    return before + groups({{0, "SECTION"}, {2, "ENTITIES"}}) + entities +
           groups({{0, "ENDSEC"}, {0, "EOF"}});
}

// A closed rectangle of 20 x 10, 30 high, on layer "tower".
std::string outline(const char* thickness = "30") {
    return groups({{0, "LWPOLYLINE"},
                   {8, "tower"},
                   {90, "4"},
                   {70, "1"},
                   {39, thickness},
                   {10, "0"},
                   {20, "0"},
                   {10, "20"},
                   {20, "0"},
                   {10, "20"},
                   {20, "10"},
                   {10, "0"},
                   {20, "10"}});
}

std::string face(std::initializer_list<std::array<int, 3>> corners) {
    std::string text = groups({{0, "3DFACE"}, {8, "faces"}});
    int code = 10;
    for (const auto& corner : corners) {
        for (int axis = 0; axis < 3; ++axis)
            text += groups({{code + 10 * axis, std::to_string(corner[std::size_t(axis)])}});
        ++code;
    }
    return text;
}

// The faces of a box of 6 x 4 x 9.
std::string boxFaces() {
    return face({{0, 0, 0}, {0, 4, 0}, {6, 4, 0}, {6, 0, 0}}) +
           face({{0, 0, 9}, {6, 0, 9}, {6, 4, 9}, {0, 4, 9}}) +
           face({{0, 0, 0}, {6, 0, 0}, {6, 0, 9}, {0, 0, 9}}) +
           face({{6, 0, 0}, {6, 4, 0}, {6, 4, 9}, {6, 0, 9}}) +
           face({{6, 4, 0}, {0, 4, 0}, {0, 4, 9}, {6, 4, 9}}) +
           face({{0, 4, 0}, {0, 0, 0}, {0, 0, 9}, {0, 4, 9}});
}

TEST(DxfMasses, AnOutlineWithAThicknessIsExtrudedInItsOwnUnit) {
    const TemporaryFolder folder;
    const auto piece = readMass(folder.file("mass.dxf", drawing(outline("30"), header(2)))).value();
    const PieceExtent extent = extentOf(piece);
    EXPECT_NEAR(extent.topM, 30 * 0.3048, 1e-3);
    EXPECT_NEAR(extent.box.high.x - extent.box.low.x, 20 * 0.3048, 1e-3);
    EXPECT_NEAR(extent.box.high.y - extent.box.low.y, 10 * 0.3048, 1e-3);
    EXPECT_EQ(piece.format, "DXF");
    EXPECT_THAT(allWarnings(piece), HasSubstr("feet ($INSUNITS 2)"));
}

TEST(DxfMasses, WithoutAUnitThatOfTheSettingsIsStatedAsAssumed) {
    const TemporaryFolder folder;
    const auto piece = readMass(folder.file("mass.dxf", drawing(outline()))).value();
    EXPECT_NEAR(extentOf(piece).topM, 30, 1e-3);
    EXPECT_THAT(allWarnings(piece), HasSubstr("states no unit"));
}

TEST(DxfMasses, FacesMakeASolidWithZUp) {
    const TemporaryFolder folder;
    const auto piece = readMass(folder.file("box.dxf", drawing(boxFaces(), header(6)))).value();
    ASSERT_EQ(piece.buildings.size(), 1U);
    const PieceExtent extent = extentOf(piece);
    EXPECT_NEAR(extent.topM, 9, 1e-3);
    EXPECT_NEAR(extent.box.high.y - extent.box.low.y, 4, 1e-3);
    EXPECT_THAT(allWarnings(piece), testing::Not(HasSubstr("not closed")));
}

TEST(DxfMasses, APolyfaceMeshIsRead) {
    const auto point = [](int x, int y, int z) {
        return groups({{0, "VERTEX"},
                       {70, "192"},
                       {10, std::to_string(x)},
                       {20, std::to_string(y)},
                       {30, std::to_string(z)}});
    };
    const auto triangle = [](int a, int b, int c) {
        return groups({{0, "VERTEX"},
                       {70, "128"},
                       {71, std::to_string(a)},
                       {72, std::to_string(-b)},
                       {73, std::to_string(c)}});
    };
    const std::string mesh = groups({{0, "POLYLINE"}, {8, "mesh"}, {70, "64"}}) + point(0, 0, 0) +
                             point(10, 0, 0) + point(0, 10, 0) + point(0, 0, 12) + triangle(1, 3, 2) +
                             triangle(1, 2, 4) + triangle(2, 3, 4) + triangle(3, 1, 4) +
                             groups({{0, "SEQEND"}});
    const TemporaryFolder folder;
    const auto piece = readMass(folder.file("mesh.dxf", drawing(mesh, header(6)))).value();
    EXPECT_NEAR(extentOf(piece).topM, 12, 1e-3);
}

TEST(DxfMasses, ADrawingIsOneWhateverItIsCalled) {
    const TemporaryFolder folder;
    const auto piece = readMass(folder.file("mass.cad", drawing(outline(), header(6))));
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->format, "DXF");
}

TEST(DxfMasses, BlocksAreInsertedScaledAndTurned) {
    const std::string blocks = groups({{0, "SECTION"}, {2, "BLOCKS"}, {0, "BLOCK"}, {2, "t"}, {10, "0"}}) +
                               outline() + groups({{0, "ENDBLK"}, {0, "ENDSEC"}});
    const std::string insert = groups({{0, "INSERT"},
                                       {8, "0"},
                                       {2, "t"},
                                       {10, "100"},
                                       {20, "50"},
                                       {41, "2"},
                                       {42, "2"},
                                       {43, "2"},
                                       {50, "90"}});
    const TemporaryFolder folder;
    const auto piece = readMass(folder.file("block.dxf", drawing(insert, header(6) + blocks))).value();
    const PieceExtent extent = extentOf(piece);
    EXPECT_NEAR(extent.topM, 60, 1e-3);
    EXPECT_NEAR(extent.box.low.x, 80, 1e-2) << "turned to the left";
    EXPECT_NEAR(extent.box.high.x, 100, 1e-2);
    EXPECT_NEAR(extent.box.high.y, 90, 1e-2);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

std::string blockOf(const std::string& name, const std::string& content) {
    return groups({{0, "BLOCK"}, {2, name}}) + content + groups({{0, "ENDBLK"}});
}

std::string blocks(const std::string& content) {
    return groups({{0, "SECTION"}, {2, "BLOCKS"}}) + content + groups({{0, "ENDSEC"}});
}

// Block "inner" holds the outline of 20 x 10, 30 high; "outer" inserts it at (5, 0) in half its size; the
// drawing inserts "outer" at (100, 0) turned by 90 deg: x from 100 - 5 to 100, y from 5 to 15, 15 high.
TEST(DxfMasses, BlocksInBlocksAreTurnedAndScaledTogether) {
    const std::string nested =
        blocks(blockOf("inner", outline()) +
               blockOf("outer",
                       groups({{0, "INSERT"}, {2, "inner"}, {10, "5"}, {41, ".5"}, {42, ".5"}, {43, ".5"}})));
    const std::string insert = groups({{0, "INSERT"}, {2, "outer"}, {10, "100"}, {50, "90"}});
    const TemporaryFolder folder;
    const PieceExtent extent =
        extentOf(readMass(folder.file("nested.dxf", drawing(insert, header(6) + nested))).value());
    EXPECT_NEAR(extent.box.low.x, 95, 1e-3);
    EXPECT_NEAR(extent.box.high.x, 100, 1e-3);
    EXPECT_NEAR(extent.box.low.y, 5, 1e-3);
    EXPECT_NEAR(extent.box.high.y, 15, 1e-3);
    EXPECT_NEAR(extent.topM, 15, 1e-3);
}

TEST(DxfMasses, RowsAndColumnsOfABlockAreBuildingsOfTheirOwn) {
    const std::string insert =
        groups({{0, "INSERT"}, {2, "t"}, {70, "3"}, {71, "2"}, {44, "40"}, {45, "25"}});
    const TemporaryFolder folder;
    const auto file = folder.file("rows.dxf", drawing(insert, header(6) + blocks(blockOf("t", outline()))));
    const auto piece = readMass(file).value();
    EXPECT_EQ(piece.buildings.size(), 6U);
    EXPECT_NEAR(extentOf(piece).box.high.x, 2 * 40 + 20, 1e-3);
    EXPECT_NEAR(extentOf(piece).box.high.y, 25 + 10, 1e-3);
    const std::string many = groups({{0, "INSERT"}, {2, "t"}, {70, "2000"}, {71, "2000"}});
    const auto refused =
        readMass(folder.file("many.dxf", drawing(many, header(6) + blocks(blockOf("t", outline())))));
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), HasSubstr("10,000 times"));
}

// The extrusion direction -z mirrors x: an insert at x = 100 lies at -100, its outline from there to the
// left.
TEST(DxfMasses, AMirroredBlockLiesOnTheOtherSide) {
    const std::string insert = groups({{0, "INSERT"}, {2, "t"}, {10, "100"}, {30, "-30"}, {230, "-1"}});
    const TemporaryFolder folder;
    const auto file =
        folder.file("mirrored.dxf", drawing(insert, header(6) + blocks(blockOf("t", outline()))));
    const PieceExtent extent = extentOf(readMass(file).value());
    EXPECT_NEAR(extent.box.low.x, -120, 1e-3);
    EXPECT_NEAR(extent.box.high.x, -100, 1e-3);
    EXPECT_NEAR(extent.topM, 30, 1e-3);
}

TEST(DxfMasses, WhatIsDrawnOnSheetsIsNoMass) {
    const TemporaryFolder folder;
    const std::string frame = replaced(outline(), "8\ntower\n", "8\nframe\n67\n1\n");
    const auto piece = readMass(folder.file("sheet.dxf", drawing(boxFaces() + frame, header(6)))).value();
    EXPECT_NEAR(extentOf(piece).topM, 9, 1e-3) << "not the 30 m of the frame";
}

TEST(DxfMasses, OutlinesWithoutAThicknessTakeTheStatedHeight) {
    const TemporaryFolder folder;
    const auto file = folder.file("flat.dxf", drawing(outline("0"), header(1)));
    const auto refused = readMass(file);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), HasSubstr("--default-height METRES"));
    ReadSettings settings;
    settings.meshAnchor = LonLat{-73.98, 40.75};
    settings.defaultHeightM = 12.5;
    NoProgress progress;
    const auto piece = readMesh(file, settings, progress, {});
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_EQ(piece->buildings.size(), 1U);
    EXPECT_NEAR(extentOf(*piece).topM, 12.5, 1e-3) << "metres, whatever the drawing's unit";
    EXPECT_NEAR(extentOf(*piece).box.high.x - extentOf(*piece).box.low.x, 20 * 0.0254, 1e-4);
    EXPECT_THAT(allWarnings(*piece), HasSubstr("12.5 m high"));
}

// A pyramid of 10 x 10, 6 high, as a MESH: five points, a face of four and four of three corners.
TEST(DxfMasses, AMeshEntityIsRead) {
    std::string mesh = groups({{0, "MESH"}, {8, "roof"}, {71, "2"}, {72, "0"}, {91, "0"}, {92, "5"}});
    for (const auto& [x, y, z] :
         std::vector<std::array<int, 3>>{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {5, 5, 6}})
        mesh += groups({{10, std::to_string(x)}, {20, std::to_string(y)}, {30, std::to_string(z)}});
    mesh += groups({{93, "21"}});
    for (const char* number : {"4", "0", "3", "2", "1", "3", "0", "1", "4", "3", "1",
                               "2", "4", "3", "2", "3", "4", "3", "3", "0", "4"})
        mesh += groups({{90, number}});
    mesh += groups({{94, "1"}, {90, "0"}, {90, "1"}, {95, "0"}});
    const TemporaryFolder folder;
    const auto piece = readMass(folder.file("mesh.dxf", drawing(mesh, header(6)))).value();
    ASSERT_EQ(piece.buildings.size(), 1U);
    EXPECT_NEAR(extentOf(piece).topM, 6, 1e-3);
    EXPECT_NEAR(area(piece.buildings[0]->parts[0].footprint), 100, 1e-2);
    EXPECT_THAT(allWarnings(piece), testing::Not(HasSubstr("not closed")));
}

TEST(DxfMasses, EveryUnitOfInsUnitsIsObeyed) {
    const TemporaryFolder folder;
    for (const auto& [code, metres] : std::vector<std::pair<int, double>>{{1, 0.0254},
                                                                          {2, 0.3048},
                                                                          {4, 0.001},
                                                                          {5, 0.01},
                                                                          {6, 1.0},
                                                                          {10, 0.9144},
                                                                          {14, 0.1},
                                                                          {21, 1200.0 / 3937}}) {
        const std::string wide = std::to_string(20 / metres), high = std::to_string(30 / metres);
        const std::string square = groups({{0, "LWPOLYLINE"},
                                           {70, "1"},
                                           {39, high},
                                           {10, "0"},
                                           {20, "0"},
                                           {10, wide},
                                           {20, "0"},
                                           {10, wide},
                                           {20, wide},
                                           {10, "0"},
                                           {20, wide}});
        const auto piece = readMass(folder.file("unit.dxf", drawing(square, header(code))));
        ASSERT_TRUE(piece) << code << piece.error().text();
        EXPECT_NEAR(extentOf(*piece).topM, 30, 0.01) << code;
    }
}

TEST(DxfMasses, AcisSolidsAreNamed) {
    const TemporaryFolder folder;
    const auto refused =
        readMass(folder.file("solids.dxf", drawing(groups({{0, "3DSOLID"}, {8, "0"}, {0, "REGION"}}))));
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(),
                testing::AllOf(HasSubstr("ACIS solids, 3DSOLID (1)"), HasSubstr("ACIS solids, REGION (1)"),
                               HasSubstr("CONVTOMESH")));
}

TEST(DxfMasses, ArcsAreRounded) {
    // A circle of radius 10 as two half circles: bulge 1.
    const std::string circle = groups({{0, "LWPOLYLINE"},
                                       {70, "1"},
                                       {39, "20"},
                                       {10, "-10"},
                                       {20, "0"},
                                       {42, "1"},
                                       {10, "10"},
                                       {20, "0"},
                                       {42, "1"}});
    const TemporaryFolder folder;
    const auto piece = readMass(folder.file("round.dxf", drawing(circle, header(6)))).value();
    const Footprint& plan = piece.buildings.front()->parts.front().footprint;
    EXPECT_NEAR(area(plan), 314.16, 2);
}

TEST(DxfMasses, WhatIsLeftOutIsStated) {
    const TemporaryFolder folder;
    const std::string others = groups({{0, "3DSOLID"}, {8, "0"}, {0, "LINE"}, {10, "1"}});
    const auto piece = readMass(folder.file("mixed.dxf", drawing(outline() + others, header(6)))).value();
    EXPECT_THAT(allWarnings(piece), HasSubstr("3DSOLID (1)"));
    const auto none = readMass(folder.file("solids.dxf", drawing(others + outline("0"))));
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().text(), testing::AllOf(HasSubstr("no mass"), HasSubstr("3DSOLID (1)"),
                                                    HasSubstr("without a thickness (1)")));
}

// In the middle of an entity, between two, and before its last line: what is missing cannot be seen in the
// masses that were read.
TEST(DxfMasses, ADrawingThatIsCutOffIsRefused) {
    const TemporaryFolder folder;
    const std::string whole = drawing(outline() + boxFaces(), header(6));
    ASSERT_TRUE(readMass(folder.file("whole.dxf", whole)));
    for (const std::size_t length :
         {whole.find("3DFACE") + 20, whole.find("3DFACE"), whole.rfind("0\nEOF"), whole.size() - 2}) {
        const auto piece = readMass(folder.file("cut.dxf", whole.substr(0, length)));
        ASSERT_FALSE(piece) << length;
        EXPECT_THAT(piece.error().text(), HasSubstr("cut off: its last line should be EOF"));
    }
}

TEST(DxfMasses, HostileDrawingsEndWithAnError) {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& text) {
        const auto piece = readMass(folder.file("hostile.dxf", text));
        return piece ? std::string() : piece.error().text();
    };
    EXPECT_THAT(refusal("AutoCAD Binary DXF\r\n\x1a"), HasSubstr("ASCII DXF"));
    std::string doubling = groups({{0, "SECTION"}, {2, "BLOCKS"}, {0, "BLOCK"}, {2, "b0"}}) + outline();
    for (int i = 1; i < 40; ++i) {
        const std::string insert = groups({{0, "INSERT"}, {2, "b" + std::to_string(i - 1)}});
        doubling += groups({{0, "BLOCK"}, {2, "b" + std::to_string(i)}}) + insert + insert;
    }
    doubling += groups({{0, "ENDBLK"}, {0, "ENDSEC"}});
    EXPECT_THAT(refusal(drawing(groups({{0, "INSERT"}, {2, "b39"}}), doubling)), HasSubstr("too often"));
    const std::string whole = drawing(outline() + boxFaces(), header(6));
    for (std::size_t cut = 0; cut < whole.size(); cut += 97) {
        EXPECT_FALSE(readMass(folder.file("cut.dxf", whole.substr(0, cut)))) << cut;  // EOF is missing
    }
}

TEST(StatedAxes, AreThoseOfTheFile) {
    const TemporaryFolder folder;
    const auto dxf = findStatedAxes(folder.file("a.dxf", drawing(outline(), header(4))));
    ASSERT_TRUE(dxf);
    EXPECT_FALSE(dxf->yUp);
    EXPECT_EQ(dxf->metresPerUnit, 0.001);
    EXPECT_FALSE(findStatedAxes(folder.file("b.dxf", drawing(outline(), header(0))))->metresPerUnit);
    EXPECT_FALSE(findStatedAxes(folder.file("c.obj", "v 0 0 0\n")));
    EXPECT_EQ(detectFileKind(folder.file("d.txt", drawing(outline()))).value(), FileKind::mesh);
    EXPECT_FALSE(beginsIfc("ISO-10303-21;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));"));
}

}  // namespace
}  // namespace noonmark
