#include "scenarios/edits/read_shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/edits/apply_edits.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

// A box of 4 x 6 x 10 units, y up, its corner at the origin.
constexpr const char* boxObj = R"(o box
v 0 0 0
v 4 0 0
v 4 0 -6
v 0 0 -6
v 0 10 0
v 4 10 0
v 4 10 -6
v 0 10 -6
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)";

Result<ImportMesh> read(const std::filesystem::path& file) {
    Warnings warnings;
    NoProgress progress;
    return readShape(file, "tower", {}, threeHouses().frame, warnings, progress, {});
}

TEST(ReadShape, AMeshComesAtItsOwnOriginAndIsPlacedByTheUser) {
    const TemporaryFolder folder;
    ImportMesh import = read(folder.file("box.obj", boxObj)).value();
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
