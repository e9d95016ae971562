#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/io/elements/read_glazing.h"
#include "core/io/pieces/read_part.h"
#include "core/io/read_city.h"
#include "core/receivers/points/glazing_receivers.h"
#include "core/receivers/receivers.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using testing::HasSubstr;
using tests::TemporaryFolder;

struct Millimetres {
    int x, y, z;
};

/// Writes an IFC of boxes in millimetres.
class IfcWriter {
public:
    // `origin` of the site, and the direction of true north in the model.
    explicit IfcWriter(std::string schema = "IFC2X3") : schema_(std::move(schema)) {
        text_ = R"(#1=IFCPERSON($,'a',$,$,$,$,$,$);
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
#13=IFCSITE('0000000000000000000002',#5,'site',$,$,#12,$,$,.ELEMENT.,(50,43,30),(7,6,0),60000.,$,$);
#14=IFCLOCALPLACEMENT(#12,#9);
#15=IFCBUILDING('0000000000000000000003',#5,'house',$,$,#14,$,$,.ELEMENT.,$,$,$);
#18=IFCRELAGGREGATES('0000000000000000000005',#5,$,$,#11,(#13));
#19=IFCRELAGGREGATES('0000000000000000000006',#5,$,$,#13,(#15));
#21=IFCCARTESIANPOINT((0.,0.));
#22=IFCAXIS2PLACEMENT2D(#21,$);
#24=IFCDIRECTION((0.,0.,1.));
)";
    }

    void addStorey(const std::string& name, int elevation) {
        const int placement = placeAt({0, 0, elevation}, 14);
        storeys_.push_back({next_, placement, ""});
        add("IFCBUILDINGSTOREY('{}',#5,'{}',$,$,#{},$,$,.ELEMENT.,{}.)", id(), name, placement, elevation);
    }

    // A box in the storey that was added last, from its corner, relative to the storey.
    void addBox(const std::string& type, const std::string& name, Millimetres low, Millimetres size) {
        Storey& storey = storeys_.back();
        const int placement = placeAt({low.x + size.x / 2, low.y + size.y / 2, low.z}, storey.placement);
        const int profile = add("IFCRECTANGLEPROFILEDEF(.AREA.,$,#22,{}.,{}.)", size.x, size.y);
        const int solid = add("IFCEXTRUDEDAREASOLID(#{},#9,#24,{}.)", profile, size.z);
        const int shape = add("IFCSHAPEREPRESENTATION(#10,'Body','SweptSolid',(#{}))", solid);
        const int product = add("IFCPRODUCTDEFINITIONSHAPE($,$,(#{}))", shape);
        const char* more = type == "IFCWALL" ? "" : ",$,$";
        const int element =
            add("{}('{}',#5,'{}',$,$,#{},#{},${})", type, id(), name, placement, product, more);
        storey.elements += fmt::format("{}#{}", storey.elements.empty() ? "" : ",", element);
    }

    // A wall along x, 0.3 m thick, with a hole from `left` and `sill` of this size.
    void addWallWithHole(int y, int length, int height, Millimetres hole, Millimetres size) {
        addBox("IFCWALL", "left", {0, y, 0}, {hole.x, 300, height});
        addBox("IFCWALL", "right", {hole.x + size.x, y, 0}, {length - hole.x - size.x, 300, height});
        if (hole.z > 0) addBox("IFCWALL", "below", {hole.x, y, 0}, {size.x, 300, hole.z});
        addBox("IFCWALL", "above", {hole.x, y, hole.z + size.z}, {size.x, 300, height - hole.z - size.z});
    }

    [[nodiscard]] std::string text() {
        std::string storeys;
        for (const Storey& storey : storeys_) {
            storeys += fmt::format("{}#{}", storeys.empty() ? "" : ",", storey.storey);
            add("IFCRELCONTAINEDINSPATIALSTRUCTURE('{}',#5,$,$,({}),#{})", id(), storey.elements,
                storey.storey);
        }
        add("IFCRELAGGREGATES('{}',#5,$,$,#15,({}))", id(), storeys);
        return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
               "FILE_NAME('a.ifc','2026-01-01T00:00:00',(''),(''),'','','');\nFILE_SCHEMA(('" +
               schema_ + "'));\nENDSEC;\nDATA;\n" + text_ + "ENDSEC;\nEND-ISO-10303-21;\n";
    }

private:
    struct Storey {
        int storey, placement;
        std::string elements;
    };

    template <class... Values>
    int add(fmt::format_string<Values...> format, Values&&... values) {
        const std::string body = fmt::format(format, std::forward<Values>(values)...);
        text_ += fmt::format("#{}={};\n", next_, body);
        return next_++;
    }
    std::string id() { return fmt::format("{:022d}", ids_++); }
    int placeAt(Millimetres at, int parent) {
        const int point = add("IFCCARTESIANPOINT(({}.,{}.,{}.))", at.x, at.y, at.z);
        const int axes = add("IFCAXIS2PLACEMENT3D(#{},$,$)", point);
        return add("IFCLOCALPLACEMENT(#{},#{})", parent, axes);
    }

    std::string schema_, text_;
    std::vector<Storey> storeys_;
    int next_ = 100, ids_ = 1000;
};

// A house of 10 x 8 m with two storeys of 3 m and a cellar of 2.5 m; a window in the south wall of each
// storey, one in the north, a door between rooms.
std::string houseWithWindows(const std::string& schema) {
    IfcWriter ifc(schema);
    ifc.addStorey("cellar", -2500);
    ifc.addBox("IFCWALL", "cellar", {0, 0, 0}, {10000, 8000, 2500});
    for (const int storey : {0, 1}) {
        ifc.addStorey(storey == 0 ? "ground" : "upper", storey * 3000);
        ifc.addWallWithHole(0, 10000, 2800, {2000, 0, 900}, {1200, 0, 1500});
        ifc.addBox("IFCWINDOW", storey == 0 ? "south" : "south-above", {2000, 100, 900}, {1200, 70, 1500});
        ifc.addBox("IFCWALL", "west", {0, 300, 0}, {300, 7400, 2800});
        ifc.addBox("IFCWALL", "east", {9700, 300, 0}, {300, 7400, 2800});
        ifc.addBox("IFCSLAB", "ceiling", {0, 0, 2800}, {10000, 8000, 200});
        if (storey == 0) {
            ifc.addWallWithHole(7700, 10000, 2800, {6000, 0, 0}, {1000, 0, 2100});
            ifc.addBox("IFCDOOR", "front", {6000, 7800, 0}, {1000, 60, 2100});
            ifc.addBox("IFCDOOR", "inner", {4000, 4000, 0}, {900, 50, 2000});
        } else {
            ifc.addBox("IFCWALL", "north", {0, 7700, 0}, {10000, 300, 2800});
        }
    }
    return ifc.text();
}

const GlazingShape* windowNamed(const GlazingRead& read, const std::string& id) {
    const auto found = std::ranges::find(read.windows, id, &GlazingShape::id);
    return found == read.windows.end() ? nullptr : &*found;
}

glm::dvec3 middleOfWindow(const GlazingShape& window) {
    glm::dvec3 sum(0);
    for (const glm::dvec3& corner : window.corners) sum += corner / double(window.corners.size());
    return sum;
}

class IfcGlazingOf : public testing::TestWithParam<const char*> {};

TEST_P(IfcGlazingOf, WindowsAndOuterDoorsLieInTheOuterFaceWithTheirStorey) {
    const TemporaryFolder folder;
    NoProgress quiet;
    const auto file = folder.file("house.ifc", houseWithWindows(GetParam()));
    const auto city = readCity({file}, {}, quiet, {});
    ASSERT_TRUE(city) << city.error().text();
    const auto read = readGlazing(file, {}, city->city, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->windows.size(), 3U);
    EXPECT_EQ(read->features, 4U);
    const GlazingShape* south = windowNamed(*read, "south");
    const GlazingShape* above = windowNamed(*read, "south-above");
    const GlazingShape* front = windowNamed(*read, "front");
    ASSERT_TRUE(south && above && front);
    EXPECT_EQ(south->floor, 0) << "the cellar is -1";
    EXPECT_EQ(above->floor, 1);
    EXPECT_NEAR(std::abs(south->azimuthDeg.value_or(-1)), 180, 0.01);
    EXPECT_NEAR(front->azimuthDeg.value_or(-1), 0, 0.01);
    EXPECT_NEAR(middleOfWindow(*south).x, 2.6, 1e-3) << "2.0 + 1.2 / 2";
    EXPECT_NEAR(middleOfWindow(*south).y, 0, 1e-3) << "the wall's outer face, not the frame at 0.1 m";
    EXPECT_NEAR(middleOfWindow(*south).z, 1.65, 1e-3) << "0.9 + 1.5 / 2";
    EXPECT_NEAR(middleOfWindow(*above).z, 4.65, 1e-3);
    EXPECT_NEAR(middleOfWindow(*front).y, 8, 1e-3);
    ASSERT_EQ(read->warnings.size(), 1U);
    EXPECT_THAT(read->warnings[0].where, HasSubstr("inner"));
}

INSTANTIATE_TEST_SUITE_P(Schemas, IfcGlazingOf, testing::Values("IFC2X3", "IFC4"));

TEST(IfcGlazing, APlaceForEachIsFoundAtTheBuilding) {
    const TemporaryFolder folder;
    NoProgress quiet;
    const auto file = folder.file("house.ifc", houseWithWindows("IFC4"));
    const auto city = readCity({file}, {}, quiet, {});
    ASSERT_TRUE(city) << city.error().text();
    const auto read = readGlazing(file, {}, city->city, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    const Region all = makeRegionFromLocalBox({{-50, -50}, {50, 50}});
    const GlazingPlaced placed = placeGlazing(city->city, all, read->windows, {});
    EXPECT_THAT(placed.warnings, testing::IsEmpty());
    ASSERT_EQ(placed.receivers.elements.size(), 3U);
    for (const auto& element : placed.receivers.elements) EXPECT_EQ(element.building, 0U);
}

// Elsewhere, and turned: what was 1.2 m wide in the south wall faces west where the model's north is east.
TEST(IfcGlazing, OfAPlacedModelItStandsWhereTheModelWasPlaced) {
    const TemporaryFolder folder;
    NoProgress quiet;
    const auto file = folder.file("house.ifc", houseWithWindows("IFC4"));
    const LonLat anchor{11.5, 48.1};
    ReadSettings reading;
    reading.meshAnchor = anchor;
    reading.meshNorthDeg = 90;
    const auto city = readCity({file}, reading, quiet, {});
    ASSERT_TRUE(city) << city.error().text();
    const auto stated = readGlazing(file, {}, city->city, quiet, {});
    ASSERT_FALSE(stated) << "the file states a place 500 km away";
    const auto read = readGlazing(file, {.place = ModelPlace{anchor, 90}}, city->city, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    const GlazingShape* south = windowNamed(*read, "south");
    ASSERT_TRUE(south);
    EXPECT_NEAR(std::fmod(south->azimuthDeg.value_or(0) + 360, 360), 270, 0.01);
    EXPECT_NEAR(middleOfWindow(*south).x, 0, 1e-3);
    EXPECT_NEAR(middleOfWindow(*south).y, -2.6, 1e-3);
    const GlazingPlaced placed =
        placeGlazing(city->city, makeRegionFromLocalBox({{-50, -50}, {50, 50}}), read->windows, {});
    EXPECT_THAT(placed.warnings, testing::IsEmpty());
    EXPECT_EQ(placed.receivers.elements.size(), 3U);
    const auto half = readGlazing(file, {.place = ModelPlace{anchor, 90, 0.5}}, city->city, quiet, {});
    ASSERT_TRUE(half) << half.error().text();
    EXPECT_NEAR(middleOfWindow(*windowNamed(*half, "south")).y, -1.3, 1e-3) << "scaled about its origin";
}

TEST(IfcGlazing, WithoutWindowsOrAPlaceItSaysSo) {
    const TemporaryFolder folder;
    NoProgress quiet;
    IfcWriter ifc;
    ifc.addStorey("ground", 0);
    ifc.addBox("IFCWALL", "block", {0, 0, 0}, {10000, 8000, 9000});
    const std::string block = ifc.text();
    const auto file = folder.file("block.ifc", block);
    const auto city = readCity({file}, {}, quiet, {});
    ASSERT_TRUE(city) << city.error().text();
    const auto none = readGlazing(file, {}, city->city, quiet, {});
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().text(), HasSubstr("IfcWindow"));
    std::string nowhere = block;
    nowhere.replace(nowhere.find("(50,43,30),(7,6,0)"), 18, "$,$");
    const auto lost = readGlazing(folder.file("lost.ifc", nowhere), {}, city->city, quiet, {});
    ASSERT_FALSE(lost);
    EXPECT_THAT(lost.error().text(), HasSubstr("does not state where it stands"));
}

// Its x axis points to the north-east: true north is 50 deg clockwise of +y.
TEST(IfcGlazing, OfThePublishedHouseAllElevenWindowsAndItsTwoOuterDoors) {
    const auto file = tests::sharedData("world/FZK.ifc");
    if (!file) GTEST_SKIP() << "shared data is missing";
    NoProgress quiet;
    const auto city = readCity({*file}, {}, quiet, {});
    ASSERT_TRUE(city) << city.error().text();
    const auto read = readGlazing(*file, {}, city->city, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    const auto faces = [&](const char* id) {
        const GlazingShape* window = windowNamed(*read, id);
        return window ? std::fmod(window->azimuthDeg.value_or(0) + 360, 360) : -1;
    };
    EXPECT_NEAR(faces("EG-Fenster-1"), 310, 0.1);
    EXPECT_NEAR(faces("EG-Fenster-4"), 130, 0.1);
    EXPECT_NEAR(faces("EG-Fenster-6"), 220, 0.1);
    EXPECT_NEAR(faces("EG-Fenster-8"), 40, 0.1);
    EXPECT_NEAR(faces("Haustuer"), 220, 0.1);
    EXPECT_NEAR(faces("Terrassentuer"), 130, 0.1);
    EXPECT_EQ(windowNamed(*read, "EG-Fenster-1")->floor, 0);
    EXPECT_EQ(read->windows.size(), 13U);
    EXPECT_EQ(windowNamed(*read, "Innentuer-1"), nullptr);
}

// The elevation of the site, 60 m in the file's millimetres, counts where elevations are asked for.
TEST(IfcPlace, ElevationsAreThoseOfTheSiteIfAsked) {
    const TemporaryFolder folder;
    NoProgress quiet;
    const auto file = folder.file("house.ifc", houseWithWindows("IFC2X3"));
    ReadSettings settings;
    EXPECT_NEAR(topM(*readMesh(file, settings, quiet, {})->buildings[0]), 6, 1e-3);
    settings.stand = Stand::absolute;
    EXPECT_NEAR(topM(*readMesh(file, settings, quiet, {})->buildings[0]), 66, 1e-3);
}

}  // namespace
}  // namespace noonmark
