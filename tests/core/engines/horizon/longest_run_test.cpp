#include "core/engines/horizon/counting/longest_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/engines/horizon/trees/crown_sweep.h"

namespace noonmark {
namespace {

std::vector<RunLanes> randomHorizons(std::mt19937& random, std::size_t bins) {
    std::vector<RunLanes> horizons(bins);
    std::array<int, lanesPerPart> level{};
    for (RunLanes& bin : horizons)
        for (std::size_t lane = 0; lane < lanesPerPart; ++lane) {
            if (random() % 6 == 0) level[lane] = int(random() % 200);
            bin.values[lane] = std::int16_t(level[lane]);
        }
    return horizons;
}

// Days that begin and end at different times, skip bins, go back, and stand still.
std::vector<TimedStep> pickRandomDays(std::mt19937& random, int days, int bins) {
    std::vector<TimedStep> steps;
    for (int day = 0; day < days; ++day) {
        const int first = int(random() % 10), count = 60 + int(random() % 60), turn = int(random() % 400);
        const int height = 100 + int(random() % 40) - day;
        for (int i = 0; i < count; ++i) {
            const int along = i < turn ? i : 2 * turn - i;
            const int bin = std::clamp(first + along * (2 + day % 3) / 3, 0, bins - 1);
            steps.push_back({{std::uint16_t(bin), std::int16_t(height - std::abs(60 - i))},
                             i == 0 || random() % 90 == 0});
        }
    }
    return steps;
}

int walked(const LongestRuns& runs, const std::vector<RunLanes>& horizons, std::size_t lane) {
    return runs.ofOne([&](const StepPlace& place) { return place.sun < horizons[place.bin].values[lane]; })
        .length();
}

TEST(LongestRuns, AreThoseOfAStepByStepWalk) {
    std::mt19937 random(5);
    for (int round = 0; round < 40; ++round) {
        const std::vector<RunLanes> horizons = randomHorizons(random, 130);
        const std::vector<TimedStep> steps = pickRandomDays(random, 1 + round, 130);
        const LongestRuns runs(steps);
        const LongestRuns::Found found = runs.of(horizons);
        for (std::size_t lane = 0; lane < lanesPerPart; ++lane) {
            const int longest = found.longest.values[lane];
            EXPECT_EQ(longest, walked(runs, horizons, lane)) << lane;
            if (longest == 0) continue;
            const StepRun run = runs.run(horizons, lane, found.day[lane], longest);
            ASSERT_EQ(run.length(), longest);
            for (std::uint32_t step = run.first; step < run.end; ++step) {
                const StepPlace& place = runs.steps()[step].place;
                EXPECT_LT(place.sun, horizons[place.bin].values[lane]);
                EXPECT_FALSE(step > run.first && runs.steps()[step].startsRun);
            }
        }
    }
}

TEST(LongestRuns, OfEachDayHaveThatOfThePeriodAsTheLongest) {
    std::mt19937 random(6);
    const std::vector<RunLanes> horizons = randomHorizons(random, 130);
    const std::vector<TimedStep> steps = pickRandomDays(random, 20, 130);
    const LongestRuns runs(steps);
    std::vector<RunLanes> days;
    runs.ofEachDay(horizons, days);
    for (std::size_t lane = 0; lane < lanesPerPart; ++lane) {
        int longest = 0;
        for (const RunLanes& day : days) longest = std::max(longest, int(day.values[lane]));
        EXPECT_EQ(longest, walked(runs, horizons, lane)) << lane;
    }
}

/// The steps hidden from one receiver, and horizons that agree with them except for `doubtful` percent of the
/// steps: those are hidden by the highest horizon and not by the lowest.
struct Doubtful {
    std::vector<bool> hidden;
    RunSearch::Horizons horizons;
};

// One bin per step, so that any combination of steps may be hidden.
std::vector<TimedStep> stepsOfOwnBins(std::mt19937& random, int days, int stepsADay) {
    std::vector<TimedStep> steps;
    for (int i = 0; i < days * stepsADay; ++i)
        steps.push_back({{std::uint16_t(i), 0}, i % stepsADay == 0 || random() % 40 == 0});
    return steps;
}

Doubtful doubtful(std::mt19937& random, std::size_t steps, unsigned percent) {
    Doubtful made;
    bool hidden = true;
    for (std::size_t i = 0; i < steps; ++i) {
        if (random() % 8 == 0) hidden = !hidden;
        const bool doubt = random() % 100 < percent;
        made.hidden.push_back(hidden);
        made.horizons.highest.push_back(hidden || doubt ? 1 : -1);
        made.horizons.own.push_back(hidden ? 1 : -1);
        made.horizons.lowest.push_back(hidden && !doubt ? 1 : -1);
    }
    return made;
}

int longestOf(const std::vector<bool>& hidden, std::span<const TimedStep> steps) {
    int run = 0, longest = 0;
    for (std::size_t i = 0; i < hidden.size(); ++i) {
        if (steps[i].startsRun) run = 0;
        run = hidden[i] ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    return longest;
}

std::vector<DaySteps> partsOf(std::span<const TimedStep> steps) {
    std::vector<DaySteps> parts;
    for (std::uint32_t i = 0; i < steps.size(); ++i) {
        if (steps[i].startsRun) parts.push_back({i, i});
        parts.back().end = i + 1;
    }
    return parts;
}

TEST(RunSearch, FindsTheLongestRunAndAsksFewRays) {
    std::mt19937 random(7);
    std::size_t asked = 0, doubts = 0;
    for (int round = 0; round < 200; ++round) {
        const std::vector<TimedStep> steps = stepsOfOwnBins(random, 10, 48);
        const Doubtful scene = doubtful(random, steps.size(), 20);
        RunSearch search;
        search.horizons() = scene.horizons;
        const auto hidden = [&](std::uint32_t step) {
            EXPECT_GT(scene.horizons.highest[step], 0);
            EXPECT_LT(scene.horizons.lowest[step], 0);
            ++asked;
            return bool(scene.hidden[step]);
        };
        search.begin({hidden, nullptr}, steps, 0);
        for (const DaySteps& part : partsOf(steps)) search.walk(part);
        EXPECT_EQ(search.longest(), longestOf(scene.hidden, steps)) << round;
        doubts += steps.size() / 5;
    }
    EXPECT_LT(asked, doubts / 2);
}

// Gaps that no horizon shows: steps hidden by the lowest horizon may be lit.
TEST(RunSearch, FindsGapsThatNoHorizonKnowsOf) {
    std::mt19937 random(8);
    for (int round = 0; round < 200; ++round) {
        const std::vector<TimedStep> steps = stepsOfOwnBins(random, 10, 48);
        Doubtful scene = doubtful(random, steps.size(), 10);
        for (std::size_t i = 0; i < steps.size(); ++i)
            if (random() % 12 == 0) scene.hidden[i] = false;
        RunSearch search;
        search.horizons() = scene.horizons;
        const auto hidden = [&](std::uint32_t step) { return bool(scene.hidden[step]); };
        const auto findLit = [&](std::uint32_t first, std::uint32_t end) -> std::optional<std::uint32_t> {
            for (std::uint32_t step = first; step < end; ++step)
                if (!scene.hidden[step]) return step;
            return std::nullopt;
        };
        search.begin({hidden, findLit}, steps, 0);
        for (const DaySteps& part : partsOf(steps)) search.walk(part);
        EXPECT_EQ(search.longest(), longestOf(scene.hidden, steps)) << round;
    }
}

// Three steps hidden for some lanes, one for none, three that others lose; on the next day one more. Lane L
// misses the suns of the first span below L and those above 100 - L.
TEST(WalkSpans, FindsTheLongestRunOfEachLaneWithinItsDay) {
    constexpr HorizonCode none = std::numeric_limits<HorizonCode>::max();
    RunLanes below, above, nothingBelow, nothingAbove;
    for (std::size_t lane = 0; lane < lanesPerPart; ++lane) {
        below.values[lane] = HorizonCode(lane);
        above.values[lane] = HorizonCode(100 - lane);
        nothingAbove.values[lane] = none;
    }
    const std::vector<SpanLanes> spans{{below.values, above.values},
                                       {nothingBelow.values, nothingAbove.values}};
    std::vector<SpanStep> steps{{0, 10, true}, {0, 20}, {0, 30}, {1, 50}, {0, 90}, {0, 95}, {0, 99}};
    const auto longestWith = [&](const SpanStep& last) {
        std::vector<SpanStep> all = steps;
        all.push_back(last);
        RunLanes longest;
        longest.values[0] = 7;
        walkSpans(spans, all, longest);
        return std::vector<int>(std::begin(longest.values), std::end(longest.values));
    };
    std::vector<int> expected(lanesPerPart, 3);  // 90, 95, 99 from lane 11 on
    std::fill_n(expected.begin(), 11, 2);        // 95, 99
    std::fill_n(expected.begin(), 6, 1);         // 99
    expected[0] = 7;                             // of an earlier day
    expected[1] = 0;                             // 99 is not above 99
    EXPECT_EQ(longestWith({0, 10, true}), expected);
    std::fill(expected.begin() + 11, expected.end(), 4);
    EXPECT_EQ(longestWith({0, 10, false}), expected) << "the same day";
}

/// Shares of a row of cells by level, which levels are known and touched, and the marks that follow.
struct DarkCase {
    std::string what;
    std::array<float, 6> shares;
    unsigned known, touched;
    DarkLevels dark;
};

// Marks of the levels, and then of the changes in sixteenths.
const std::vector<DarkCase>& darkCases() {
    static const std::vector<DarkCase> cases{
        {"rises, half-way between two levels", {0, 0.25, 0.375, 0.625, 0.75, 1}, 0x3f, 0x3f, 0x8'0038},
        {"falls, at a quarter of the way", {1, 0.625, 0.125, 0, 0, 0}, 0x3f, 0x3f, 0x4'0003},
        {"reached at a level itself is dark", {0, 0.5, 0.5, 0.5, 0.5, 0.5}, 0x3f, 0x3f, 0xf'003e},
        {"less throughout", {0.25, 0.25, 0.25, 0.25, 0.25, 0.25}, 0x3f, 0x3f, 0},
        {"the fifth change has no place", {0, 1, 0, 1, 0, 1}, 0x3f, 0x3f, 0x8888'002a},
        {"unknown levels are as the known one below", {0, 9, 9, 9, 1, 1}, 0x31, 0x3f, 0x8'0030},
        {"below the lowest known as that one", {9, 9, 1, 9, 9, 9}, 0x04, 0x3f, 0x3f},
        {"crowns touch one level", {9, 9, 1, 9, 9, 9}, 0x3f, 0x04, 0x88'0004},
        {"no crown touches the row", {9, 9, 9, 9, 9, 9}, 0x3f, 0, 0},
    };
    return cases;
}

struct DarkScene {
    CrownLevels levels;
    CrownDepths shares;
    std::array<std::uint16_t, CrownDepths::side> computed{};
    alignas(64) std::array<DarkLevels, ReceiverBlocks::cells> inLeaf, bare;
    bool anyBare = false;

    // A case in each row; out of season the same.
    explicit DarkScene(std::span<const DarkCase> cases) {
        levels.count = cases.front().shares.size();
        for (std::size_t row = 0; row < cases.size(); ++row) {
            computed[row] = std::uint16_t(cases[row].known);
            shares.touched[row] = std::uint16_t(cases[row].touched);
            for (std::size_t level = 0; level < levels.count; ++level) {
                std::ranges::fill(shares.inLeaf[row][level], cases[row].shares[level]);
                std::ranges::fill(shares.bare[row][level], cases[row].shares[level]);
            }
        }
    }
    bool find() {
        return findDark(levels, shares, computed.data(), 0.5F, inLeaf.data(), bare.data(), anyBare);
    }
};

TEST(FindDark, MarksLevelsAndWhereTheShareIsReachedBetweenThem) {
    const auto scene = std::make_unique<DarkScene>(darkCases());
    EXPECT_TRUE(scene->find());
    EXPECT_FALSE(scene->anyBare) << "no sun is out of season";
    for (std::size_t row = 0; row < CrownDepths::side; ++row)
        for (std::size_t cell = 0; cell < CrownDepths::side; ++cell) {
            const std::size_t at = row * CrownDepths::side + cell;
            EXPECT_EQ(scene->inLeaf[at], row < darkCases().size() ? darkCases()[row].dark : 0)
                << (row < darkCases().size() ? darkCases()[row].what : "no case");
            EXPECT_EQ(scene->bare[at], 0U);
        }
    for (const std::size_t row : {3U, 8U})
        EXPECT_FALSE(std::make_unique<DarkScene>(std::span(&darkCases()[row], 1))->find());
}

TEST(FindDark, KeepsCellsOfARowApart) {
    const auto scene = std::make_unique<DarkScene>(std::span(darkCases()).first(1));
    for (std::size_t cell = 0; cell < CrownDepths::side; ++cell)
        for (std::size_t level = 0; level < scene->levels.count; ++level)
            scene->shares.inLeaf[0][level][cell] = darkCases()[cell % 5].shares[level];
    EXPECT_TRUE(scene->find());
    for (std::size_t cell = 0; cell < CrownDepths::side; ++cell)
        EXPECT_EQ(scene->inLeaf[cell], darkCases()[cell % 5].dark) << cell;
}

// Suns of two levels are out of season: the others count as the lower one of the two.
TEST(FindDark, OutOfSeasonKnowsTheLevelsThatHaveSuns) {
    const DarkCase falling{"", {9, 1, 9, 9, 0, 9}, 0x3f, 0x3f, 0x8'000f};
    const auto scene = std::make_unique<DarkScene>(std::span(&falling, 1));
    scene->levels.bare[1] = 2;
    scene->levels.bare[4] = 1;
    scene->find();
    EXPECT_TRUE(scene->anyBare);
    for (std::size_t cell = 0; cell < CrownDepths::side; ++cell)
        EXPECT_EQ(scene->bare[cell], falling.dark) << cell;
}

// Of random marks of 64 cells, the spans as they follow from the words of DarkLevels: also beyond the four
// changes whose place is kept.
TEST(DarkSpans, HideWhatTheMarksOfTheirLevelsSay) {
    constexpr HorizonCode none = std::numeric_limits<HorizonCode>::max();
    CrownLevels levels;
    levels.count = 12;
    for (std::size_t i = 0; i < levels.count; ++i) levels.meanCode[i] = HorizonCode(1000 + 90 * i * (i + 1));
    std::mt19937 random(7);
    alignas(64) std::array<DarkLevels, lanesOfDark> dark;
    alignas(64) std::array<HorizonCode, lanesOfDark> horizons;
    for (DarkLevels& marks : dark) marks = DarkLevels(random()) & ~(0xfU << levels.count);
    for (HorizonCode& horizon : horizons) horizon = HorizonCode(random() % 20000);
    const auto marks = dark;
    std::array<unsigned, lanesOfDark> changes{};
    unsigned most = 0;
    for (std::size_t span = 0; span < levels.spans(); ++span) {
        DarkSpan made;
        makeDarkSpan(levels, span, horizons.data(), dark.data(), made);
        const std::size_t lower = span == 0 ? 0 : span - 1, upper = std::min(span, levels.count - 1);
        const int width = levels.meanCode[upper] - levels.meanCode[lower];
        for (std::size_t lane = 0; lane < lanesOfDark; ++lane) {
            const bool low = (marks[lane] >> lower & 1U) != 0, high = (marks[lane] >> upper & 1U) != 0;
            const unsigned change = low == high ? 0 : changes[lane]++;
            const int sixteenths = change < 4 ? int(marks[lane] >> (16 + 4 * change) & 15U) : 8;
            const int reached = levels.meanCode[lower] + std::max(width * (2 * sixteenths + 1) / 32, 1);
            const int horizon = horizons[lane];
            EXPECT_EQ(made.below[lane], !low ? horizon : high ? int(none) : std::max(horizon, reached));
            EXPECT_EQ(made.above[lane], !low && high ? reached - 1 : int(none));
            most = std::max(most, changes[lane]);
        }
    }
    EXPECT_GT(most, 5U);
}

}  // namespace
}  // namespace noonmark
