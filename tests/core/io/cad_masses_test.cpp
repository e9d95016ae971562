#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "core/io/files/plain_file.h"
#include "core/io/meshes/ifc_site.h"
#include "core/io/meshes/stated_axes.h"
#include "core/io/pieces/read_part.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::HasSubstr;
using tests::TemporaryFolder;

Result<FilePiece> readMass(const std::filesystem::path& file) {
    ReadSettings settings;
    settings.meshAnchor = LonLat{-73.98, 40.75};
    settings.frame = Frame(*settings.meshAnchor);
    NoProgress progress;
    return readMesh(file, settings, progress, {});
}

struct Extent {
    Box2 box;
    float topM = -1e30F;
};

Extent extentOf(const FilePiece& piece) {
    Extent extent;
    for (const auto& building : piece.buildings) {
        extent.box.add(bounds(*building));
        extent.topM = std::max(extent.topM, topM(*building));
    }
    return extent;
}

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

std::string allWarnings(const FilePiece& piece) {
    std::string text;
    for (const Warning& warning : piece.warnings) text += warning.what + " | " + warning.where + "\n";
    return text;
}

TEST(DxfMasses, AnOutlineWithAThicknessIsExtrudedInItsOwnUnit) {
    const TemporaryFolder folder;
    const auto piece = readMass(folder.file("mass.dxf", drawing(outline("30"), header(2)))).value();
    const Extent extent = extentOf(piece);
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
    const Extent extent = extentOf(piece);
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
    const Extent extent = extentOf(piece);
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
    const Extent extent =
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
    const Extent extent = extentOf(readMass(file).value());
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

TEST(DxfMasses, HostileDrawingsEndWithAWord) {
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

const std::string ifc = R"IFC(ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('box.ifc','2026-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('IFC2X3'));
ENDSEC;
DATA;
#1=IFCPERSON($,'a',$,$,$,$,$,$);
#2=IFCORGANIZATION($,'a',$,$,$);
#3=IFCPERSONANDORGANIZATION(#1,#2,$);
#4=IFCAPPLICATION(#2,'1','a','a');
#5=IFCOWNERHISTORY(#3,#4,$,.ADDED.,$,$,$,0);
#6=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);
#7=IFCUNITASSIGNMENT((#6));
#8=IFCCARTESIANPOINT((0.,0.,0.));
#9=IFCAXIS2PLACEMENT3D(#8,$,$);
#10=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-05,#9,$);
#11=IFCPROJECT('0000000000000000000001',#5,'p',$,$,$,$,(#10),#7);
#12=IFCLOCALPLACEMENT($,#9);
#13=IFCSITE('0000000000000000000002',#5,'site',$,$,#12,$,$,.ELEMENT.,$,$,$,$,$);
#14=IFCLOCALPLACEMENT(#12,#9);
#15=IFCBUILDING('0000000000000000000003',#5,'building',$,$,#14,$,$,.ELEMENT.,$,$,$);
#16=IFCLOCALPLACEMENT(#14,#9);
#17=IFCBUILDINGSTOREY('0000000000000000000004',#5,'storey',$,$,#16,$,$,.ELEMENT.,0.);
#18=IFCRELAGGREGATES('0000000000000000000005',#5,$,$,#11,(#13));
#19=IFCRELAGGREGATES('0000000000000000000006',#5,$,$,#13,(#15));
#20=IFCRELAGGREGATES('0000000000000000000007',#5,$,$,#15,(#17));
#21=IFCCARTESIANPOINT((0.,0.));
#22=IFCAXIS2PLACEMENT2D(#21,$);
#23=IFCRECTANGLEPROFILEDEF(.AREA.,$,#22,20000.,10000.);
#24=IFCDIRECTION((0.,0.,1.));
#25=IFCEXTRUDEDAREASOLID(#23,#9,#24,60000.);
#26=IFCSHAPEREPRESENTATION(#10,'Body','SweptSolid',(#25));
#27=IFCPRODUCTDEFINITIONSHAPE($,$,(#26));
#28=IFCLOCALPLACEMENT(#16,#9);
#29=IFCBUILDINGELEMENTPROXY('0000000000000000000008',#5,'tower',$,$,#28,#27,$,$);
#30=IFCRELCONTAINEDINSPATIALSTRUCTURE('0000000000000000000009',#5,$,$,(#29),#17);
ENDSEC;
END-ISO-10303-21;
)IFC";

TEST(IfcMasses, AreReadInTheirOwnUnitWithTheirUpAxis) {
    const TemporaryFolder folder;
    const auto file = folder.file("mass.ifc", ifc);
    EXPECT_EQ(detectFileKind(file).value(), FileKind::mesh);
    const auto piece = readMass(file).value();
    const Extent extent = extentOf(piece);
    EXPECT_NEAR(extent.topM, 60, 1e-3) << "60,000 mm";
    EXPECT_NEAR(extent.box.high.x - extent.box.low.x, 20, 1e-3);
    EXPECT_NEAR(extent.box.high.y - extent.box.low.y, 10, 1e-3);
    EXPECT_EQ(piece.format, "IFC");
}

// A tree on the site, a bench in the storey, and a wing of the building that stands apart.
std::string replacedAll(std::string text, const std::string& from, const std::string& to) {
    for (auto at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

// The same box in IFC4: without owners and kinds of composition, and with this body instead of the sweep.
std::string ifc4With(const std::string& body) {
    std::string text = replacedAll(ifc, "IFC2X3", "IFC4");
    text = replacedAll(text, ",#5,", ",$,");
    text = replacedAll(text, ".ELEMENT.", "$");
    return replacedAll(text, "#25=IFCEXTRUDEDAREASOLID(#23,#9,#24,60000.);", body);
}

const char* const boxPoints =
    "#40= "
    "IFCCARTESIANPOINTLIST3D(((-10000.,-5000.,0.),(10000.,-5000.,0.),(10000.,5000.,0.),(-10000.,5000.,0.),"
    "(-10000.,-5000.,60000.),(10000.,-5000.,60000.),(10000.,5000.,60000.),(-10000.,5000.,60000.)));\n";

TEST(IfcMasses, FacetedSetsOfIfc4AreRead) {
    const TemporaryFolder folder;
    const std::string triangles =
        std::string(boxPoints) +
        "#25= "
        "IFCTRIANGULATEDFACESET(#40,$,.T.,((1,3,2),(1,4,3),(5,6,7),(5,7,8),(1,2,6),(1,6,5),(2,3,7),(2,7,6),"
        "(3,4,8),(3,8,7),(4,1,5),(4,5,8)),$);";
    const std::string polygons =
        std::string(boxPoints) +
        "#41=IFCINDEXEDPOLYGONALFACE((1,4,3,2));\n#42=IFCINDEXEDPOLYGONALFACE((5,6,7,8));\n"
        "#43=IFCINDEXEDPOLYGONALFACE((1,2,6,5));\n#44=IFCINDEXEDPOLYGONALFACE((2,3,7,6));\n"
        "#45=IFCINDEXEDPOLYGONALFACE((3,4,8,7));\n#46=IFCINDEXEDPOLYGONALFACE((4,1,5,8));\n"
        "#25=IFCPOLYGONALFACESET(#40,.T.,(#41,#42,#43,#44,#45,#46),$);";
    const std::string curve =
        "#40=IFCCARTESIANPOINTLIST2D(((-10000.,-5000.),(10000.,-5000.),(10000.,5000.),(-10000.,5000.)));\n"
        "#41=IFCINDEXEDPOLYCURVE(#40,(IFCLINEINDEX((1,2,3)),IFCLINEINDEX((3,4,1))),$);\n"
        "#42=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#41);\n"
        "#25=IFCEXTRUDEDAREASOLID(#42,#9,#24,60000.);";
    for (const std::string& body : {triangles, polygons, curve}) {
        const auto read = readMass(folder.file("four.ifc", ifc4With(body)));
        ASSERT_TRUE(read) << read.error().text();
        ASSERT_EQ(read->buildings.size(), 1U) << body;
        const Box2 box = bounds(*read->buildings[0]);
        EXPECT_NEAR(box.high.x - box.low.x, 20, 1e-3) << body;
        EXPECT_NEAR(box.high.y - box.low.y, 10, 1e-3) << body;
        EXPECT_NEAR(topM(*read->buildings[0]), 60, 1e-3) << body;
    }
}

std::string ifcWithSurroundings();

// A rectangle of 20 x 10 m with half a circle of 5 m at its end, in chords of 10 degrees:
// 200 + 18 x 25 / 2 x sin(10 deg).
constexpr double roundEndedM2 = 239.07;

TEST(IfcMasses, ArcsOfProfilesAreChordsOfTenDegrees) {
    const TemporaryFolder folder;
    const std::string curve =
        "#40=IFCCARTESIANPOINTLIST2D(((-10000.,-5000.),(10000.,-5000.),(15000.,0.),(10000.,5000.),(-10000.,"
        "5000.)));\n"
        "#41=IFCINDEXEDPOLYCURVE(#40,(IFCLINEINDEX((1,2)),IFCARCINDEX((2,3,4)),IFCLINEINDEX((4,5,1))),$);\n"
        "#42=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#41);\n"
        "#25=IFCEXTRUDEDAREASOLID(#42,#9,#24,60000.);";
    const auto read = readMass(folder.file("round.ifc", ifc4With(curve)));
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->buildings.size(), 1U);
    EXPECT_NEAR(area(read->buildings[0]->parts[0].footprint), roundEndedM2, 0.05);
    EXPECT_NEAR(extentOf(*read).box.high.x - extentOf(*read).box.low.x, 25, 0.05);
}

TEST(IfcMasses, TrimmedCirclesOf2x3AreArcs) {
    const TemporaryFolder folder;
    const std::string curve =
        "#40=IFCCARTESIANPOINT((10000.,5000.));\n#41=IFCCARTESIANPOINT((-10000.,5000.));\n"
        "#42=IFCCARTESIANPOINT((-10000.,-5000.));\n#43=IFCCARTESIANPOINT((10000.,-5000.));\n"
        "#44=IFCPOLYLINE((#40,#41,#42,#43));\n#45=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#44);\n"
        "#46=IFCCARTESIANPOINT((10000.,0.));\n#47=IFCAXIS2PLACEMENT2D(#46,$);\n#48=IFCCIRCLE(#47,5000.);\n"
        "#49=IFCTRIMMEDCURVE(#48,(IFCPARAMETERVALUE(-1.5707963)),(IFCPARAMETERVALUE(1.5707963)),.T.,"
        ".PARAMETER.);\n#50=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#49);\n"
        "#51=IFCCOMPOSITECURVE((#45,#50),.F.);\n#52=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#51);\n"
        "#25=IFCEXTRUDEDAREASOLID(#52,#9,#24,60000.);";
    const auto read = readMass(
        folder.file("round.ifc", replacedAll(ifc, "#25=IFCEXTRUDEDAREASOLID(#23,#9,#24,60000.);", curve)));
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->buildings.size(), 1U);
    EXPECT_NEAR(area(read->buildings[0]->parts[0].footprint), roundEndedM2, 1);
}

TEST(IfcMasses, FurnitureIsLeftOutEvenIfItsShapeIsShared) {
    const TemporaryFolder folder;
    const std::string shared =
        "#40=IFCPRODUCTDEFINITIONSHAPE($,$,(#53));\n#50=IFCREPRESENTATIONMAP(#9,#26);\n"
        "#51=IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#8,$,$);\n#52=IFCMAPPEDITEM(#50,#51);\n"
        "#53=IFCSHAPEREPRESENTATION(#10,'Body','MappedRepresentation',(#52));";
    const auto piece = readMass(folder.file(
        "site.ifc", replacedAll(ifcWithSurroundings(), "#40=IFCPRODUCTDEFINITIONSHAPE($,$,(#26));", shared)));
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_NEAR(extentOf(*piece).box.high.x - extentOf(*piece).box.low.x, 20, 1e-3);
    EXPECT_THAT(allWarnings(*piece), HasSubstr("IfcFurnishingElement (1)"));
}

// The model's x axis points along (0.8, 0.6) on the map: its y axis to 36.87 deg west of grid north, which is
// (lon - 9) x sin(lat) = -0.428 deg off true north there.
TEST(IfcMasses, StandsWhereItsMapConversionPutsIt) {
    const TemporaryFolder folder;
    const std::string map =
        "#60=IFCPROJECTEDCRS('EPSG:25832',$,$,$,$,$,$);\n"
        "#61=IFCMAPCONVERSION(#10,#60,458700.,5438800.,110000.,0.8,0.6,$);\n#7=IFCUNITASSIGNMENT((#6));";
    const auto file =
        folder.file("map.ifc", replacedAll(ifc4With("#25=IFCEXTRUDEDAREASOLID(#23,#9,#24,60000.);"),
                                           "#7=IFCUNITASSIGNMENT((#6));", map));
    const auto place = findPlace(readIfcSite(file, {}));
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->northDeg, -36.87 - 0.428, 0.01);
    EXPECT_NEAR(place->elevationM, 110, 1e-6);
    NoProgress quiet;
    const auto piece = readMesh(file, {}, quiet, {});
    ASSERT_TRUE(piece) << piece.error().text();
    // 41,300 m west of the central meridian on a scale of 0.9996, at 49.1 deg.
    EXPECT_NEAR(piece->frame->origin().lonDeg, 9 - 41'300 / 0.9996 / 73'030, 2e-4);
    EXPECT_NEAR(piece->frame->origin().latDeg, 49.1, 0.01);
}

TEST(IfcMasses, BrokenIfc4EndsInAWarningOrAnError) {
    const TemporaryFolder folder;
    const std::string whole = ifc4With(
        std::string(boxPoints) + "#25=IFCTRIANGULATEDFACESET(#40,$,.T.,((1,3,2),(9,99999999999,0),(,)),$);");
    for (std::size_t cut = 300; cut < whole.size(); cut += 331) {
        const auto read = readMass(folder.file("cut.ifc", whole.substr(0, cut)));
        EXPECT_TRUE(read || !read.error().what.empty());
    }
    for (const char* body : {"#25=IFCTRIANGULATEDFACESET();", "#25=IFCPOLYGONALFACESET(#25,.T.,(#25,#7),$);",
                             "#25=IFCINDEXEDPOLYCURVE(#99,(IFCLINEINDEX(()),$),$);"}) {
        const auto read = readMass(folder.file("wrong.ifc", ifc4With(body)));
        EXPECT_TRUE(read || !read.error().what.empty());
    }
}

std::string ifcWithSurroundings() {
    const std::string more = R"IFC(#31=IFCCARTESIANPOINT((40000.,0.,0.));
#32=IFCAXIS2PLACEMENT3D(#31,$,$);
#33=IFCLOCALPLACEMENT(#12,#32);
#35=IFCPRODUCTDEFINITIONSHAPE($,$,(#26));
#36=IFCBUILDINGELEMENTPROXY('0000000000000000000010',#5,'tree',$,$,#33,#35,$,$);
#37=IFCRELCONTAINEDINSPATIALSTRUCTURE('0000000000000000000011',#5,$,$,(#36),#13);
#38=IFCFURNISHINGELEMENT('0000000000000000000012',#5,'bench',$,$,#39,#40,$);
#39=IFCLOCALPLACEMENT(#16,#32);
#40=IFCPRODUCTDEFINITIONSHAPE($,$,(#26));
#42=IFCCARTESIANPOINT((0.,30000.,0.));
#43=IFCAXIS2PLACEMENT3D(#42,$,$);
#44=IFCLOCALPLACEMENT(#16,#43);
#45=IFCPRODUCTDEFINITIONSHAPE($,$,(#26));
#46=IFCBUILDINGELEMENTPROXY('0000000000000000000013',#5,'wing',$,$,#44,#45,$,$);
#41=IFCRELCONTAINEDINSPATIALSTRUCTURE('0000000000000000000014',#5,$,$,(#38,#46),#17);
)IFC";
    std::string text = ifc;
    return text.insert(text.rfind("ENDSEC;"), more);
}

TEST(IfcMasses, TreesAndFurnitureAreLeftOutByClassAndABuildingIsOne) {
    const TemporaryFolder folder;
    const auto piece = readMass(folder.file("site.ifc", ifcWithSurroundings())).value();
    ASSERT_EQ(piece.buildings.size(), 1U);
    EXPECT_EQ(piece.buildings[0]->name, "building");
    const Extent extent = extentOf(piece);
    EXPECT_NEAR(extent.box.high.x - extent.box.low.x, 20, 1e-3) << "neither tree nor bench, 40 m away";
    EXPECT_NEAR(extent.box.high.y - extent.box.low.y, 40, 1e-3) << "with its wing";
    EXPECT_THAT(allWarnings(piece), HasSubstr("IfcBuildingElementProxy (1)"));
    EXPECT_THAT(allWarnings(piece), HasSubstr("IfcFurnishingElement (1)"));
}

TEST(IfcMasses, CutOffFilesEndWithAWord) {
    const TemporaryFolder folder;
    for (std::size_t cut = 200; cut < ifc.size(); cut += 331) {
        const auto piece = readMass(folder.file("cut.ifc", ifc.substr(0, cut)));
        if (!piece) {
            EXPECT_FALSE(piece.error().what.empty());
        }
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
