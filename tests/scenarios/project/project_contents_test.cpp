#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenarios/project/tables/database.h"
#include "tests/scenarios/project/project_file_fixture.h"

namespace noonmark::tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

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

TEST_F(ProjectFileTest, LeafDaysThatAreNoDaysAreThoseOfTheCity) {
    made();
    Database(file(), Database::Access::write)
        .execute("UPDATE trees SET leaf_on_day = 'May', leaf_off_day = '11-05'");
    const ProjectFile disk = ProjectFile::open(file()).value();
    const Tree& tree = disk.project().city->trees->trees.at(0);
    EXPECT_EQ(tree.leafOnDay, std::nullopt);
    EXPECT_EQ(tree.leafOffDay, 309);
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

}  // namespace
}  // namespace noonmark::tests
