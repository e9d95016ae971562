#include "scenarios/project/project_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <tuple>

#include "core/io/read_city.h"
#include "core/io/settings/read_settings.h"
#include "core/study/provenance/study_hash.h"
#include "scenarios/project/edit_json.h"
#include "scenarios/project/tables/database.h"
#include "scenarios/project/tables/schema.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/scenarios/sample_project.h"
#include "tests/shared/shared_data.h"

namespace noonmark::tests {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class ProjectFileTest : public testing::Test {
protected:
    ProjectFile made(const Project& project = sampleProject()) {
        return ProjectFile::create(file(), project).value();
    }
    [[nodiscard]] fs::path file() const { return folder_.path("town.noonmark.gpkg"); }
    [[nodiscard]] Project opened() const { return ProjectFile::open(file()).value().project(); }
    [[nodiscard]] std::string errorOfOpening() const {
        const auto opened = ProjectFile::open(file());
        return opened ? "" : opened.error().text();
    }

    TemporaryFolder folder_;
};

MeasuredElement elementOf(const char* id, ElementKind kind, float z) {
    MeasuredElement element{.id = id, .kind = kind, .building = "a", .buildingName = "Haus \"Ä\""};
    element.position = {1.25F, -3.1F, z};
    element.normal = {0.6F, 0.8F, 0};
    element.pane = {{-1.5, -1.5}, {1.5, 1.2}};
    element.sunlitMin = 100.0 / 3;
    element.grossMin = 1000.0 / 7;
    element.continuousMin = 60;
    element.longestSunMin = 59.5;
    element.azimuthDeg = 36.9;
    element.floor = 2;
    element.monthMin.fill(std::nan(""));
    element.monthMin[5] = 1000.1;
    return element;
}

// The sample with a result at points, since version 7; the third is of a plane.
Project sampleWithPoints() {
    Project project = sampleProject();
    SavedResult result{"points", "elements", "A", {}, R"({"kept": 1})", "[]", {0, 0, 1, 1, 1}, {}};
    for (const char* id : {"wall 1", "wall 2"})
        result.elements.push_back(elementOf(id, ElementKind::facade, 4.5F));
    MeasuredElement level = elementOf("3,4", ElementKind::plane, 1.5F);
    level.building = level.buildingName = "";
    level.floor.reset();
    level.azimuthDeg = std::nan("");
    result.elements.push_back(level);
    project.results.push_back(std::make_shared<const SavedResult>(result));
    return project;
}

// A number that is none equals another.
void expectSame(const MeasuredElement& a, const MeasuredElement& b) {
    EXPECT_EQ(std::tie(a.id, a.kind, a.building, a.buildingName, a.floor, a.position, a.normal, a.pane),
              std::tie(b.id, b.kind, b.building, b.buildingName, b.floor, b.position, b.normal, b.pane));
    EXPECT_EQ(std::tie(a.sunlitMin, a.grossMin, a.continuousMin, a.longestSunMin),
              std::tie(b.sunlitMin, b.grossMin, b.continuousMin, b.longestSunMin));
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    EXPECT_TRUE(same(a.azimuthDeg, b.azimuthDeg));
    EXPECT_TRUE(std::ranges::equal(a.monthMin, b.monthMin, same));
}

// Version 9 stored no trees.
Project asVersion9Holds(Project project) {
    City city = *project.city;
    city.trees = nullptr;
    project.city = std::make_shared<const City>(std::move(city));
    return project;
}

// Version 7 stored no section boxes of views.
Project asVersion7Holds(Project project) {
    for (SavedView& view : project.views) view.section.reset();
    return asVersion9Holds(std::move(project));
}

// Version 5 stored no views.
Project asVersion5Holds(Project project) {
    project.views.clear();
    return asVersion9Holds(std::move(project));
}

// Version 4 stored no roads along lots.
Project asVersion4Holds(Project project) {
    for (NamedLot& lot : project.lots) lot.roads.clear();
    return asVersion5Holds(std::move(project));
}

// Version 3 stored no map context.
Project asVersion3Holds(Project project) {
    City city = *project.city;
    city.context = nullptr;
    project.city = std::make_shared<const City>(std::move(city));
    return asVersion4Holds(std::move(project));
}

// Version 2 stored no places and no title block.
Project asVersion2Holds(Project project) {
    project.places.clear();
    project.sheets = {};
    return asVersion3Holds(std::move(project));
}

// The part of a project that version 1 stored: no warnings of reading and no terrain source.
Project asVersion1Holds(Project project) {
    CityReading reading{std::nullopt, {{WarningKind::leftOut, noReadingText, "project file"}}};
    project.reading = std::make_shared<const CityReading>(reading);
    return asVersion2Holds(std::move(project));
}

void expectSame(const Project& a, const Project& b) {
    EXPECT_TRUE(sameCity(*a.city, *b.city));
    EXPECT_EQ(a.attribution, b.attribution);
    ASSERT_EQ(a.inputs.size(), b.inputs.size());
    ASSERT_EQ(bool(a.reading->settings), bool(b.reading->settings));
    if (a.reading->settings) {
        EXPECT_EQ(formatText(*a.reading->settings), formatText(*b.reading->settings));
    }
    EXPECT_EQ(a.reading->heights, b.reading->heights);
    ASSERT_EQ(a.reading->warnings.size(), b.reading->warnings.size());
    for (std::size_t i = 0; i < a.reading->warnings.size(); ++i) {
        EXPECT_EQ(a.reading->warnings[i].kind, b.reading->warnings[i].kind) << i;
        EXPECT_EQ(a.reading->warnings[i].what, b.reading->warnings[i].what) << i;
        EXPECT_EQ(a.reading->warnings[i].where, b.reading->warnings[i].where) << i;
    }
    EXPECT_EQ(a.lots, b.lots);
    EXPECT_EQ(a.regions, b.regions);
    EXPECT_EQ(a.places, b.places);
    EXPECT_EQ(a.sheets, b.sheets);
    EXPECT_EQ(a.weights, b.weights);
    EXPECT_EQ(a.periods, b.periods);
    EXPECT_EQ(a.views, b.views);
    EXPECT_EQ(a.view, b.view);
    ASSERT_EQ(a.scenarios.size(), b.scenarios.size());
    for (std::size_t i = 0; i < a.scenarios.size(); ++i) {
        EXPECT_EQ(a.scenarios[i].name, b.scenarios[i].name);
        EXPECT_EQ(a.scenarios[i].base, b.scenarios[i].base);
        ASSERT_EQ(a.scenarios[i].edits.size(), b.scenarios[i].edits.size());
        for (std::size_t e = 0; e < a.scenarios[i].edits.size(); ++e)
            EXPECT_EQ(toJson(a.scenarios[i].edits[e]), toJson(b.scenarios[i].edits[e]));
    }
    ASSERT_EQ(a.results.size(), b.results.size());
    for (std::size_t i = 0; i < a.results.size(); ++i) {
        EXPECT_EQ(a.results[i]->settings, b.results[i]->settings);
        EXPECT_EQ(a.results[i]->grid, b.results[i]->grid);
        ASSERT_EQ(a.results[i]->elements.size(), b.results[i]->elements.size());
        for (std::size_t e = 0; e < a.results[i]->elements.size(); ++e)
            expectSame(a.results[i]->elements[e], b.results[i]->elements[e]);
        ASSERT_EQ(a.results[i]->layers.size(), b.results[i]->layers.size());
        for (std::size_t l = 0; l < a.results[i]->layers.size(); ++l)
            for (std::size_t c = 0; c < a.results[i]->grid.size(); ++c) {
                const float x = a.results[i]->layers[l].values[c], y = b.results[i]->layers[l].values[c];
                ASSERT_TRUE(x == y || (std::isnan(x) && std::isnan(y))) << c << ": " << x << " " << y;
            }
    }
}

TEST_F(ProjectFileTest, GivesBackAllToTheLastBit) {
    const Project project = sampleProject();
    made(project);
    expectSame(opened(), project);
    EXPECT_THAT(folder_.names(), ElementsAre("town.noonmark.gpkg"));
}

// Covers the existing city and a building added by a scenario.
TEST_F(ProjectFileTest, EverySourceOfAHeightIsGivenBack) {
    Project project = sampleProject();
    City city = *project.city;
    Building tower = house("of every source", box(300, 0, 310, 10), 5);
    for (const HeightSource source : heightSources) {
        tower.parts.back().heightSource = source;
        tower.parts.push_back(house("next", box(300, 0, 310, 10), tower.parts.back().topM + 5).parts[0]);
    }
    tower.parts.pop_back();
    city.buildings.push_back(shared(tower));
    project.city = std::make_shared<const City>(city);
    tower.sourceId = "built so";
    project.scenarios[0].edits.emplace_back(AddBuilding{shared(tower)});
    made(project);
    const Project again = opened();
    const auto& built = std::get<AddBuilding>(again.scenarios[0].edits.back()).building;
    for (const auto& building : {again.city->buildings.back(), built}) {
        ASSERT_EQ(building->parts.size(), heightSources.size());
        for (std::size_t i = 0; i < heightSources.size(); ++i)
            EXPECT_EQ(building->parts[i].heightSource, heightSources[i]) << i;
    }
}

TEST_F(ProjectFileTest, ATerrainOnAMapsOwnRowsAndColumnsComesBackToTheLastBit) {
    Project project = sampleProject();
    City city = *project.city;
    Terrain terrain{*slope()};
    terrain.grid.first = {-11.1, 1.0 / 3};
    terrain.grid.columnStep = {9.97, 0.1 / 3};
    terrain.grid.rowStep = {-0.0337, 9.98};
    terrain.grid.bend = {
        glm::dvec2{0.1, 0.2}, {0.3, 0.7}, {-0.1, 1e-7}, {0.01, 0}, {1e-9, 0}, {0, 0.01}, {0.3, 0.2}};
    terrain.source = {.method = TerrainMethod::kept,
                      .file = "dem.tif",
                      .sourceColumns = 30,
                      .sourceRows = 12,
                      .sourceCellM = 9.98,
                      .misplacedM = 0.1 / 3,
                      .filled = 4};
    city.terrain = std::make_shared<const Terrain>(std::move(terrain));
    city.trees = nullptr;  // they stand on the other terrain
    project.city = std::make_shared<const City>(std::move(city));
    made(project);
    const Project back = opened();
    ASSERT_TRUE(back.city->terrain);
    EXPECT_EQ(*back.city->terrain, *project.city->terrain);
    EXPECT_EQ(hashCity(*back.city), hashCity(*project.city));
}

// The file contains sampleProject() as it was when version 1 was current.
TEST_F(ProjectFileTest, AFileOfVersion1IsOpenedAndSaved) {
    fs::copy_file(testFile("scenarios/files/version-1.noonmark.gpkg"), file());
    const std::string before = readBytes(file());
    ProjectFile disk = ProjectFile::open(file()).value();
    expectSame(disk.project(), asVersion1Holds(sampleProject()));
    EXPECT_EQ(readBytes(file()), before);  // opening does not migrate the file on disk
    Project project = disk.project();
    project.view["camera"] = "new";
    ASSERT_TRUE(disk.save(project));
    expectSame(opened(), project);
    Database database(file(), Database::Access::read);
    EXPECT_EQ(versionOf(database), schemaVersion);
}

TEST_F(ProjectFileTest, AFileOfVersion1ThatMayOnlyBeReadIsOpened) {
    fs::copy_file(testFile("scenarios/files/version-1.noonmark.gpkg"), file());
    fs::permissions(file(), fs::perms::owner_read);
    expectSame(opened(), asVersion1Holds(sampleProject()));
}

// The file contains everything that version 2 can store.
TEST_F(ProjectFileTest, AFileOfVersion2IsOpenedAndSaved) {
    fs::copy_file(testFile("scenarios/files/version-2.noonmark.gpkg"), file());
    ProjectFile disk = ProjectFile::open(file()).value();
    expectSame(disk.project(), asVersion2Holds(sampleProject()));
    Project project = disk.project();
    project.view["camera"] = "new";
    project.places = sampleProject().places;
    project.sheets = sampleProject().sheets;
    ASSERT_TRUE(disk.save(project));
    expectSame(opened(), project);
}

TEST_F(ProjectFileTest, AFileOfVersion3IsOpened) {
    fs::copy_file(testFile("scenarios/files/version-3.noonmark.gpkg"), file());
    expectSame(opened(), asVersion3Holds(sampleProject()));
}

TEST_F(ProjectFileTest, AFileOfVersion4IsOpened) {
    fs::copy_file(testFile("scenarios/files/version-4.noonmark.gpkg"), file());
    expectSame(opened(), asVersion4Holds(sampleProject()));
}

TEST_F(ProjectFileTest, AFileOfVersion5IsOpened) {
    fs::copy_file(testFile("scenarios/files/version-5.noonmark.gpkg"), file());
    ProjectFile disk = ProjectFile::open(file()).value();
    expectSame(disk.project(), asVersion5Holds(sampleProject()));
    ASSERT_TRUE(disk.save(sampleProject()));
    expectSame(opened(), sampleProject());
}

// Version 6 stored no results at points.
TEST_F(ProjectFileTest, AFileOfVersion6IsOpened) {
    fs::copy_file(testFile("scenarios/files/version-6.noonmark.gpkg"), file());
    ProjectFile disk = ProjectFile::open(file()).value();
    expectSame(disk.project(), asVersion7Holds(sampleProject()));
    ASSERT_TRUE(disk.save(sampleWithPoints()));
    expectSame(opened(), sampleWithPoints());
}

TEST_F(ProjectFileTest, AFileOfVersion6WithATableOfThatNameIsRefused) {
    fs::copy_file(testFile("scenarios/files/version-6.noonmark.gpkg"), file());
    Database(file(), Database::Access::write).execute("CREATE TABLE result_elements (fid INTEGER)");
    EXPECT_THAT(errorOfOpening(), HasSubstr("'result_elements'"));
}

TEST_F(ProjectFileTest, AFileOfVersion7IsOpened) {
    fs::copy_file(testFile("scenarios/files/version-7.noonmark.gpkg"), file());
    ProjectFile disk = ProjectFile::open(file()).value();
    expectSame(disk.project(), asVersion7Holds(sampleWithPoints()));
    ASSERT_TRUE(disk.save(sampleWithPoints()));
    expectSame(opened(), sampleWithPoints());
}

TEST_F(ProjectFileTest, AFileOfVersion7WithAColumnOfThatNameIsRefused) {
    fs::copy_file(testFile("scenarios/files/version-7.noonmark.gpkg"), file());
    Database(file(), Database::Access::write).execute("ALTER TABLE saved_views ADD COLUMN Section TEXT");
    EXPECT_THAT(errorOfOpening(), HasSubstr("column 'section'"));
}

TEST_F(ProjectFileTest, AFileOfVersion8IsOpened) {
    fs::copy_file(testFile("scenarios/files/version-8.noonmark.gpkg"), file());
    expectSame(opened(), asVersion9Holds(sampleWithPoints()));
}

TEST_F(ProjectFileTest, AFileOfVersion8WithAColumnOfThatNameIsRefused) {
    fs::copy_file(testFile("scenarios/files/version-8.noonmark.gpkg"), file());
    Database(file(), Database::Access::write).execute("ALTER TABLE periods ADD COLUMN Settings TEXT");
    EXPECT_THAT(errorOfOpening(), HasSubstr("column 'settings'"));
}

TEST_F(ProjectFileTest, APeriodOfVersion8ThatMakesNoSenseIsDamage) {
    for (const char* harm : {"days = 0", "from_min = -1", "step_min = 1e-300", "start = 'May'",
                             "after_sunrise_min = 1e9, before_sunset_min = 0"}) {
        fs::remove(file());
        fs::copy_file(testFile("scenarios/files/version-8.noonmark.gpkg"), file());
        Database(file(), Database::Access::write).execute(std::string("UPDATE periods SET ") + harm);
        EXPECT_THAT(errorOfOpening(), HasSubstr("periods")) << harm;
    }
}

TEST_F(ProjectFileTest, AFileOfVersion9IsOpened) {
    fs::copy_file(testFile("scenarios/files/version-9.noonmark.gpkg"), file());
    expectSame(opened(), asVersion9Holds(sampleWithPoints()));
}

TEST_F(ProjectFileTest, AFileOfVersion9WithATableOfThatNameIsRefused) {
    fs::copy_file(testFile("scenarios/files/version-9.noonmark.gpkg"), file());
    Database(file(), Database::Access::write).execute("CREATE TABLE Trees (fid INTEGER)");
    EXPECT_THAT(errorOfOpening(), HasSubstr("'trees'"));
}

TEST_F(ProjectFileTest, AFileOfVersion10IsOpened) {
    fs::copy_file(testFile("scenarios/files/version-10.noonmark.gpkg"), file());
    expectSame(opened(), sampleWithPoints());
}

// As if a GIS program had drawn the first tree: its place and its height alone.
TEST_F(ProjectFileTest, ATreeThatAGisProgramLeftIncompleteIsCompleted) {
    made();
    Database(file(), Database::Access::write)
        .execute(
            "UPDATE trees SET tree_id = NULL, species = NULL, crown_diameter_m = NULL, crown_base_m = "
            "NULL, shape = NULL, evergreen = NULL, height_source = NULL, crown_source = NULL, leaf_on = "
            "NULL, leaf_off = NULL WHERE fid = 1");
    const City city = *opened().city;
    Tree drawn = completeTree({.sourceId = "tree 1", .heightM = double(11.3F)});
    drawn.place = sampleProject().city->trees->trees[0].place;
    drawn.groundM = groundAt(city, drawn.place);
    ASSERT_TRUE(city.trees);
    EXPECT_EQ(city.trees->trees.at(0), drawn);
    EXPECT_EQ(city.trees->trees.at(1), sampleProject().city->trees->trees[1]);
}

// Of the first tree the shape is a word that is none, and its crown begins 40 m up, above its top.
TEST_F(ProjectFileTest, TreesOfUnknownWordsAreCompletedAndCounted) {
    made();
    Database(file(), Database::Access::write)
        .execute("UPDATE trees SET shape = 'blob', crown_base_m = 40 WHERE fid = 1");
    const Project project = opened();
    const Tree& tree = project.city->trees->trees.at(0);
    const Tree drawn = completeTree({.species = tree.species});
    EXPECT_EQ(tree.shape, drawn.shape);
    EXPECT_LT(tree.crownBaseM, tree.heightM);
    EXPECT_EQ(tree.heightM, sampleProject().city->trees->trees[0].heightM) << "what is stated well stays";
    const auto counted = [&](std::string_view what) {
        return std::ranges::count_if(project.reading->warnings, [&](const Warning& one) {
            return one.what.starts_with(what) && one.where == "layer trees (1)";
        });
    };
    EXPECT_EQ(counted("unknown words for the shape"), 1);
    EXPECT_EQ(counted("the crown's base lies above"), 1);
}

TEST_F(ProjectFileTest, TreesThatMakeNoSenseAreDamage) {
    for (const char* harm : {"UPDATE trees SET height_m = -3", "UPDATE trees SET leaf_on = 1.5",
                             "UPDATE trees SET geom = x'01'", "UPDATE trees SET crown_diameter_m = 'wide'",
                             "UPDATE noonmark SET value = '0-400' WHERE key = 'leaf_days'"}) {
        fs::remove(file());
        made();
        Database(file(), Database::Access::write).execute(harm);
        EXPECT_THAT(errorOfOpening(), HasSubstr("damaged")) << harm;
    }
}

// Each field of a period, other than its default.
TEST_F(ProjectFileTest, EveryFieldOfAPeriodIsSaved) {
    Period byClock{.days = 5,
                   .from = std::chrono::minutes(7 * 60 + 23),
                   .hours = 7.1,
                   .stepMinutes = 0.1,
                   .zone = "Asia/Tokyo",
                   .refraction = false};
    byClock.start = CivilDate{std::chrono::year{2028}, std::chrono::February, std::chrono::day{29}};
    Period bySun = byClock;
    bySun.window = SolarHours{std::chrono::minutes(-7), std::chrono::minutes(95), SunriseRule::centre};
    Project project = sampleWithPoints();
    project.periods = {{"by clock", byClock}, {"by sun", bySun}};
    made(project);
    EXPECT_EQ(opened().periods, project.periods);
}

TEST_F(ProjectFileTest, PointsThatMakeNoSenseAreDamage) {
    for (const char* harm : {"kind = 'door'", "x_m = 9e999", "z_m = 'high'", "normal_x = 2", "floor = 1e9",
                             "sunlit_min = -1", "azimuth_deg = 361", "sunlit_min_06 = 'much'"}) {
        fs::remove(file());
        made(sampleWithPoints());
        Database(file(), Database::Access::write)
            .execute(std::string("UPDATE result_elements SET ") + harm + " WHERE fid = 2");
        EXPECT_THAT(errorOfOpening(), HasSubstr("result_elements")) << harm;
    }
}

TEST_F(ProjectFileTest, TheRemovalOfAResultRemovesItsPoints) {
    ProjectFile disk = made(sampleWithPoints());
    ASSERT_TRUE(disk.save(sampleProject()));
    EXPECT_EQ(Database(file(), Database::Access::read).value("SELECT count(*) FROM result_elements"), "0");
}

TEST_F(ProjectFileTest, ViewsThatMakeNoSenseAreDamage) {
    for (const char* harm : {"distance_m = 0", "distance_m = 9e999", "pitch_deg = 91",
                             "heading_deg = 'north'", "target_x_m = -1e9", "projection = 'fisheye'",
                             "date = '2026-02-30'", "at_min = 1441", "section = 'all'", "section = '[1,2,3]'",
                             "section = '[0,0,0,1,-1,1]'", "section = '[0,0,0,1e9,1,1]'"}) {
        fs::remove(file());
        made();
        Database(file(), Database::Access::write)
            .execute(std::string("UPDATE saved_views SET ") + harm + " WHERE id = 2");
        EXPECT_THAT(errorOfOpening(), HasSubstr("saved_views")) << harm;
    }
}

TEST_F(ProjectFileTest, AViewOutOfRangeIsRefusedBeforeItIsSaved) {
    Project project = sampleProject();
    for (const auto& harm : std::initializer_list<void (*)(SavedView&)>{
             [](SavedView& view) { view.distanceM = 0; }, [](SavedView& view) { view.pitchDeg = -1; },
             [](SavedView& view) { view.headingDeg = std::nan(""); },
             [](SavedView& view) {
                 view.moment = ViewMoment{{}, std::chrono::minutes(5)};
             },
             [](SavedView& view) {
                 view.section = ViewBox{{0, 0, 0}, {1, 1, 0}};
             },
             [](SavedView& view) { view.name = "Depuis l'Été"; }}) {
        project.views = sampleProject().views;
        harm(project.views[0]);
        EXPECT_FALSE(validate(project));
    }
}

TEST_F(ProjectFileTest, RoadsThatMakeNoSenseAreDamage) {
    made();
    Database(file(), Database::Access::write).execute("UPDATE lots SET roads = 'up=8'");
    EXPECT_THAT(errorOfOpening(), HasSubstr("names no side of a parcel"));
    Database(file(), Database::Access::write).execute("UPDATE lots SET roads = NULL");
    EXPECT_TRUE(opened().lots.front().roads.empty());
}

TEST_F(ProjectFileTest, ContextThatIsNoShapeIsDamage) {
    made();
    Database(file(), Database::Access::write)
        .execute("UPDATE context SET geom = x'0102' WHERE kind = 'street'");
    EXPECT_THAT(errorOfOpening(), HasSubstr("context"));
}

TEST_F(ProjectFileTest, ContextOfAKindFromALaterVersionIsIgnored) {
    made();
    Database(file(), Database::Access::write)
        .execute("UPDATE context SET kind = 'airport' WHERE kind = 'tree'");
    const Project project = opened();
    EXPECT_TRUE(project.city->context->trees.empty());
    EXPECT_EQ(project.city->context->lines.size(), 2U);
}

TEST_F(ProjectFileTest, TablesOfNewNamesThatAreNotOursAreNotOverwritten) {
    for (const std::string name : {"Places", "sheet_settings", "saved_views"}) {
        fs::remove(file());
        fs::copy_file(testFile("scenarios/files/version-2.noonmark.gpkg"), file());
        Database(file(), Database::Access::write).execute("CREATE TABLE " + name + " (x INTEGER)");
        EXPECT_THAT(errorOfOpening(), HasSubstr(name == "Places" ? "places" : name));
    }
}

TEST_F(ProjectFileTest, AColumnOfANewNameThatIsNotOursIsNotTaken) {
    fs::copy_file(testFile("scenarios/files/version-4.noonmark.gpkg"), file());
    Database(file(), Database::Access::write).execute("ALTER TABLE lots ADD COLUMN Roads TEXT");
    EXPECT_THAT(errorOfOpening(), HasSubstr("column 'roads'"));
}

TEST_F(ProjectFileTest, PlacesThatAGisProgramLeftIncompleteAreCompleted) {
    made();
    Database(file(), Database::Access::write)
        .execute(
            "UPDATE places SET kind = 'lawn', source = NULL, name = 'same'; UPDATE places SET name = NULL "
            "WHERE fid = 2");
    const std::vector<Place> places = opened().places;
    ASSERT_EQ(places.size(), 2U);
    EXPECT_EQ(places[0].kind, PlaceKind::other);
    EXPECT_EQ(places[0].source, "place 1");
    EXPECT_EQ(places[1].name, "other (place 2)");
    Database(file(), Database::Access::write).execute("UPDATE places SET geom = x'0102'");
    EXPECT_THAT(errorOfOpening(), HasSubstr("place has an invalid outline"));
}

// Not a test: writes the file of the current version for tests/scenarios/files into the working folder
// (--gtest_also_run_disabled_tests).
TEST(ProjectFileFixture, DISABLED_IsWritten) {
    const std::string name = "version-" + std::to_string(schemaVersion) + projectEnding;
    ASSERT_TRUE(ProjectFile::create(name, sampleWithPoints()));
}

TEST_F(ProjectFileTest, WarningsThatShareATextHoldItOnce) {
    made();
    Database database(file(), Database::Access::read);
    EXPECT_EQ(database.value("SELECT count(*) FROM warnings"), "4");
    EXPECT_EQ(database.value("SELECT count(*) FROM warning_texts"), "3");
    EXPECT_EQ(database.value("SELECT count(*) FROM warning_texts WHERE kind = 'mended'"), "1")
        << "the word of earlier versions, which still read the file";
}

TEST_F(ProjectFileTest, ReadingThatMakesNoSenseIsDamage) {
    for (const char* harm :
         {"UPDATE warnings SET text = 99", "UPDATE warning_texts SET kind = 'whim'",
          "UPDATE noonmark SET value = '{\"mesh_unit\": 9}' WHERE key = 'read_settings'"}) {
        fs::remove(file());
        made();
        Database(file(), Database::Access::write).execute(harm);
        EXPECT_THAT(errorOfOpening(), HasSubstr("damaged")) << harm;
    }
}

TEST_F(ProjectFileTest, TheScenariosStillMakeTheSameCities) {
    const Project project = sampleProject();
    made(project);
    const auto before = cityOf(project, "B"), after = cityOf(opened(), "B");
    ASSERT_TRUE(before) << before.error().text();
    ASSERT_TRUE(after) << after.error().text();
    EXPECT_TRUE(sameCity(before->city, after->city));
}

TEST_F(ProjectFileTest, EveryKindOfChangeIsSaved) {
    ProjectFile disk = made();
    Project project = disk.project();
    City city = *project.city;
    city.buildings[1] = shared(house("b", box(30, 0, 41, 11), 25));
    city.buildings.pop_back();
    project.city = std::make_shared<const City>(city);
    project.attribution = "other";
    project.reading = std::make_shared<const CityReading>(
        CityReading{std::nullopt, {{WarningKind::clipped, "overlap", "way 9"}}});
    project.lots.pop_back();
    project.regions.push_back({"Street", {box(0, -20, 100, -10)}});
    project.scenarios[0].edits.pop_back();
    project.scenarios[1].edits[1] = ChangeHeight{"c", 12};
    project.scenarios.push_back({"C", "", {Demolish{"c"}}});
    project.weights.erase(project.weights.begin());
    project.periods.clear();
    project.results = {makeSavedResult("second", 20, 600)};
    project.view["camera"] = "4 5 6";
    ASSERT_TRUE(disk.save(project));
    EXPECT_EQ(disk.saves(), 2);
    expectSame(opened(), project);
    project.scenarios.erase(project.scenarios.begin() + 1);
    ASSERT_TRUE(disk.save(project));
    expectSame(opened(), project);
}

TEST_F(ProjectFileTest, ASaveWritesNoMoreThanTheChange) {
    ProjectFile disk = made();
    Project project = disk.project();
    project.scenarios[1].edits.emplace_back(Rotate{"c", 1});
    const auto before = [&] {
        Database database(file(), Database::Access::read);
        return *database.value("SELECT group_concat(fid || ' ' || building) FROM buildings");
    };
    const std::string rows = before();
    const std::string city = readBytes(file());
    ASSERT_TRUE(disk.save(project));
    EXPECT_EQ(before(), rows);
    Database database(file(), Database::Access::read);
    EXPECT_EQ(*database.value("SELECT count(*) FROM edits"), "8");
    EXPECT_EQ(readBytes(file()).size(), city.size());
}

TEST_F(ProjectFileTest, IsAGeoPackageThatReadsAsACity) {
    made();
    NoProgress progress;
    const auto read = readCity({file()}, {.frame = threeHouses().frame}, progress, {});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->city.buildings.size(), 5U);
    EXPECT_EQ(read->city.buildings[4]->name, "Cour d'Été");
    EXPECT_NEAR(read->city.buildings[4]->parts[1].topM - read->city.buildings[4]->parts[0].bottomM, 60, 1e-3);
}

TEST_F(ProjectFileTest, DamagedFilesGetAWordAndStayAsTheyAre) {
    made();
    const std::string whole = readBytes(file());
    for (const double share : {0.0, 0.0001, 0.01, 0.3, 0.7, 0.999}) {
        const std::string cut = whole.substr(0, std::size_t(share * double(whole.size())));
        std::ofstream(file(), std::ios::binary | std::ios::trunc) << cut;
        EXPECT_THAT(errorOfOpening(),
                    testing::AnyOf(HasSubstr("damaged"), HasSubstr("not a Noonmark project")))
            << share;
        EXPECT_EQ(readBytes(file()), cut);
    }
}

TEST_F(ProjectFileTest, FlippedBytesNeverCrash) {
    made();
    const std::string whole = readBytes(file());
    for (std::size_t at = 50; at < whole.size(); at += whole.size() / 211) {
        std::string flipped = whole;
        flipped[at] = char(~flipped[at]);
        std::ofstream(file(), std::ios::binary | std::ios::trunc) << flipped;
        const auto opened = ProjectFile::open(file());
        EXPECT_TRUE(opened || !opened.error().advice.empty());
        EXPECT_EQ(readBytes(file()), flipped);
    }
}

TEST_F(ProjectFileTest, ADamagedFileIsNotSavedOver) {
    ProjectFile disk = made();
    std::ofstream(file(), std::ios::binary | std::ios::trunc) << "not a database at all, but some text";
    const std::string before = readBytes(file());
    EXPECT_FALSE(disk.save(sampleProject()));
    EXPECT_EQ(readBytes(file()), before);
}

TEST_F(ProjectFileTest, NewerAndForeignFilesAreSaid) {
    made();
    {
        Database database(file(), Database::Access::write);
        database.execute("UPDATE noonmark SET value = '99' WHERE key = 'schema_version'");
    }
    const std::string before = readBytes(file());
    EXPECT_THAT(errorOfOpening(), AllOf(HasSubstr("newer Noonmark"), HasSubstr("99")));
    EXPECT_EQ(readBytes(file()), before);
    fs::remove(file());
    Database(file(), Database::Access::create).execute("CREATE TABLE t (x)");
    EXPECT_THAT(errorOfOpening(), HasSubstr("not a Noonmark project"));
    EXPECT_THAT(ProjectFile::open(folder_.path("gone")).error().text(), HasSubstr("no such file"));
}

TEST_F(ProjectFileTest, ALockedFileIsSaidAndSavedLater) {
    ProjectFile disk = made();
    Project project = disk.project();
    project.view["camera"] = "9";
    {
        Database other(file(), Database::Access::write);
        const Transaction busy(other);
        EXPECT_THAT(disk.save(project).error().text(), HasSubstr("Another program is writing"));
        EXPECT_TRUE(ProjectFile::open(file()));
    }
    EXPECT_TRUE(disk.save(project));
    EXPECT_EQ(opened().view.at("camera"), "9");
}

TEST_F(ProjectFileTest, WhatSomeoneElseSavedIsNotOverwritten) {
    ProjectFile mine = made();
    ProjectFile theirs = ProjectFile::open(file()).value();
    Project project = theirs.project();
    project.view["camera"] = "theirs";
    ASSERT_TRUE(theirs.save(project));
    EXPECT_THAT(mine.save(sampleProject()).error().text(), HasSubstr("saved by someone else"));
    EXPECT_EQ(opened().view.at("camera"), "theirs");
}

TEST_F(ProjectFileTest, AReadOnlyFileIsReadAndNotSaved) {
    ProjectFile disk = made();
    fs::permissions(file(), fs::perms::owner_read);
    EXPECT_TRUE(ProjectFile::open(file()));
    EXPECT_THAT(disk.save(sampleProject()).error().text(), HasSubstr("is read-only"));
    fs::permissions(file(), fs::perms::owner_all);
}

TEST_F(ProjectFileTest, AFileThatIsThereIsReplacedOnlyWhenAsked) {
    made();
    EXPECT_THAT(ProjectFile::create(file(), {}).error().text(), HasSubstr("already"));
    EXPECT_TRUE(ProjectFile::create(file(), {}, ProjectFile::IfThere::replace));
    EXPECT_TRUE(opened().city->buildings.empty());
}

TEST_F(ProjectFileTest, WhatIsNotSoundIsNotSaved) {
    ProjectFile disk = made();
    Project project = disk.project();
    project.scenarios.push_back(project.scenarios[0]);
    EXPECT_FALSE(disk.save(project));
    EXPECT_FALSE(ProjectFile::create(folder_.path("x.noonmark.gpkg"), project));
    EXPECT_EQ(opened().scenarios.size(), 2U);
}

TEST_F(ProjectFileTest, UnsavedWorkIsRecovered) {
    ProjectFile disk = made();
    EXPECT_FALSE(recoveryOf(file()));
    Project project = disk.project();
    Autosave autosave(file());
    for (int i = 0; i < 3; ++i) {
        project.view["camera"] = std::to_string(i);
        ASSERT_TRUE(autosave.keep(project));
    }
    const auto recovery = recoveryOf(file());
    ASSERT_TRUE(recovery);
    EXPECT_EQ(ProjectFile::open(recovery->path).value().project().view.at("camera"), "2");
    EXPECT_EQ(opened().view.at("camera"), "1 2 3");
    autosave.discard();
    EXPECT_FALSE(recoveryOf(file()));
    EXPECT_THAT(folder_.names(), ElementsAre("town.noonmark.gpkg"));
}

}  // namespace
}  // namespace noonmark::tests
