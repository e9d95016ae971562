// What trees cost the horizon sweep, and how far it is off: a year of 8 h days at one minute over 800 x 800 m
// in the middle of a city, without trees and with made inventories of 5,000 and 20,000 trees in reach. First
// the sweep's columns are compared with exact rays on a sample of receivers, also where every third tree has
// leaf days of its own, of two kinds; then all are timed in turn.
// "district": 2 x 2 km with 100,000 trees, and with a canopy raster of 1 m of which a quarter is canopy.
// "drag": one of the file's trees among all others follows a hand along 22 m, and the table of the region and
// of squares of 100 m follows it.
//
//     trees_bench FILE.osm.pbf [columns|district|drag] [rounds] [receivers in the sample]
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <random>
#include <string>

#include "app/gui/tools/live/live_trees.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/engines/horizon/trees/crown_sweep.h"
#include "core/engines/ray/ray_reference.h"
#include "core/engines/shade_trees.h"
#include "core/engines/trees/crowns.h"
#include "core/study/study.h"
#include "tests/benchmarks/bench_scene.h"
#include "tests/benchmarks/planted_trees.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

City withOwnLeafDays(City city) {
    Trees trees = *city.trees;
    for (std::size_t i = 0; i < trees.trees.size(); i += 3) {
        trees.trees[i].leafOnDay = i % 2 == 0 ? 90 : 120;
        trees.trees[i].leafOffDay = 290;
    }
    city.trees = std::make_shared<const Trees>(std::move(trees));
    return city;
}

// So many trees whose shadow can reach a receiver, and none else.
City withTreesInReach(const City& city, const Receivers& receivers, const SunSteps& sun, std::size_t count) {
    std::mt19937 random(7);
    const Receivers around = findSquare(city, 1300);
    const City many = withTrees(city, plantOnGround(city, around, 3 * count, random));
    std::vector<Tree> inReach;
    for (const std::uint32_t tree : findCrowns(many, receivers, sun).trees)
        if (inReach.size() < count) inReach.push_back(many.trees->trees[tree]);
    return withTrees(city, std::move(inReach));
}

Receivers sampleOf(Receivers receivers, std::size_t count) {
    std::mt19937 random(11);
    std::shuffle(receivers.cells.begin(), receivers.cells.end(), random);
    receivers.cells.resize(std::min(count, receivers.cells.size()));
    std::ranges::sort(receivers.cells);
    std::ranges::replace(receivers.kind, CellKind::ground, CellKind::outside);
    for (const std::uint32_t cell : receivers.cells) receivers.kind[cell] = CellKind::ground;
    return receivers;
}

ShadowField compute(const Engine& engine, const City& city, const Receivers& receivers, const SunSteps& sun) {
    NoProgress quiet;
    return taken(engine.accumulate(city, receivers, sun, quiet, {}));
}

/// Differences in percent of the sunlit minutes.
struct Errors {
    double mean = 0, p99 = 0, largest = 0;
};

template <class Off>
Errors errorsOf(const Receivers& sample, const Off& offPercent) {
    std::vector<double> off;
    for (const std::uint32_t cell : sample.cells) off.push_back(std::abs(offPercent(cell)));
    std::ranges::sort(off);
    Errors errors{.p99 = off[off.size() * 99 / 100], .largest = off.back()};
    for (const double one : off) errors.mean += one / double(off.size());
    return errors;
}

void print(std::string_view what, const Errors& errors) {
    fmt::print("  {:<44} mean {:.4f} %, 99th percentile {:.3f} %, largest {:.2f} %\n", what, errors.mean,
               errors.p99, errors.largest);
}

// Both columns against rays; false where gross shadow is off by more than 0.1 % in the mean or 1 % in the
// 99th percentile.
bool checkGross(const ShadowField& swept, const ShadowField& traced, const Receivers& sample) {
    const double percent = 100 / traced.sunlitMinutesPerDay;
    bool good = true;
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal}) {
        const ShadowField &found = fieldOfColumn(swept, column), &exact = fieldOfColumn(traced, column);
        const auto grossOff = [&](std::uint32_t cell) {
            return percent * (double(found.grossMin[cell]) - double(exact.grossMin[cell]));
        };
        const auto takenOff = [&](std::uint32_t cell) {
            return grossOff(cell) - percent * (double(swept.grossMin[cell]) - double(traced.grossMin[cell]));
        };
        const std::string name(keyOf<TreeColumns>(treeColumnChoices, column));
        const Errors gross = errorsOf(sample, grossOff);
        print(name + ": gross shadow", gross);
        print(name + ": what trees take", errorsOf(sample, takenOff));
        good = good && gross.mean <= 0.1 && gross.p99 <= 1;
    }
    return good;
}

void compareRuns(std::string_view what, const ShadowField& swept, const ShadowField& traced,
                 const Receivers& sample) {
    const double percent = 100 / traced.sunlitMinutesPerDay;
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal}) {
        const auto &found = fieldOfColumn(swept, column).continuousMin,
                   &exact = fieldOfColumn(traced, column).continuousMin;
        print(fmt::format("{}{}: longest runs", keyOf<TreeColumns>(treeColumnChoices, column), what),
              errorsOf(sample, [&](std::uint32_t cell) {
                  return percent * (double(found[cell]) - double(exact[cell]));
              }));
    }
}

// By the sweep, whatever rays would take.
TakenBySet sweepRuns(const City& city, const Receivers& receivers, const SunSteps& sun) {
    NoProgress quiet;
    return taken(sweepCrowns(city, findCrowns(city, receivers, sun), receivers, sun, makeOneSet(sun), quiet,
                             {}, ShadowCounts::grossAndRuns));
}

void compareOwnLeafDays(const City& city, const Receivers& sample, const SunSteps& sun) {
    ShadowField swept = compute(HorizonSweep(), city, sample, sun);
    TreeShade shade = makeTreeShade(swept, 1);
    addRuns(sweepRuns(city, sample, sun).runs, sample, shade);
    swept.trees = std::make_shared<const TreeShade>(std::move(shade));
    ShadowField traced;
    const Seconds rays = secondsOf([&] { traced = compute(RayReference(), city, sample, sun); });
    fmt::print("  rays: {:.3f} s of processor time for {} receivers\n", rays.processor, sample.cells.size());
    compareRuns(", own leaf days", swept, traced, sample);
}

double medianOf(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

struct Case {
    std::string name;
    City city;
    std::vector<double> gross{}, runs{};
};

void time(std::vector<Case>& cases, const Receivers& receivers, const SunSteps& sun, int rounds) {
    const HorizonSweep gross({.counts = ShadowCounts::gross}), runs;
    for (int round = 0; round < rounds; ++round)
        for (Case& one : cases) {
            one.gross.push_back(secondsOf([&] { compute(gross, one.city, receivers, sun); }).processor);
            one.runs.push_back(secondsOf([&] { compute(runs, one.city, receivers, sun); }).processor);
        }
    for (const Case& one : cases)
        fmt::print("{:<14} gross {:6.2f} s ({:.2f} x), with longest runs {:6.2f} s ({:.2f} x)\n", one.name,
                   medianOf(one.gross), medianOf(one.gross) / medianOf(cases[0].gross), medianOf(one.runs),
                   medianOf(one.runs) / medianOf(cases[0].runs));
}

int benchColumns(const City& city, int rounds, std::size_t sampleSize) {
    const Receivers receivers = findSquare(city, 800), sample = sampleOf(receivers, sampleSize);
    const SunSteps sun = workingYearOf(city);
    std::vector<Case> cases{{"without", city}};
    bool good = true;
    for (const std::size_t count : {std::size_t{5'000}, std::size_t{20'000}}) {
        const City planted = withTreesInReach(city, receivers, sun, count);
        cases.push_back({fmt::format("{} trees", count), planted});
        const ShadowField swept =
            compute(HorizonSweep({.counts = ShadowCounts::gross}), planted, receivers, sun);
        const ShadowField traced = compute(RayReference(), planted, sample, sun);
        fmt::print("{} trees in reach of {} receivers, {} steps; {} receivers by rays\n",
                   swept.trees->treesUsed, receivers.cells.size(), sun.steps.size(), sample.cells.size());
        good = checkGross(swept, traced, sample) && good;
        compareRuns("", compute(HorizonSweep(), planted, sample, sun), traced, sample);
        compareOwnLeafDays(withOwnLeafDays(planted), sample, sun);
    }
    time(cases, receivers, sun, rounds);
    const City own = withOwnLeafDays(cases[1].city);
    const Seconds phases = secondsOf([&] { sweepRuns(own, receivers, sun); });
    fmt::print("{}, own leaf days: {} phases beside it, {:.2f} s\n", cases[1].name,
               findCrowns(own, receivers, sun).phases.count(), phases.processor);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

// A quarter of the square's open cells, in groves of some 10 m; heights change smoothly.
std::vector<Tree> makeCanopy(const City& city, const Receivers& square) {
    std::vector<Tree> cells;
    for (const std::uint32_t cell : square.cells) {
        const glm::dvec2 place(square.position(cell));
        const double wave = std::sin(place.x / 9) * std::sin(place.y / 11) + 0.3 * std::sin(place.x / 3.1);
        if (wave < 0.42) continue;
        Tree tree = completeTree({.sourceId = "canopy", .heightM = 4 + 12 * wave, .canopyCellM2 = 1});
        tree.place = place;
        tree.groundM = groundAt(city, place);
        cells.push_back(std::move(tree));
    }
    return cells;
}

double peakGiB() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / (1U << 20U);
}

bool measureDistrict(std::string_view name, const City& city, const Receivers& square,
                     const Receivers& sample, const SunSteps& sun) {
    ShadowField swept;
    const Seconds seconds =
        secondsOf([&] { swept = compute(HorizonSweep({.counts = ShadowCounts::gross}), city, square, sun); });
    fmt::print(
        "{}: {} of {} in reach of {} receivers: {:.1f} s, {:.1f} s of processor time, peak {:.2f} GiB\n",
        name, swept.trees->treesUsed, city.trees->trees.size(), square.cells.size(), seconds.wall,
        seconds.processor, peakGiB());
    return checkGross(swept, compute(RayReference(), city, sample, sun), sample);
}

int benchDistrict(const City& city, std::size_t sampleSize) {
    const Receivers square = findSquare(city, 2000), sample = sampleOf(square, sampleSize);
    const SunSteps sun = workingYearOf(city);
    std::mt19937 random(7);
    bool good = measureDistrict("trees", withTrees(city, plantOnGround(city, square, 100'000, random)),
                                square, sample, sun);
    good = measureDistrict("canopy", withTrees(city, makeCanopy(city, square)), square, sample, sun) && good;
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

const Tree& findMiddleTree(const City& city) {
    const Box2 box = bounds(city);
    const glm::dvec2 middle((box.low + box.high) * 0.5F);
    return *std::ranges::min_element(city.trees->trees, {}, [&](const Tree& tree) {
        return std::hypot(tree.place.x - middle.x, tree.place.y - middle.y);
    });
}

std::shared_ptr<const Study> studyAround(const City& city, glm::vec2 middle, float sideM, int days,
                                         double stepMinutes) {
    const glm::vec2 half(sideM / 2);
    StudySettings settings;
    settings.region = makeRegionFromLocalBox({middle - half, middle + half});
    settings.receivers.cellM = 1;
    settings.engine = "horizon";
    settings.engineSettings = {{"runs", 0}};
    settings.period.start = std::chrono::year(2026) / 3 / 21;
    settings.period.days = days;
    settings.period.hours = 8;
    settings.period.stepMinutes = stepMinutes;
    settings.errorSample.receivers = 0;
    NoProgress quiet;
    return std::make_shared<const Study>(taken(runStudy(city, settings, quiet, {})));
}

std::vector<GridPlace> cutIntoSquares(const Receivers& receivers) {
    constexpr int sideCells = 100;
    std::map<std::pair<int, int>, GridPlace> squares;
    for (const std::uint32_t cell : receivers.cells)
        squares[{int(cell) / receivers.grid.columns / sideCells,
                 int(cell) % receivers.grid.columns / sideCells}]
            .cells.push_back(cell);
    std::vector<GridPlace> places;
    for (auto& [at, place] : squares) places.push_back(std::move(place));
    return places;
}

void print(std::string_view what, const std::vector<double>& seconds) {
    const double mean = std::accumulate(seconds.begin(), seconds.end(), 0.0) / double(seconds.size());
    fmt::print("    {:<28} mean {:5.2f} ms, worst {:5.2f} ms\n", what, 1e3 * mean,
               1e3 * *std::ranges::max_element(seconds));
}

// Processor time of all cores together, for each of 40 places of the tree.
void drag(LiveTreeShade& live, const Study& study, std::string_view round) {
    constexpr int places = 40;
    constexpr double wayM = 22;
    const std::vector<GridPlace> squares = cutIntoSquares(study.receivers);
    std::vector<double> field, table;
    for (int i = 0; i < places; ++i) {
        ShadowField now;
        field.push_back(secondsOf([&] {
                            now = live.with({.byM = {wayM * i / (places - 1), 0}, .planted = {}});
                        }).processor);
        table.push_back(
            secondsOf([&] { comparePlaces(study.receivers, squares, live.before(), now); }).processor);
    }
    std::vector<double> both;
    std::ranges::transform(field, table, std::back_inserter(both), std::plus());
    fmt::print("  {}, {} places\n", round, squares.size());
    print("shade", field);
    print("table", table);
    print("both", both);
}

int benchDrag(const City& city) {
    if (!city.trees || city.trees->trees.empty()) return EXIT_FAILURE;
    const Tree& tree = findMiddleTree(city);
    for (const float sideM : {400.0F, 800.0F})
        for (const auto& [days, stepMinutes] : {std::pair(1, 1.0), std::pair(365, 30.0)}) {
            const auto study = studyAround(city, glm::vec2(tree.place), sideM, days, stepMinutes);
            const auto live = taken(LiveTreeShade::of(study, {.moved = {tree.sourceId}, .planted = {}}, {}));
            fmt::print("{} m, {} days: one of {} trees, {} receivers, {} patches\n", sideM, days,
                       city.trees->trees.size(), study->receivers.cells.size(), live->patches());
            drag(*live, *study, "the first time");
            drag(*live, *study, "again");
        }
    return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
    chooseInstructionSet();
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    if (argc < 2) return EXIT_FAILURE;
    City city = cityFrom(argv[1]);
    const std::string what = argc > 2 ? argv[2] : "columns";
    if (what == "drag") return benchDrag(city);
    city.trees.reset();
    const int rounds = argc > 3 ? std::stoi(argv[3]) : 3;
    const std::size_t sample = argc > 4 ? std::stoul(argv[4]) : 500;
    if (what == "district") return benchDistrict(city, sample);
    return benchColumns(city, rounds, sample);
}
