#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "core/city/map_context.h"
#include "core/receivers/receivers.h"
#include "core/study/text/region_text.h"

namespace noonmark {

namespace {

Footprint plotBetween(float west, float south, float east, float north) {
    return {{{west, south}, {east, south}, {east, north}, {west, north}}, {}};
}

std::shared_ptr<const Building> building(const Footprint& footprint, bool isOverhanging = false) {
    Building made;
    made.parts.push_back({.footprint = footprint, .topM = 20, .isOverhanging = isOverhanging});
    return std::make_shared<const Building>(made);
}

Receivers receiversOf(const City& city, const Region& region, double cellM = 1) {
    auto receivers = placeReceiversOnGround(city, region, {.cellM = cellM});
    EXPECT_TRUE(receivers.has_value());
    return receivers.value_or(Receivers{});
}

std::ptrdiff_t countOf(const Receivers& receivers, CellKind kind) {
    return std::count(receivers.kind.begin(), receivers.kind.end(), kind);
}

TEST(Receivers, CellsOutsideTheRegionAndUnderBuildingsAreNone) {
    City city;
    city.buildings = {building(plotBetween(2, 2, 5, 4)), building(plotBetween(-5, 0, -1, 9))};
    const Region triangle{"lawn", {Footprint{{{0, 0}, {10, 0}, {0, 10}}, {}}}};
    const Receivers receivers = receiversOf(city, triangle);
    EXPECT_EQ(receivers.grid, (Grid{0, 0, 1, 10, 10}));
    EXPECT_EQ(countOf(receivers, CellKind::building), 6);
    EXPECT_EQ(countOf(receivers, CellKind::ground), std::ptrdiff_t(receivers.cells.size()));
    EXPECT_NEAR(double(receivers.cells.size()), 50 - 6, 5);
    EXPECT_TRUE(std::is_sorted(receivers.cells.begin(), receivers.cells.end()));
    for (const std::uint32_t cell : receivers.cells) EXPECT_EQ(receivers.kind[cell], CellKind::ground);
    EXPECT_EQ(receivers.kind[receivers.grid.index(9, 9)], CellKind::outside);
    EXPECT_EQ(receivers.kind[receivers.grid.index(2, 3)], CellKind::building);
}

// A lake of 10 x 10 m with an island of 4 x 4 m, under a corner of a house; a park is not water.
City cityWithLake() {
    Footprint lake = plotBetween(0, 0, 10, 10);
    lake.holes = {{{3, 3}, {3, 7}, {7, 7}, {7, 3}}};
    MapContext map;
    map.areas = {{ContextKind::water, "Lake", {lake}},
                 {ContextKind::park, "Park", {plotBetween(10, 0, 20, 10)}}};
    City city;
    city.buildings = {building(plotBetween(8, 8, 12, 12))};
    city.context = std::make_shared<const MapContext>(map);
    return city;
}

TEST(Receivers, WaterIsNoGroundButItsIslandsAre) {
    const City city = cityWithLake();
    const Region region = makeRegionFromLocalBox({{0, 0}, {20, 20}});
    const Receivers receivers = receiversOf(city, region);
    EXPECT_EQ(countOf(receivers, CellKind::water), 100 - 16 - 4);
    EXPECT_EQ(countOf(receivers, CellKind::building), 16);
    EXPECT_EQ(receivers.cells.size(), 400U - 80 - 16);
    EXPECT_EQ(receivers.kind[receivers.grid.index(5, 5)], CellKind::ground) << "the island";
    EXPECT_EQ(receivers.kind[receivers.grid.index(9, 9)], CellKind::building) << "the building stands in it";
}

TEST(Receivers, WaterIsGroundWhereItIsAskedFor) {
    City city = cityWithLake();
    const Grid part{0, 0, 1, 20, 20};
    const Region region = makeRegionFromLocalBox({{0, 0}, {20, 20}});
    const auto whole = placeReceiversInPart(city, region, part, {}, WaterCells::ground);
    city.context = nullptr;
    const auto unmapped = placeReceiversInPart(city, region, part);
    EXPECT_EQ(countOf(*whole, CellKind::water), 0);
    EXPECT_EQ(whole->kind, unmapped->kind);
}

TEST(Receivers, PartsOfAGridHaveTheWaterOfTheWhole) {
    const City city = cityWithLake();
    const Region region = makeRegionFromLocalBox({{0, 0}, {20, 20}});
    const Receivers whole = receiversOf(city, region);
    const auto part = placeReceiversInPart(city, region, {4, 4, 1, 5, 5});
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column)
            EXPECT_EQ(part->kind[part->grid.index(column, row)],
                      whole.kind[whole.grid.index(column + 4, row + 4)]);
}

TEST(Receivers, RowsGoNorthAndColumnsEast) {
    const Receivers receivers = receiversOf({}, makeRegionFromLocalBox({{-3, 10}, {2, 14}}), 0.5);
    EXPECT_EQ(receivers.grid, (Grid{-3, 10, 0.5, 10, 8}));
    EXPECT_EQ(receivers.position(0), glm::vec3(-2.75F, 10.25F, 0));
    EXPECT_EQ(receivers.position(9), glm::vec3(1.75F, 10.25F, 0));
    EXPECT_EQ(receivers.position(79), glm::vec3(1.75F, 13.75F, 0));
    EXPECT_TRUE(receivers.flat());
}

TEST(Receivers, HangingPartsLeaveTheGroundBelow) {
    City city;
    city.buildings = {building(plotBetween(0, 0, 4, 4), true)};
    const Region region = makeRegionFromLocalBox({{0, 0}, {8, 8}});
    EXPECT_EQ(countOf(receiversOf(city, region), CellKind::building), 0);
    city.buildings.push_back(building(plotBetween(2, 2, 6, 6)));
    EXPECT_EQ(countOf(receiversOf(city, region), CellKind::building), 16);
}

TEST(Receivers, CourtyardsAreGround) {
    Footprint court = plotBetween(0, 0, 8, 8);
    court.holes = {{{2, 2}, {2, 5}, {5, 5}, {5, 2}}};
    City city;
    city.buildings = {building(court)};
    EXPECT_EQ(receiversOf(city, makeRegionFromLocalBox({{0, 0}, {8, 8}})).cells.size(), 9U);
}

TEST(Receivers, OverlappingRegionsShareTheirCells) {
    for (const double cellM : {0.25, 0.3, 1.0, 7.0}) {
        const Grid one = receiversOf({}, makeRegionFromLocalBox({{-10.3F, 4.1F}, {30, 30}}), cellM).grid;
        const Grid other = receiversOf({}, makeRegionFromLocalBox({{3.9F, -20.7F}, {40, 12}}), cellM).grid;
        for (const double apart : {(one.westM - other.westM) / cellM, (one.southM - other.southM) / cellM})
            EXPECT_NEAR(apart, std::round(apart), 1e-9) << cellM;
        EXPECT_LE(one.westM, -10.3);
        EXPECT_GE(one.eastM(), 30);
    }
}

TEST(Receivers, StandOnTheTerrain) {
    City city;
    city.terrain = std::make_shared<const Terrain>(Terrain{{0, 0, 10, 2, 2}, {0, 10, 0, 10}});
    const Receivers receivers = receiversOf(city, makeRegionFromLocalBox({{0, 0}, {20, 20}}));
    EXPECT_FALSE(receivers.flat());
    EXPECT_FLOAT_EQ(receivers.position(std::uint32_t(receivers.grid.index(0, 3))).z, 0);
    EXPECT_FLOAT_EQ(receivers.position(std::uint32_t(receivers.grid.index(10, 3))).z, 5.5);
    EXPECT_FLOAT_EQ(receivers.position(std::uint32_t(receivers.grid.index(19, 3))).z, 10);
}

TEST(Receivers, WhatCannotBeIsRefusedInWords) {
    const Region region = makeRegionFromLocalBox({{0, 0}, {8, 8}});
    for (const double cellM : {0.0, -1.0, 0.2, 10.5, std::nan("")})
        EXPECT_THAT(placeReceiversOnGround({}, region, {.cellM = cellM}).error().text(),
                    testing::HasSubstr("0.25 to 10"));
    EXPECT_THAT(placeReceiversOnGround({}, {"empty", {}}, {}).error().text(), testing::HasSubstr("no area"));
    const Region huge = makeRegionFromLocalBox({{0, 0}, {60000, 60000}});
    EXPECT_THAT(placeReceiversOnGround({}, huge, {}).error().text(), testing::HasSubstr("3.6 billion cells"));
    const Region absurd = makeRegionFromLocalBox({{-1e20F, -1e20F}, {1e20F, 1e20F}});
    EXPECT_FALSE(placeReceiversOnGround({}, absurd, {}).has_value());
}

TEST(Receivers, CanBeStopped) {
    std::stop_source stop;
    stop.request_stop();
    const auto receivers =
        placeReceiversOnGround({}, makeRegionFromLocalBox({{0, 0}, {10, 10}}), {}, stop.get_token());
    ASSERT_FALSE(receivers);
    EXPECT_TRUE(isCancelled(receivers.error()));
}

TEST(Region, LonLatBoxFollowsTheParallels) {
    const Frame frame({-73.98, 40.75});
    const auto region = makeRegionFromLonLatBox(frame, -74.0, 40.74, -73.96, 40.76);
    ASSERT_TRUE(region.has_value());
    ASSERT_EQ(region->polygons.size(), 1U);
    const Footprint& polygon = region->polygons[0];
    EXPECT_GT(signedArea(polygon.outer), 0);
    // Known lengths at 40.75 N: 111,049 m per degree of latitude, 84,443 m per degree of longitude.
    EXPECT_NEAR(area(polygon), 0.02 * 111049 * 0.04 * 84443, 0.02 * 111049 * 0.04 * 84443 * 1e-3);
    EXPECT_TRUE(contains(polygon, {0, 0}));
    for (const glm::vec2 point : polygon.outer) {
        const LonLat place = frame.lonLatFromLocal(glm::dvec2(point));
        const bool onMeridian = std::abs(std::abs(place.lonDeg + 73.98) - 0.02) < 1e-7;
        const bool onParallel = std::abs(std::abs(place.latDeg - 40.75) - 0.01) < 1e-7;
        EXPECT_TRUE(onMeridian || onParallel) << place.lonDeg << ' ' << place.latDeg;
    }
}

// Taveuni, Fiji: the 180th meridian runs through its middle.
TEST(Region, ABoxMayLieAcrossTheAntimeridian) {
    const Frame taveuni({180, -16.85});
    const Region across = makeRegionFromLonLatBox(taveuni, 179.98, -16.86, -179.97, -16.84).value();
    const Frame samePlace({10, -16.85});
    const Region elsewhere = makeRegionFromLonLatBox(samePlace, 9.98, -16.86, 10.03, -16.84).value();
    ASSERT_EQ(across.polygons[0].outer.size(), elsewhere.polygons[0].outer.size());
    for (std::size_t i = 0; i < across.polygons[0].outer.size(); ++i)
        EXPECT_NEAR(glm::distance(across.polygons[0].outer[i], elsewhere.polygons[0].outer[i]), 0, 1e-3);
    EXPECT_EQ(formatBox(across, taveuni), "179.98,-16.86,-179.97,-16.84");
    EXPECT_EQ(formatBox(elsewhere, samePlace), "9.98,-16.86,10.03,-16.84");
    const Region toIt = makeRegionFromLonLatBox(taveuni, 179.98, -16.86, 180, -16.84).value();
    EXPECT_EQ(formatBox(toIt, taveuni), "179.98,-16.86,180,-16.84");
}

TEST(Region, BoxesThatAreNoneAreRefused) {
    const Frame frame({-73.98, 40.75});
    EXPECT_FALSE(makeRegionFromLonLatBox(frame, -73.96, 40.74, -74.0, 40.76).has_value());
    EXPECT_FALSE(makeRegionFromLonLatBox(frame, -74.0, 40.76, -73.96, 40.74).has_value());
    EXPECT_FALSE(makeRegionFromLonLatBox(frame, -74.0, 40.74, -74.0, 40.76).has_value());
    EXPECT_FALSE(makeRegionFromLonLatBox(frame, -74.0, 40.74, -73.96, 90.1).has_value());
    EXPECT_FALSE(makeRegionFromLonLatBox(frame, -181, 40.74, -73.96, 40.76).has_value());
    EXPECT_FALSE(makeRegionFromLonLatBox(frame, std::nan(""), 40.74, -73.96, 40.76).has_value());
}

}  // namespace

}  // namespace noonmark
