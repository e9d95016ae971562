#include "core/base/stop_scope.h"

#include <gtest/gtest.h>

#include "core/city/footprints/repair_footprint.h"
#include "core/city/meshes/mesh_outline.h"

namespace noonmark {
namespace {

TEST(StopScope, IsStoppedWithAnyScopeAroundIt) {
    std::stop_source stop;
    EXPECT_FALSE(StopScope::isStopped());
    {
        const StopScope outer(stop.get_token());
        const StopScope inner;
        EXPECT_FALSE(StopScope::isStopped());
        stop.request_stop();
        EXPECT_TRUE(StopScope::isStopped());
    }
    EXPECT_FALSE(StopScope::isStopped());
}

std::vector<Footprint> overlappingSquares() {
    std::vector<Footprint> squares;
    for (int i = 0; i < 100; ++i) {
        const float at = float(i) * 0.7F;
        squares.push_back({{{at, at}, {at + 10, at}, {at + 10, at + 10}, {at, at + 10}}, {}});
    }
    return squares;
}

TEST(StopScope, InterruptsTheOverlayOfPolygons) {
    EXPECT_EQ(computeUnion(overlappingSquares()).size(), 1U);
    std::stop_source stop;
    stop.request_stop();
    const StopScope scope(stop.get_token());
    EXPECT_TRUE(computeUnion(overlappingSquares()).empty());
}

TEST(StopScope, InterruptsTheRepairOfAnOutline) {
    const std::vector<RawRing> bowtie{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}};
    EXPECT_EQ(repairFootprint(bowtie).pieces.size(), 2U);
    std::stop_source stop;
    stop.request_stop();
    const StopScope scope(stop.get_token());
    EXPECT_TRUE(repairFootprint(bowtie).pieces.empty());
}

}  // namespace
}  // namespace noonmark
