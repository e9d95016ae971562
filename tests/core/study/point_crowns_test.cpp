#include "core/study/point_crowns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "core/city/trees/tree.h"
#include "core/study/point_study.h"
#include "core/study/text/point_text.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

const LonLat here{0, 50};

// A cylinder of 6 m, from 4 m to 10 m above the ground, that lets through so much.
Tree cylinderAt(glm::dvec2 place, float leafOn, float leafOff) {
    return {.sourceId = "tree",
            .place = place,
            .heightM = 10,
            .crownBaseM = 4,
            .crownDiameterM = 6,
            .shape = CrownShape::cylinder,
            .leafOnTransmissivity = leafOn,
            .leafOffTransmissivity = leafOff};
}

City cityWith(std::vector<Tree> trees, const std::vector<Box3>& boxes = {}) {
    City city = cityOf(boxes);
    city.frame = Frame(here);
    city.trees = std::make_shared<const Trees>(Trees{.trees = std::move(trees), .leafDays = {106, 320}});
    return city;
}

PointStudy lookAround(const City& city, CivilDate day, double stepMinutes = 10) {
    return runPointStudy(city, nullptr, {.at = here, .heightM = 0, .day = day, .stepMinutes = stepMinutes},
                         {})
        .value();
}

constexpr CivilDate june{std::chrono::year(2026), std::chrono::June, std::chrono::day(21)};
constexpr CivilDate december{std::chrono::year(2026), std::chrono::December, std::chrono::day(21)};

TEST(PointCrowns, ACylinderIsSeenWhereItStands) {
    // 20 m to the south: it is as wide as asin(3 / 20) to either side; its lower rim is lowest at the far
    // side and its upper rim highest at the near side, 23 m and 17 m away.
    const PointStudy study = lookAround(cityWith({cylinderAt({0, -20}, 0.1F, 0.7F)}), june);
    ASSERT_TRUE(study.baseline.crowns);
    ASSERT_EQ(study.baseline.crowns->seen.size(), 1U);
    const SeenCrown& crown = study.baseline.crowns->seen.front();
    const auto degrees = [](double radians) { return Radians{radians}.degrees().value; };
    const double half = degrees(std::asin(3.0 / 20));
    EXPECT_NEAR(crown.columns.front().azimuthDeg, 180 - half, 0.02);
    EXPECT_NEAR(crown.columns.back().azimuthDeg, 180 + half, 0.02);
    const CrownColumn& middle = crown.columns[crown.columns.size() / 2];
    EXPECT_NEAR(middle.azimuthDeg, 180, 0.5);
    EXPECT_NEAR(middle.lowDeg, degrees(std::atan2(4, 23)), 0.05);
    EXPECT_NEAR(middle.highDeg, degrees(std::atan2(10, 17)), 0.05);
    EXPECT_NEAR(crown.distanceM, 20, 1e-3);
}

TEST(PointCrowns, BelowACrownTheZenithIsCoveredAtAllAzimuths) {
    const PointStudy study = lookAround(cityWith({cylinderAt({1, 0}, 0.1F, 0.7F)}), june);
    ASSERT_TRUE(study.baseline.crowns);
    const SeenCrown& crown = study.baseline.crowns->seen.at(0);
    EXPECT_EQ(crown.columns.front().azimuthDeg, 0);
    EXPECT_EQ(crown.columns.back().azimuthDeg, 360);
    for (const CrownColumn& column : crown.columns) EXPECT_NEAR(column.highDeg, 90, 1e-9);
}

TEST(PointCrowns, ACrownAcrossNorthHasAColumnThere) {
    const PointStudy study = lookAround(cityWith({cylinderAt({0, 20}, 0.1F, 0.7F)}), june);
    const auto& columns = study.baseline.crowns->seen.at(0).columns;
    EXPECT_LT(columns.front().azimuthDeg, 360);
    EXPECT_GT(columns.back().azimuthDeg, 360);
    EXPECT_TRUE(std::ranges::any_of(columns, [](const auto& one) { return one.azimuthDeg == 360; }));
}

TEST(PointCrowns, TimesAreOfLessThanHalfOfTheSunTaken) {
    const PointStudy thin = lookAround(cityWith({cylinderAt({0, -16}, 0.9F, 0.9F)}), december, 2);
    ASSERT_TRUE(thin.baseline.crowns);
    EXPECT_LT(thin.baseline.crowns->evergreen.dayMin, thin.baseline.sunlit.front().minutes() - 3);
    EXPECT_EQ(thin.baseline.crowns->evergreen.sunlit, thin.baseline.sunlit);
    // Behind a house none are lit, whatever stands before it.
    const City hidden = cityWith({cylinderAt({0, -16}, 0.1F, 0.7F)}, {{{-300, -40, 0}, {300, -30, 200}}});
    const PointStudy dark = lookAround(hidden, december, 2);
    ASSERT_TRUE(dark.baseline.crowns);
    EXPECT_EQ(dark.baseline.crowns->evergreen.sunlit, dark.baseline.sunlit);
}

TEST(PointCrowns, WhatStandsBehindAHouseIsNotSeen) {
    const City city = cityWith({cylinderAt({0, -40}, 0.1F, 0.7F)}, {{{-30, -20, 0}, {30, -10, 30}}});
    const PointStudy study = lookAround(city, december);
    EXPECT_TRUE(!study.baseline.crowns || study.baseline.crowns->seen.empty());
}

TEST(PointCrowns, MinutesAreThoseOfTheSharesThatPass) {
    // Opaque in leaf, clear when bare: by seasons a day is either that of a house like it, or an open one.
    const PointStudy summer = lookAround(cityWith({cylinderAt({0, -16}, 1e-9F, 1)}), june, 2);
    const PointStudy winter = lookAround(cityWith({cylinderAt({0, -16}, 1e-9F, 1)}), december, 2);
    ASSERT_TRUE(winter.baseline.crowns);
    const double openInWinter = winter.baseline.sunlit.front().minutes();
    EXPECT_FALSE(winter.baseline.crowns->inLeaf);
    EXPECT_NEAR(winter.baseline.crowns->seasonal.dayMin, openInWinter, 2);
    // The noon sun of 16.6 degrees stands behind the crown, from atan(4 / 19) = 11.9 to atan(10 / 13) = 37.6
    // degrees, for asin(3 / 16) = 10.8 degrees of azimuth to either side: some 85 minutes.
    EXPECT_LT(winter.baseline.crowns->evergreen.dayMin, openInWinter - 60);
    EXPECT_TRUE(summer.baseline.crowns->inLeaf);
    EXPECT_EQ(summer.baseline.crowns->seasonal.dayMin, summer.baseline.crowns->evergreen.dayMin);
    // So are its times: the crown parts the winter's day in two, and what is bare parts none.
    const PointShade &evergreens = winter.baseline.crowns->evergreen,
                     &seasons = winter.baseline.crowns->seasonal;
    EXPECT_EQ(seasons.sunlit, winter.baseline.sunlit);
    ASSERT_EQ(evergreens.sunlit.size(), 2U);
    EXPECT_EQ(evergreens.sunlit.front().from, winter.baseline.sunlit.front().from);
    EXPECT_NEAR(evergreens.sunlit.front().minutes() + evergreens.sunlit.back().minutes(), evergreens.dayMin,
                5);
    EXPECT_NEAR(evergreens.sunlit.front().minutes(), evergreens.sunlit.back().minutes(), 3)
        << "it stands due south";
    const auto all = sumMonths(winter.baseline.minutes),
               seasonal = sumMonths(winter.baseline.crowns->seasonal.minutes),
               evergreen = sumMonths(winter.baseline.crowns->evergreen.minutes);
    EXPECT_NEAR(seasonal[0], all[0], 1e-3 * all[0]) << "bare in January";
    EXPECT_LT(evergreen[0], 0.9 * all[0]);
    EXPECT_NEAR(seasonal[6], evergreen[6], 1e-6) << "in leaf in July";
}

TEST(PointCrowns, TransmissivityIsTheMeanOverWhatIsSeen) {
    // By chance or design most chords are shorter than the mean one, near the edges: more light passes.
    const PointStudy study = lookAround(cityWith({cylinderAt({0, -40}, 0.1F, 0.7F)}), june);
    const SeenCrown& crown = study.baseline.crowns->seen.at(0);
    EXPECT_GT(crown.leafOnTransmissivity, 0.03);
    EXPECT_LT(crown.leafOnTransmissivity, 0.3);
    EXPECT_GT(crown.leafOffTransmissivity, 0.6);
    EXPECT_LT(crown.leafOffTransmissivity, 0.85);
}

TEST(PointCrowns, FilesStateThem) {
    const City city = cityWith({cylinderAt({0, -20}, 0.1F, 0.7F)});
    const PointStudy study = lookAround(city, december);
    const Zone zone = Zone::named("UTC").value();
    const auto json = pointJson(study, city, nullptr, zone);
    EXPECT_EQ(json.at("trees").at("crowns").size(), 1U);
    EXPECT_EQ(json.at("trees").at("crowns").at(0).at("tree"), "tree");
    EXPECT_EQ(json.at("trees").at("in_leaf_on_the_day"), false);
    EXPECT_EQ(json.at("minutes_by_month_seasonal").size(), 12U);
    EXPECT_LT(json.at("svf_evergreen"), json.at("svf_seasonal"));
    EXPECT_LT(json.at("svf_seasonal"), json.at("svf"));
    EXPECT_FALSE(json.contains("vsc_pct_seasonal")) << "it is no wall";
    ASSERT_EQ(json.at("taken_by_tree").size(), 1U);
    EXPECT_EQ(json.at("taken_by_tree").at(0).at("tree"), "tree");
    EXPECT_GT(json.at("taken_by_tree").at(0).at("day_min_evergreen"),
              json.at("taken_by_tree").at(0).at("day_min_seasonal"));
    EXPECT_LT(json.at("sunlit_min_seasonal"), study.baseline.sunlit.front().minutes());
    EXPECT_THAT(pointCsv(study),
                testing::StartsWith("month,hour,baseline_min,baseline_min_evergreen,baseline_min_seasonal"));
    const PointStudy bare = lookAround(cityWith({}), june);
    EXPECT_FALSE(bare.baseline.crowns);
    EXPECT_FALSE(pointJson(bare, city, nullptr, zone).contains("trees"));
}

// The sky view factor below an endless slab of leaves whose optical depth upwards is `depth`: twice the
// integral of s exp(-depth / s) over s, the sine of the altitude, from 0 to 1. That is 2 E3(depth).
double skyBelowSlab(double depth) {
    return std::exp(-depth) * (1 - depth) - depth * depth * std::expint(-depth);
}

TEST(PointCrowns, TheSkyBelowASlabOfLeavesIsThatOfTheClosedForm) {
    Tree slab = cylinderAt({0, 0}, 0.5F, 0.8F);
    slab.crownDiameterM = 4000;
    const PointStudy study = lookAround(cityWith({slab}), june);
    ASSERT_TRUE(study.baseline.crowns);
    const PointCrowns& crowns = *study.baseline.crowns;
    const double meanChordM = 2 * 2000.0 * 6 / (2000 + 6);  // 4 V / S
    const double inLeaf = skyBelowSlab(-std::log(0.5) * 6 / meanChordM),
                 bare = skyBelowSlab(-std::log(0.8) * 6 / meanChordM);
    EXPECT_NEAR(study.baseline.factors.skyView, 1, 1e-6);
    EXPECT_NEAR(crowns.evergreen.sky.skyView, inLeaf, 5e-4);
    const double share = 214 / 365.0;  // of the days from the 106th to the 320th
    EXPECT_NEAR(crowns.seasonal.sky.skyView, share * inLeaf + (1 - share) * bare, 1.5e-3);
    EXPECT_GT(bare - inLeaf, 0.1) << "the seasons differ";
}

// Two crowns behind each other, the nearer one on days of its own: days 100 to 149 the nearer alone, 150 to
// 199 both, 200 to 319 the other alone.
TEST(PointCrowns, TheSkyWithLeafDaysOfSingleTreesIsTheMeanOfTheDays) {
    const auto sky = [](LeafDays nearer, LeafDays other) {
        Tree first = cylinderAt({0, -8}, 0.2F, 0.9F), second = cylinderAt({1, -13}, 0.3F, 0.8F);
        first.leafOnDay = nearer.on;
        first.leafOffDay = nearer.off;
        second.leafOnDay = other.on;
        second.leafOffDay = other.off;
        return lookAround(cityWith({first, second}), june).baseline.crowns->seasonal.sky;
    };
    constexpr LeafDays always{1, 1}, never{366, 367};
    const SkyFactors both = sky(always, always), nearer = sky(always, never), other = sky(never, always),
                     bare = sky(never, never), found = sky({100, 200}, {150, 320});
    const auto mean = [&](double SkyFactors::*factor) {
        return (50 * (both.*factor) + 50 * (nearer.*factor) + 120 * (other.*factor) + 145 * (bare.*factor)) /
               365;
    };
    EXPECT_NEAR(found.skyView, mean(&SkyFactors::skyView), 1e-12);
    EXPECT_NEAR(found.skyComponentPct, mean(&SkyFactors::skyComponentPct), 1e-10);
    EXPECT_GT(bare.skyView - both.skyView, 0.01) << "the seasons differ";
}

// The share of a wall's light that a ball of leaves leaves, by rays in small steps: `overcast` as the CIE's.
double lightBesideABall(glm::dvec3 middle, double radiusM, double perM, glm::dvec3 eye, bool overcast) {
    constexpr int azimuths = 1440, altitudes = 720;
    double sum = 0;
    for (int i = 0; i < altitudes; ++i)
        for (int k = 0; k < azimuths; ++k) {
            const double altitude = std::numbers::pi / 2 * (i + 0.5) / altitudes;
            const double azimuth = std::numbers::pi * (k + 0.5) / azimuths - std::numbers::pi / 2;
            const glm::dvec3 ray(std::cos(altitude) * std::sin(azimuth),
                                 -std::cos(altitude) * std::cos(azimuth), std::sin(altitude));
            const double along = glm::dot(middle - eye, ray);
            const double off2 = glm::dot(middle - eye, middle - eye) - along * along;
            const double chord = off2 < radiusM * radiusM ? 2 * std::sqrt(radiusM * radiusM - off2) : 0;
            sum +=
                std::exp(-perM * chord) * -ray.y * std::cos(altitude) * (overcast ? (1 + 2 * ray.z) / 3 : 1);
        }
    sum *= std::numbers::pi / 2 / altitudes * std::numbers::pi / azimuths;
    return overcast ? 100 * sum / (7 * std::numbers::pi / 9) : sum / std::numbers::pi;
}

TEST(PointCrowns, TheSkyBesideABallIsThatOfRays) {
    Tree ball = cylinderAt({0.5, -5}, 0.1F, 0.7F);
    ball.shape = CrownShape::ellipsoid;
    const PointStudy study =
        runPointStudy(cityWith({ball}), nullptr,
                      {.at = here, .heightM = 1.5, .facingDeg = 180.0, .day = june, .stepMinutes = 10}, {})
            .value();
    ASSERT_TRUE(study.baseline.crowns);
    const PointCrowns& crowns = *study.baseline.crowns;
    const double perM = -std::log(0.1) / (4 * 3.0 / 3);  // 4 V / S of a ball of 3 m
    const glm::dvec3 middle(0.5, -5, 7), eye(0, 0, 1.5);
    EXPECT_NEAR(study.baseline.factors.skyComponentPct, 39.6, 0.1);
    EXPECT_NEAR(crowns.evergreen.sky.skyComponentPct, lightBesideABall(middle, 3, perM, eye, true), 0.03);
    EXPECT_NEAR(crowns.evergreen.sky.skyView, lightBesideABall(middle, 3, perM, eye, false), 3e-4);
    EXPECT_LT(crowns.evergreen.sky.skyComponentPct, study.baseline.factors.skyComponentPct - 3);
    EXPECT_LT(crowns.evergreen.sky.skyComponentPct, crowns.seasonal.sky.skyComponentPct);
    EXPECT_LT(crowns.seasonal.sky.skyComponentPct, study.baseline.factors.skyComponentPct);
}

TEST(PointCrowns, TreesAreChargedWithWhatAllOfThemTake) {
    const auto minutesOf = [](const MonthHours& minutes) {
        const auto months = sumMonths(minutes);
        return std::accumulate(months.begin(), months.end(), 0.0);
    };
    const City city = cityWith({cylinderAt({0, -16}, 0.1F, 0.7F), cylinderAt({0, -16}, 0.1F, 0.7F),
                                cylinderAt({-14, -8}, 0.3F, 0.9F), cylinderAt({0, 500}, 0.1F, 0.7F)});
    const PointStudy study = lookAround(city, december, 5);
    const PointCrowns& crowns = *study.baseline.crowns;
    const std::vector<TreeMinutes> trees = listTakenByTree(crowns);
    ASSERT_EQ(trees.size(), 3U) << "one is far to the north";
    TreeMinutes sum;
    for (const TreeMinutes& one : trees) {
        sum.yearSeasonal += one.yearSeasonal;
        sum.yearEvergreen += one.yearEvergreen;
        sum.daySeasonal += one.daySeasonal;
    }
    const double lit = minutesOf(study.baseline.minutes);
    EXPECT_NEAR(sum.yearSeasonal, lit - minutesOf(crowns.seasonal.minutes), 0.01 * sum.yearSeasonal);
    EXPECT_NEAR(sum.yearEvergreen, lit - minutesOf(crowns.evergreen.minutes), 0.01 * sum.yearEvergreen);
    EXPECT_NEAR(sum.daySeasonal, study.baseline.sunlit.front().minutes() - crowns.seasonal.dayMin, 2);
    EXPECT_NEAR(trees[0].yearSeasonal, trees[1].yearSeasonal, 1e-9) << "of two in one place each has half";
    EXPECT_EQ(trees[2].tree, 2U) << "the thinnest takes least";
    EXPECT_THAT(takenText(crowns),
                testing::ContainsRegex("^tree [0-9]+ min on the day, [0-9.]+ h in the year; "));
}

}  // namespace
}  // namespace noonmark
