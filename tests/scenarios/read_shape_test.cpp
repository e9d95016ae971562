#include "scenarios/edits/read_shape.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/edits/apply_edits.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/scenarios/small_town.h"
#include "tests/shared/box_obj.h"

namespace noonmark::tests {
namespace {

Result<ImportMesh> read(const std::filesystem::path& file) {
    Warnings warnings;
    NoProgress progress;
    return readShape(file, "tower", {}, threeHouses().frame, warnings, progress, {});
}

TEST(ReadShape, AMeshComesAtItsOwnOriginAndIsPlacedByTheUser) {
    const TemporaryFolder folder;
    ImportMesh import = read(folder.file("box.obj", boxObj(4, 6, 10))).value();
    EXPECT_EQ(import.shape->sourceId, "tower");
    EXPECT_EQ(import.file, "box.obj");
    EXPECT_NEAR(topM(*import.shape), 10, 1e-3);
    EXPECT_NEAR(bounds(*import.shape).high.x, 4, 1e-3);
    import.placement = {.scale = 2, .byM = { 100, 50 }};
    const EditedCity city = applyEdits(threeHouses(), std::vector<Edit>{import}).value();
    const Building& built = *city.city.buildings.back();
    EXPECT_NEAR(topM(built), 20, 1e-3);
    EXPECT_NEAR(bounds(built).high.x, 108, 1e-3);
    ASSERT_TRUE(built.parts[0].mesh);
}

// A tower of 40 m that begins at this height of the mesh.
Result<ImportMesh> readTower(int low, Stand stand, Warnings& warnings) {
    const TemporaryFolder folder;
    std::string text = "o tower\n";
    for (const int y : {low, low + 40})
        for (const char* corner : {"v 0 {} 0\n", "v 20 {} 0\n", "v 20 {} -20\n", "v 0 {} -20\n"})
            text += fmt::format(fmt::runtime(corner), y);
    text += "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    NoProgress progress;
    return readShape(folder.file("tower.obj", text), "tower", {.stand = stand}, threeHouses().frame, warnings,
                     progress, {});
}

bool isLowering(const Warning& warning) { return warning.what.find("its own zero") != std::string::npos; }

TEST(ReadShape, AMeshWithElevationsIsSetOnTheGroundAndReported) {
    Warnings warnings;
    const Building tower = *readTower(187, Stand::automatic, warnings)->shape;
    EXPECT_NEAR(topM(tower), 40, 1e-3);
    EXPECT_FALSE(tower.parts[0].isOverhanging);
    EXPECT_EQ(std::ranges::count_if(warnings, isLowering), 1);
    EXPECT_THAT(warnings.back().where, testing::HasSubstr("187.0 m"));
    EXPECT_NEAR(topM(*readTower(187, Stand::absolute, warnings)->shape), 227, 1e-3);
}

TEST(ReadShape, ABasementStaysBelowTheGround) {
    Warnings warnings;
    EXPECT_NEAR(topM(*readTower(-9, Stand::automatic, warnings)->shape), 31, 1e-3);
    EXPECT_EQ(std::ranges::count_if(warnings, isLowering), 0);
    EXPECT_NEAR(topM(*readTower(-9, Stand::terrain, warnings)->shape), 40, 1e-3);
}

TEST(ReadShape, WhatIsNoMeshIsRefused) {
    const TemporaryFolder folder;
    EXPECT_FALSE(read(folder.path("gone.obj")));
    EXPECT_FALSE(read(folder.file("empty.obj", "o nothing\n")));
}

}  // namespace
}  // namespace noonmark::tests
