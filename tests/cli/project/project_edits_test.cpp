#include <fmt/format.h>

#include <fstream>
#include <glm/trigonometric.hpp>
#include <iterator>

#include "core/city/terrain/building_ground.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/edits/placed_building.h"
#include "tests/cli/project_command.h"
#include "tests/shared/box_obj.h"
#include "tests/shared/shared_data.h"

namespace noonmark::cli::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class ProjectEdits : public ProjectCommand {
protected:
    void SetUp() override {
        ProjectCommand::SetUp();
        done("add-scenario", {"A"});
    }

    /// A building after the scenario's edits, read from the file.
    [[nodiscard]] Building building(const std::string& name, const std::string& scenario = "A") const {
        const City city = cityOf(opened(), scenario).value().city;
        return *city.buildings[findBuilding(city, name).value()];
    }

    [[nodiscard]] std::vector<std::string> kinds() const {
        std::vector<std::string> kinds;
        const Project project = opened();
        for (const Edit& edit : project.scenarios[0].edits) kinds.emplace_back(getKind(edit));
        return kinds;
    }

    std::string mesh_ = folder_.file("box.obj", noonmark::tests::boxObj(20, 30, 100)).string();
};

TEST_F(ProjectEdits, EveryKindGoesIntoTheFileAndBack) {
    const glm::dvec2 before = findMiddle(building("One57"));
    EXPECT_THAT(done("move", {"One57", "--scenario", "A", "--east", "12", "--north", "-3.5"}),
                HasSubstr("A: Move One57 by 12.0 m east, -3.5 m north"));
    EXPECT_NEAR(findMiddle(building("One57")).x, before.x + 12, 1e-3);
    EXPECT_NEAR(findMiddle(building("One57")).y, before.y - 3.5, 1e-3);
    EXPECT_THAT(done("rotate", {"One57", "--scenario", "A", "--clockwise", "90"}), HasSubstr("Turn One57"));
    EXPECT_NEAR(findMiddle(building("One57")).x, before.x + 12, 1e-2);
    EXPECT_THAT(done("height", {"One57", "432 Park Avenue", "--scenario", "A", "--height", "150"}),
                AllOf(HasSubstr("Make One57 150.0 m high"), HasSubstr("432 Park Avenue")));
    EXPECT_NEAR(topM(building("432 Park Avenue")), 150, 1e-3);
    done("demolish", {"520 Park Avenue", "--scenario", "A"});
    EXPECT_THAT(
        done("extrude", {"--scenario", "A", "--lot", "520 Park Avenue", "--id", "New", "--storeys", "9"}),
        HasSubstr("New: 9 storeys"));
    EXPECT_THAT(done("import", {mesh_, "--scenario", "A", "--id", "Box", "--at", "-73.975,40.77"}),
                HasSubstr("20.0 m from west to east, 30.0 m from south to north, 100.0 m high"));
    done("replace", {"One57", "--scenario", "A", "--with", mesh_});
    EXPECT_THAT(kinds(), testing::ElementsAre("move", "rotate", "height", "height", "demolish", "add",
                                              "import", "replace"));
    EXPECT_THAT(done("info", {}), HasSubstr("   8 Replace One57 with One57"));
}

// The next edition of a file is read, placed, turned and scaled as the one before; what the user states anew
// holds, and so do the edits that follow.
TEST_F(ProjectEdits, AnotherEditionIsReadAndStandsAsTheOneBefore) {
    done("import", {mesh_, "--scenario", "A", "--id", "Box", "--at", "-73.975,40.77", "--mesh-unit", "ft",
                    "--up", "y", "--scale", "2", "--clockwise", "90"});
    done("move", {"Box", "--scenario", "A", "--east", "7"});
    const Box2 first = bounds(building("Box"));
    EXPECT_NEAR(topM(building("Box")), 200 * 0.3048, 0.01);
    (void)folder_.file("box.obj", noonmark::tests::boxObj(20, 30, 80));
    EXPECT_THAT(done("import", {mesh_, "--scenario", "A", "--reload"}), HasSubstr("A: reload box.obj"));
    EXPECT_NEAR(topM(building("Box")), 160 * 0.3048, 0.01) << "feet, y up, twice as large";
    const Box2 second = bounds(building("Box"));
    EXPECT_NEAR(second.low.x, first.low.x, 0.02) << "placed, turned and moved";
    EXPECT_NEAR(second.high.y, first.high.y, 0.02);
    EXPECT_THAT(kinds(), testing::ElementsAre("import", "move"));

    done("import", {mesh_, "--scenario", "A", "--reload", "--mesh-unit", "m", "--north", "3"});
    EXPECT_NEAR(topM(building("Box")), 160, 0.01);
    done("import", {mesh_, "--scenario", "A", "--reload", "--scale", "1"});
    EXPECT_NEAR(topM(building("Box")), 80, 0.01) << "in metres, which the edition before was read in";

    EXPECT_THAT(refused("import", {mesh_, "--scenario", "A"}), HasSubstr("--id NAME, or --reload"));
    EXPECT_THAT(refused("import", {mesh_, "--scenario", "A", "--reload", "--id", "Tower"}),
                HasSubstr("No earlier edition"));
    done("import", {mesh_, "--scenario", "A", "--id", "Twin", "--at", "-73.97,40.77"});
    EXPECT_THAT(refused("import", {mesh_, "--scenario", "A", "--reload"}), HasSubstr("Name one with --id"));
    EXPECT_THAT(done("import", {mesh_, "--scenario", "A", "--reload", "--id", "Twin", "--mesh-unit", "ft"}),
                HasSubstr("reload box.obj"));
    EXPECT_NEAR(topM(building("Twin")), 80 * 0.3048, 0.01);
    EXPECT_NEAR(topM(building("Box")), 80, 0.01);
}

// The windows of a proposal's IFC lie in its walls, wherever it was placed and moved to; its own place is in
// Karlsruhe.
TEST_F(ProjectEdits, WindowsOfAProposalMoveWithIt) {
    const auto house = noonmark::tests::sharedData("world/FZK.ifc");
    if (!house) GTEST_SKIP() << "shared data is missing";
    const std::string file = house->string();
    const auto windowsOf = [&](const std::string& building) {
        const CommandOutput output =
            measured("study", {"--scenario", "A", "--receivers", "windows", "--windows", file, "--start",
                               "2026-12-21", "--from", "12:00", "--hours", "1", "--step", "10", "--zone",
                               "America/New_York", "--json"});
        EXPECT_EQ(output.code, 0) << output.err;
        std::ifstream csv(folder_.path("out") / "elements.csv");
        std::size_t lines = 0;
        for (std::string line; std::getline(csv, line);)
            lines += line.find("," + building + ",") != line.npos ? 1 : 0;
        return lines;
    };
    done("import",
         {file, "--scenario", "A", "--id", "House", "--at", "-73.9750,40.7690", "--clockwise", "20"});
    EXPECT_EQ(windowsOf("House"), 13U);
    done("move", {"House", "--scenario", "A", "--east", "-40", "--north", "12"});
    done("rotate", {"House", "--scenario", "A", "--clockwise", "75"});
    EXPECT_EQ(windowsOf("House"), 13U);
    done("height", {"House", "--scenario", "A", "--height", "9"});
    EXPECT_GT(windowsOf("House"), 10U) << "stretched: its windows stay as high as they were";
}

// KIT's house moved to the sample: its y axis points 50 degrees west of north.
TEST_F(ProjectEdits, AnIfcStandsWhereItStates) {
    const auto house = noonmark::tests::sharedData("world/FZK.ifc");
    if (!house) GTEST_SKIP() << "shared data is missing";
    std::ifstream stream(*house, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    constexpr std::string_view karlsruhe = "(49,6,1,566000),(8,26,11,540400)";
    EXPECT_THAT(refused("import", {house->string(), "--scenario", "A", "--id", "Far"}),
                HasSubstr("position of the mesh is not given"));
    text.replace(text.find(karlsruhe), karlsruhe.size(), "(40,46,8,400000),(-73,-58,-30,0)");
    const std::string moved = folder_.file("moved.ifc", text).string();
    EXPECT_THAT(done("import", {moved, "--scenario", "A", "--id", "House"}),
                AllOf(HasSubstr("as it states (IfcSite)"), testing::Not(HasSubstr("not used"))));
    const glm::dvec2 place = opened().city->frame.localFromLonLat({-73.975, 40.769});
    // 12 x 10 m with its eaves of 0.5 m from the origin on, turned by 50 degrees to the west.
    done("import",
         {moved, "--scenario", "A", "--id", "Same", "--origin-at", "-73.975,40.769", "--clockwise", "-50"});
    const Box2 own = bounds(building("House")), same = bounds(building("Same"));
    EXPECT_NEAR(own.low.x, same.low.x, 0.02);
    EXPECT_NEAR(own.high.y, same.high.y, 0.02);
    EXPECT_NEAR(own.low.x, place.x - 10.5 * std::sin(glm::radians(50.0)), 0.8);
    done("import", {moved, "--scenario", "A", "--id", "Elsewhere", "--at", "-73.970,40.769"});
    EXPECT_GT(bounds(building("Elsewhere")).low.x, own.low.x + 300);
}

TEST_F(ProjectEdits, AMeshStandsWhereItIsPut) {
    done("import", {mesh_, "--scenario", "A", "--id", "middle", "--at", "-73.975,40.77", "--scale", "2",
                    "--clockwise", "90", "--east", "5"});
    const glm::dvec2 place = opened().city->frame.localFromLonLat({-73.975, 40.77});
    EXPECT_NEAR(findMiddle(building("middle")).x, place.x + 5, 0.01);
    EXPECT_NEAR(findMiddle(building("middle")).y, place.y, 0.01);
    const Box2 box = bounds(building("middle"));
    EXPECT_NEAR(box.high.x - box.low.x, 60, 0.01);  // 30 m from south to north, scaled by 2 and turned
    EXPECT_NEAR(topM(building("middle")), 200, 0.01);
    done("import", {mesh_, "--scenario", "A", "--id", "origin", "--origin-at", "-73.975,40.77"});
    EXPECT_NEAR(bounds(building("origin")).low.x, place.x, 0.01);
    EXPECT_NEAR(bounds(building("origin")).low.y, place.y, 0.01);
    done("import", {mesh_, "--scenario", "A", "--id", "feet", "--at", "-73.975,40.77", "--mesh-unit", "ft"});
    EXPECT_NEAR(topM(building("feet")), 100 * 0.3048, 0.01);
    // With another axis up it begins below its own zero: its lowest point comes to the ground, and that is
    // said.
    EXPECT_THAT(done("import", {mesh_, "--scenario", "A", "--id", "x", "--at", "-73.975,40.77", "--up", "z"}),
                HasSubstr("--stand absolute leaves it"));
    EXPECT_NEAR(topM(building("x")), 30, 0.01);
}

TEST_F(ProjectEdits, WhatStandsOnALotIsReported) {
    EXPECT_THAT(done("extrude", {"--scenario", "A", "--lot", "One57", "--id", "x", "--storeys", "3"}),
                HasSubstr("Stays on the lot without --clear: One57"));
    EXPECT_THAT(
        done("extrude", {"--scenario", "A", "--lot", "One57", "--id", "y", "--storeys", "3", "--clear"}),
        AllOf(HasSubstr("Demolish One57"), HasSubstr("Demolish x")));
}

TEST_F(ProjectEdits, AMeshTakesTheReplacedBuildingsPlaceAndName) {
    const Building old = building("One57");
    done("replace", {"One57", "--scenario", "A", "--with", mesh_});
    const Building made = building("One57");
    EXPECT_EQ(made.sourceId, old.sourceId);
    EXPECT_EQ(made.name, old.name);
    EXPECT_NEAR(findMiddle(made).x, findMiddle(old).x, 0.01);
    EXPECT_NEAR(findMiddle(made).y, findMiddle(old).y, 0.01);
    EXPECT_TRUE(made.parts[0].mesh);
}

TEST_F(ProjectEdits, ADryRunSavesNothing) {
    const auto saves = ProjectFile::open(file_).value().saves();
    EXPECT_THAT(done("demolish", {"One57", "--scenario", "A", "--dry-run"}),
                AllOf(HasSubstr("Demolish One57"), HasSubstr("nothing was saved")));
    EXPECT_THAT(refused("demolish", {"One58", "--scenario", "A", "--dry-run"}), HasSubstr("'One57'"));
    EXPECT_EQ(ProjectFile::open(file_).value().saves(), saves);
}

TEST_F(ProjectEdits, EditsAreTakenBack) {
    done("demolish", {"One57", "432 Park Avenue", "--scenario", "A"});
    done("extrude", {"--scenario", "A", "--lot", "One57", "--id", "New", "--storeys", "9"});
    EXPECT_THAT(refused("remove-edit", {"4", "--scenario", "A"}), HasSubstr("Give 1 to 3"));
    EXPECT_THAT(refused("remove-edit", {"0", "--scenario", "A"}), HasSubstr("Give 1 to 3"));
    EXPECT_THAT(done("remove-edit", {"1", "3", "--scenario", "A"}),
                AllOf(HasSubstr("no longer Demolish One57"), HasSubstr("no longer Build New")));
    EXPECT_THAT(kinds(), testing::ElementsAre("demolish"));
}

TEST_F(ProjectEdits, WhatOthersStartFromStaysWhole) {
    done("extrude", {"--scenario", "A", "--on", "One57", "--id", "New", "--height", "80"});
    done("add-scenario", {"B", "--base", "A"});
    done("height", {"New", "--scenario", "B", "--height", "60"});
    EXPECT_THAT(refused("demolish", {"New", "--scenario", "A"}),
                AllOf(HasSubstr("There is no such building"), HasSubstr("'B' starts from 'A'")));
    EXPECT_THAT(refused("remove-edit", {"2", "--scenario", "A"}), HasSubstr("'B' starts from 'A'"));
    EXPECT_THAT(refused("remove-scenario", {"A"}), HasSubstr("Remove them first: B"));
    done("rename-scenario", {"A", "First"});
    EXPECT_EQ(opened().scenarios[1].base, "First");
    done("duplicate-scenario", {"First", "Second"});
    EXPECT_EQ(opened().scenarios[1].name, "Second");
    EXPECT_EQ(opened().scenarios[1].edits.size(), 2U);
    done("remove-scenario", {"B"});
    done("remove-scenario", {"First"});
    EXPECT_EQ(opened().scenarios.size(), 1U);
}

TEST_F(ProjectEdits, MistakesSayWhatWhereAndWhatToDo) {
    EXPECT_THAT(refused("move", {"One57", "--scenario", "A"}), HasSubstr("Give --east or --north"));
    EXPECT_THAT(refused("move", {"One57", "--scenario", "A", "--east", "nan"}), HasSubstr("--east"));
    EXPECT_THAT(refused("move", {"--scenario", "A", "--east", "3"}), HasSubstr("buildings"));
    EXPECT_THAT(refused("height", {"One57", "--scenario", "A", "--height", "2001"}), HasSubstr("2000"));
    EXPECT_THAT(refused("height", {"One57", "--scenario", "A", "--height", "-1"}), HasSubstr("--height"));
    EXPECT_THAT(refused("rotate", {"One57", "--scenario", "A", "--clockwise", "inf"}),
                HasSubstr("--clockwise"));
    EXPECT_THAT(refused("rotate", {"One57", "--scenario", "Existing", "--clockwise", "3"}),
                HasSubstr("add-scenario"));
    EXPECT_THAT(refused("import", {mesh_, "--scenario", "A", "--id", "x"}), HasSubstr("--at LON,LAT"));
    EXPECT_THAT(refused("import", {mesh_, "--scenario", "A", "--id", "One57", "--at", "-73.98,40.76"}),
                HasSubstr("One57"));
    EXPECT_THAT(refused("import", {mesh_, "--scenario", "A", "--id", "x", "--at", "40.76"}),
                HasSubstr("LON,LAT"));
    EXPECT_THAT(
        refused("import", {mesh_, "--scenario", "A", "--id", "x", "--at", "-73.98,40.76", "--scale", "0"}),
        HasSubstr("--scale"));
    EXPECT_THAT(refused("import", {folder_.path("gone.obj").string(), "--scenario", "A", "--id", "x"}),
                HasSubstr("gone.obj"));
    EXPECT_THAT(refused("replace", {"nothing", "--scenario", "A", "--with", mesh_}),
                HasSubstr("There is no such building"));
    EXPECT_THAT(refused("replace", {"One57", "--scenario", "A", "--with", file_}),
                HasSubstr("OBJ, PLY, glTF, GLB, STL, COLLADA, IFC, DXF, CityJSON"));
    EXPECT_THAT(refused("extrude", {"--lot", "One57", "--id", "x"}), HasSubstr("--scenario is required"));
    EXPECT_THAT(refused("rename-scenario", {"A", "Existing"}), HasSubstr("Existing"));
    EXPECT_THAT(refused("rename-scenario", {"C", "D"}), HasSubstr("The scenarios are: Existing, A"));
    EXPECT_THAT(refused("duplicate-scenario", {"A", "A"}), HasSubstr("Two scenarios"));
    EXPECT_THAT(refused("duplicate-scenario", {"A", ""}), HasSubstr("another name"));
    EXPECT_TRUE(kinds().empty());
}

// Checks each setting by hand calculation: a lot of 40 x 30 m, storeys of 4 m.
TEST_F(ProjectEdits, ATowerHasEverySettingOfAMassing) {
    const Frame frame = opened().city->frame;
    std::string wkt = "POLYGON ((";
    for (const glm::dvec2 corner :
         {glm::dvec2{600, 1200}, {640, 1200}, {640, 1230}, {600, 1230}, {600, 1200}}) {
        const LonLat place = frame.lonLatFromLocal(corner);
        wkt += fmt::format("{}{:.9f} {:.9f}", wkt.back() == '(' ? "" : ", ", place.lonDeg, place.latDeg);
    }
    done("lot add", {"Plot", wkt + "))"});
    const std::vector<std::string> tower{"--scenario", "A", "--lot", "Plot", "--storey-height", "4", "--id"};
    const auto built = [&](const std::string& id, const std::vector<std::string>& more) {
        std::vector<std::string> all = tower;
        all.push_back(id);
        all.insert(all.end(), more.begin(), more.end());
        return done("extrude", all);
    };
    EXPECT_THAT(built("a", {"--storeys", "10"}),
                HasSubstr("10 storeys, 40.0 m; gross floor area 12,000 m2, ratio 10.0"));
    EXPECT_THAT(built("b", {"--height", "42"}), HasSubstr("10 storeys, 42.0 m; gross floor area 12,000 m2"));
    EXPECT_THAT(built("c", {"--storeys", "10", "--plate-share", "50"}),
                HasSubstr("gross floor area 6,000 m2"));
    EXPECT_THAT(built("d", {"--storeys", "10", "--plate-area", "300"}),
                HasSubstr("gross floor area 3,000 m2"));
    EXPECT_THAT(built("e", {"--storeys", "10", "--plate-area", "300", "--podium", "2"}),
                AllOf(HasSubstr("gross floor area 4,800 m2"), HasSubstr("coverage 100 %")));
    EXPECT_THAT(
        built("f", {"--storeys", "10", "--plate-area", "300", "--podium", "2", "--podium-share", "50"}),
        AllOf(HasSubstr("gross floor area 3,600 m2"), HasSubstr("coverage 50 %")));
    EXPECT_THAT(
        built("g", {"--storeys", "10", "--plate-area", "300", "--podium", "2", "--podium-area", "900"}),
        AllOf(HasSubstr("gross floor area 4,200 m2"), HasSubstr("coverage 75 %")));
    // Above 20 m inset by 5 m: 30 x 20 m; above 32 m by another 5 m: 20 x 10 m.
    EXPECT_THAT(built("h", {"--storeys", "10", "--setback", "20:5", "--setback", "32:5"}),
                HasSubstr("gross floor area 8,200 m2"));
    EXPECT_THAT(built("i", {"--storeys", "10", "--plate-share", "25", "--turn", "90"}),
                HasSubstr("3,000 m2"));
    EXPECT_NEAR(bounds(building("i")).high.y - bounds(building("i")).low.y, 23.03,
                0.01);  // 23.03 x 13.03 m, turned
    EXPECT_THAT(refused("extrude",
                        {"--scenario", "A", "--lot", "Plot", "--id", "j", "--storeys", "10", "--turn", "45"}),
                HasSubstr("leaves the lot"));
    EXPECT_THAT(refused("extrude", {"--scenario", "A", "--lot", "Plot", "--id", "j", "--storeys", "10",
                                    "--setback", "20:15"}),
                HasSubstr("Give less than 15.0 m"));
    // The lot has 1,200 m2: ten storeys of it within 12,500 m2, and 600 m2 on each of twenty.
    EXPECT_THAT(built("k", {"--floor-area", "12500"}), HasSubstr("gross floor area 12,000 m2"));
    EXPECT_THAT(built("l", {"--floor-area-ratio", "10", "--storeys", "20", "--fit", "plate"}),
                HasSubstr("coverage 50 %"));
}

// What other programs get comes back where it was, from each format.
TEST_F(ProjectEdits, ProposedBuildingsAreWrittenForCad) {
    done("extrude", {"--scenario", "A", "--lot", "One57", "--id", "New", "--height", "80", "--clear"});
    const Box2 box = bounds(building("New"));
    const LonLat origin = opened().city->frame.lonLatFromLocal({0, 0});
    const std::string at = fmt::format("{:.10f},{:.10f}", origin.lonDeg, origin.latDeg);
    int proposed = 0;
    for (const std::string ending : {"obj", "glb", "dxf"}) {
        const std::string out = folder_.path("tower." + ending).string();
        // Each file is imported as one more.
        const std::string count =
            ++proposed == 1 ? "1 building in 1 part" : fmt::format("{0} buildings in {0} parts", proposed);
        EXPECT_THAT(done("export", {"--scenario", "A", "--buildings", "proposed", "--out", out}),
                    AllOf(HasSubstr(count), HasSubstr("Transverse Mercator")));
        done("import", {out, "--scenario", "A", "--id", ending, "--origin-at", at, "--mesh-unit", "m"});
        EXPECT_NEAR(bounds(building(ending)).low.x, box.low.x, 0.01) << ending;
        EXPECT_NEAR(bounds(building(ending)).high.y, box.high.y, 0.01) << ending;
        EXPECT_NEAR(topM(building(ending)), 80, 0.01) << ending;
        EXPECT_THAT(refused("export", {"--scenario", "A", "--out", out}), HasSubstr("--overwrite"));
        done("export", {"--scenario", "A", "--buildings", "proposed", "--out", out, "--overwrite"});
    }
    const std::string file = folder_.path("x").string();
    EXPECT_THAT(refused("export", {"--scenario", "A", "--out", file + ".skp"}), HasSubstr(".glb, .obj"));
    EXPECT_THAT(refused("export", {"--scenario", "A", "--plane", "utm", "--out", file + ".obj"}),
                HasSubstr("Only DXF"));
    EXPECT_THAT(refused("export", {"--buildings", "proposed", "--out", file + ".obj"}),
                HasSubstr("There is no building to write"));
}

TEST_F(ProjectEdits, ACourtyardStaysOpen) {
    const Frame frame = opened().city->frame;
    const auto ring = [&](double low, double high) {
        std::string text;
        for (const glm::dvec2 corner :
             {glm::dvec2{low, low}, {high, low}, {high, high}, {low, high}, {low, low}}) {
            const LonLat place = frame.lonLatFromLocal(corner + glm::dvec2(600, 1200));
            text += fmt::format("{}{:.9f} {:.9f}", text.empty() ? "" : ", ", place.lonDeg, place.latDeg);
        }
        return "(" + text + ")";
    };
    EXPECT_THAT(done("lot add", {"Yard", "POLYGON (" + ring(0, 40) + ", " + ring(10, 30) + ")"}),
                HasSubstr("Yard: 1200 m2"));
    EXPECT_THAT(done("lot list", {}), HasSubstr("with a courtyard"));
    EXPECT_THAT(done("extrude", {"--scenario", "A", "--lot", "Yard", "--id", "y", "--storeys", "5"}),
                HasSubstr("gross floor area 6,000 m2"));
    EXPECT_EQ(building("y").parts[0].footprint.holes.size(), 1U);
}

}  // namespace
}  // namespace noonmark::cli::tests
