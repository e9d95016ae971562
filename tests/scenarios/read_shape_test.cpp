#include "scenarios/edits/read_shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
    const EditedCity city = applied(threeHouses(), std::vector<Edit>{import}).value();
    const Building& built = *city.city.buildings.back();
    EXPECT_NEAR(topM(built), 20, 1e-3);
    EXPECT_NEAR(bounds(built).high.x, 108, 1e-3);
    ASSERT_TRUE(built.parts[0].mesh);
}

TEST(ReadShape, WhatIsNoMeshIsRefused) {
    const TemporaryFolder folder;
    EXPECT_FALSE(read(folder.path("gone.obj")));
    EXPECT_FALSE(read(folder.file("empty.obj", "o nothing\n")));
}

}  // namespace
}  // namespace noonmark::tests
