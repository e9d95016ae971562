#include "scenarios/project/project_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/io/read_city.h"
#include "core/study/provenance/study_hash.h"
#include "scenarios/project/tables/database.h"
#include "tests/scenarios/project/project_file_fixture.h"

namespace noonmark::tests {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

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

TEST_F(ProjectFileTest, DamagedFilesGetAnErrorAndStayAsTheyAre) {
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

TEST_F(ProjectFileTest, NewerAndForeignFilesAreReported) {
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

TEST_F(ProjectFileTest, ALockedFileIsReportedAndSavedLater) {
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
    EXPECT_TRUE(ProjectFile::create(file(), {}, ProjectFile::IfExists::replace));
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
