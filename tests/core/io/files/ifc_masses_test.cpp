#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/files/plain_file.h"
#include "core/io/meshes/ifc_site.h"
#include "core/io/pieces/read_part.h"
#include "tests/core/io/piece_checks.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

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
    const PieceExtent extent = extentOf(piece);
    EXPECT_NEAR(extent.topM, 60, 1e-3) << "60,000 mm";
    EXPECT_NEAR(extent.box.high.x - extent.box.low.x, 20, 1e-3);
    EXPECT_NEAR(extent.box.high.y - extent.box.low.y, 10, 1e-3);
    EXPECT_EQ(piece.format, "IFC");
}

// The mesh library leaves feet as they are: 60,000 mm are 196.85 feet.
TEST(IfcMasses, AreReadInFeet) {
    const TemporaryFolder folder;
    std::string feet = ifc;
    const auto replaceOnce = [&](const std::string& from, const std::string& to) {
        feet.replace(feet.find(from), from.size(), to);
    };
    replaceOnce(
        "#6=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);",
        "#40=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);\n#41=IFCDIMENSIONALEXPONENTS(1,0,0,0,0,0,0);\n"
        "#42=IFCMEASUREWITHUNIT(IFCLENGTHMEASURE(304.8),#40);\n"
        "#6=IFCCONVERSIONBASEDUNIT(#41,.LENGTHUNIT.,'FOOT',#42);");
    replaceOnce("20000.,10000.", "65.616798,32.808399");
    replaceOnce("60000.", "196.850394");
    replaceOnce(".ELEMENT.,$,$,$,$,$", ".ELEMENT.,(48,0,0),(11,30,0),100.,$,$");
    const auto file = folder.file("feet.ifc", feet);
    const auto piece = readMass(file).value();
    const PieceExtent extent = extentOf(piece);
    EXPECT_NEAR(extent.topM, 60, 1e-3);
    EXPECT_NEAR(extent.box.high.x - extent.box.low.x, 20, 1e-3);
    EXPECT_TRUE(warns(piece, "the coordinates are in units of 0.3048 m, as the file states"));
    EXPECT_NEAR(readIfcSite(file, {}).elevationM.value(), 30.48, 1e-9);
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
    const PieceExtent extent = extentOf(piece);
    EXPECT_NEAR(extent.box.high.x - extent.box.low.x, 20, 1e-3) << "neither tree nor bench, 40 m away";
    EXPECT_NEAR(extent.box.high.y - extent.box.low.y, 40, 1e-3) << "with its wing";
    EXPECT_THAT(allWarnings(piece), HasSubstr("IfcBuildingElementProxy (1)"));
    EXPECT_THAT(allWarnings(piece), HasSubstr("IfcFurnishingElement (1)"));
}

TEST(IfcMasses, CutOffFilesEndWithAnError) {
    const TemporaryFolder folder;
    for (std::size_t cut = 200; cut < ifc.size(); cut += 331) {
        const auto piece = readMass(folder.file("cut.ifc", ifc.substr(0, cut)));
        if (!piece) {
            EXPECT_FALSE(piece.error().what.empty());
        }
    }
}

}  // namespace
}  // namespace noonmark
