#include "core/lab/bench/contests/contest.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/lab/graph/graph_engine.h"
#include "core/lab/inverse/inverse_accrual_map.h"

namespace noonmark::bench {

namespace {

/// A contestant's times over shorter periods, to predict longer ones.
class History {
public:
    void add(int days, double seconds) { periods_.push_back({days, seconds}); }

    /// Predicted seconds over `days`, if time has grown almost in proportion so far, over a range of at least
    /// ten times the days; 0: unknown.
    [[nodiscard]] double expected(int days) const {
        if (periods_.empty() || periods_.back().days < 10 * periods_.front().days) return 0;
        const Period& last = periods_.back();
        return growth(periods_.front(), last) > 0.75 ? last.seconds * days / last.days : 0;
    }

private:
    struct Period {
        int days = 1;
        double seconds = 0;
    };

    /// 1: in proportion to the days; 0: not at all.
    static double growth(const Period& from, const Period& to) {
        return std::log(to.seconds / from.seconds) / std::log(double(to.days) / from.days);
    }

    std::vector<Period> periods_;
};

constexpr const char* rayKey = "ray";
constexpr const char* neededTitle = "Inverse accrual map";  // year_graph_speedup needs its time
constexpr double endless = std::numeric_limits<double>::infinity();

/// Adds the inverse accrual map as the paper's brute force: every hour of every day is computed.
void addWithoutGraph(StartList& list) {
    const auto standard = std::ranges::find(list.contestants, "iam", &Contestant::engine);
    const auto map = InverseAccrualMap::make({});
    if (standard == list.contestants.end() || !map) return;
    list.contestants.push_back({"iam", standard->name, withoutGraph,
                                std::make_shared<GraphEngine>(*map, DirectionGraphSettings{.merge = false})});
}

std::string nameOf(int days) {
    return days == 1 ? "a day" : days == 30 ? "a month" : days == 365 ? "a year" : "";
}

bool isDefault(const Contestant& contestant) {
    return contestant.setting.empty() || contestant.setting == withoutGraph;
}

/// A period and the data of its contests.
struct Arena {
    PeriodRun run;
    SunSteps sun;
    Truth truth;
};

/// Runs contests over one period after the other, shortest first.
class Series {
public:
    Series(const BenchSite& site, const Receivers& receivers, const Extent& extent, const Work& work)
        : site_(site), receivers_(receivers), extent_(extent), work_(work) {}

    /// Runs the contest of the default settings, all of which are wanted.
    Result<void> competeDefaults(Arena& arena) {
        PeriodRun& period = arena.run;
        std::vector<std::size_t> starters;
        for (std::size_t i = 0; i < period.contestants.size(); ++i) {
            if (!isDefault(period.contestants[i])) continue;
            if (period.contestants[i].engine == rayKey && period.days > 1)
                period.placings[i] = rayPlacing(arena.truth);
            else if (std::string why = whyNot(period.contestants[i], period); !why.empty())
                period.placings[i] = {.refusal = std::move(why), .tooSlow = true};
            else
                starters.push_back(i);
        }
        return compete(arena, starters, endless, std::vector<double>(starters.size(), 0));
    }

    /// Runs the contest of as many other settings as take less than `seconds`.
    Result<void> competeVaried(Arena& arena, double seconds) {
        PeriodRun& period = arena.run;
        std::vector<std::size_t> places;
        std::vector<double> costs;
        for (std::size_t i = 0; i < period.contestants.size(); ++i) {
            if (isDefault(period.contestants[i])) continue;
            if (const Placing* standard = defaultOf(period, i); standard && standard->timed()) {
                places.push_back(i);
                costs.push_back(expected(*standard));
            } else {
                period.placings[i] = {.refusal = "left out: the usual settings take too long, or are refused",
                                      .tooSlow = true};
            }
        }
        return compete(arena, places, seconds, costs);
    }

private:
    Result<void> compete(Arena& arena, const std::vector<std::size_t>& places, double seconds,
                         const std::vector<double>& costs) {
        std::vector<Contestant> starters;
        for (const std::size_t place : places) starters.push_back(arena.run.contestants[place]);
        auto placings = runContestWithin(seconds, costs, {site_.city, receivers_, arena.sun}, starters,
                                         arena.truth, extent_, work_);
        if (!placings) return tl::make_unexpected(placings.error());
        for (std::size_t k = 0; k < places.size(); ++k)
            arena.run.placings[places[k]] = noted(std::move((*placings)[k]), starters[k], arena.run);
        return {};
    }

    /// Why a contestant does not take part; empty if it does.
    [[nodiscard]] std::string whyNot(const Contestant& contestant, const PeriodRun& period) {
        const std::string title = makeTitle(contestant);
        if (slow_.contains(title)) return "left out: too slow over fewer days";
        if (const double seconds = history_[title].expected(period.days); seconds > extent_.neverAboveS)
            return fmt::format("left out: expected to take some {:.0f} s", seconds);
        return {};
    }

    static const Placing* defaultOf(const PeriodRun& period, std::size_t place) {
        for (std::size_t i = 0; i < period.contestants.size(); ++i)
            if (makeTitle(period.contestants[i]) == period.contestants[place].name)
                return &period.placings[i];
        return nullptr;
    }

    /// Expected time of the check and runs of a setting, from the time of the defaults.
    [[nodiscard]] double expected(const Placing& standard) const {
        return standard.medianS * (standard.medianS > extent_.onceAboveS ? 1 : 1 + extent_.runs);
    }

    Placing noted(Placing placing, const Contestant& contestant, const PeriodRun& period) {
        if (placing.timed() && period.hours > 1)
            history_[makeTitle(contestant)].add(period.days, placing.medianS);
        if (placing.tooSlow) slow_.insert(makeTitle(contestant));
        return placing;
    }

    [[nodiscard]] Placing rayPlacing(const Truth& truth) const {
        return {.medianS = secondsForAll(truth, receivers_), .runs = 1, .estimated = true};
    }

    const BenchSite& site_;
    const Receivers& receivers_;
    const Extent& extent_;
    const Work& work_;
    std::set<std::string> slow_;
    std::map<std::string, History> history_;
};

/// The periods in order.
std::vector<PeriodRun> periodsOf(const Extent& extent) {
    std::vector<PeriodRun> periods{{.name = "an hour", .hours = 1}};
    for (const int days : extent.dayCounts) periods.push_back({.name = nameOf(days), .days = days});
    return periods;
}

Result<Arena> arenaOf(PeriodRun run, const BenchSite& site, const Receivers& receivers, const Extent& extent,
                      const StartList& engines, const Work& work) {
    run.contestants = engines.contestants;
    run.placings.resize(run.contestants.size());
    auto sun = run.hours == 1 ? makeNoonHour(site) : computeSunOver(site, site.date, run.days);
    if (!sun) return tl::make_unexpected(sun.error());
    const Receivers watched =
        run.days == 1 ? receivers : sampleOf(receivers, extent.sampleReceivers, site.seed);
    auto truth = computeTruth({site.city, receivers, *sun}, watched, work);
    if (!truth) return tl::make_unexpected(truth.error());
    return Arena{std::move(run), std::move(*sun), std::move(*truth)};
}

// Runs the default settings of all periods first; the remaining time goes to the others.
Result<void> competeOver(std::vector<Arena>& arenas, Series& series, const Work& work) {
    Pieces pieces(work, "periods from an hour to a year, other settings", arenas.size());
    for (std::size_t i = 0; i < arenas.size(); ++i) {
        pieces.next();
        const double share = std::max(0.0, work.allowance.secondsLeft()) / double(arenas.size() - i);
        if (const auto done = series.competeVaried(arenas[i], share); !done) return done;
    }
    return {};
}

}  // namespace

Result<std::vector<PeriodRun>> benchPeriods(const BenchSite& site, const Extent& extent,
                                            const EngineList& engines, const Work& work) {
    const auto receivers = pickMiddleReceivers(site, work.stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    StartList standard = listDefaultEngines(engines), varied = listVariedEngines(engines, extent.factors);
    addWithoutGraph(standard);
    addWithoutGraph(varied);
    for (StartList* list : {&standard, &varied})
        for (Contestant& contestant : list->contestants)
            contestant.needed = makeTitle(contestant) == neededTitle;
    Series series(site, *receivers, extent, work);
    std::vector<Arena> arenas;
    const std::vector<PeriodRun> periods = periodsOf(extent);
    Pieces pieces(work, "periods from an hour to a year", periods.size());
    for (const PeriodRun& period : periods) {
        pieces.next();
        auto arena = arenaOf(period, site, *receivers, extent, period.name.empty() ? standard : varied, work);
        if (!arena) return tl::make_unexpected(arena.error());
        if (const auto done = series.competeDefaults(*arena); !done) return tl::make_unexpected(done.error());
        arenas.push_back(std::move(*arena));
    }
    if (const auto done = competeOver(arenas, series, work); !done) return tl::make_unexpected(done.error());
    std::vector<PeriodRun> runs;
    for (Arena& arena : arenas) runs.push_back(std::move(arena.run));
    return runs;
}

namespace {

constexpr double growth = 3;  // four times the cells, but part of the work does not grow with them
constexpr std::size_t inAnyCase = 2;

// The share of the next run in the remaining time: the last of `runsLeft` runs takes more than all before it.
double shareOfNext(std::size_t runsLeft) { return (growth - 1) / (std::pow(growth, double(runsLeft)) - 1); }

Result<ResolutionRun> runAt(int resolution, const std::vector<double>& costs, double seconds,
                            const BenchSite& site, const Extent& extent, const StartList& engines,
                            const Work& work) {
    const auto receivers = placeReceiversAt(site, resolution, work.stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    const auto sun = makeNoonHour(site);
    if (!sun) return tl::make_unexpected(sun.error());
    const Scene scene{site.city, *receivers, *sun};
    const auto truth = computeTruth(scene, *receivers, work);
    if (!truth) return tl::make_unexpected(truth.error());
    return runContestWithin(seconds, costs, scene, engines.contestants, *truth, extent, work)
        .map([&](std::vector<Placing> placings) {
            return ResolutionRun{resolution, std::move(placings)};
        });
}

}  // namespace

std::string describeResolutionIfCoarser(int finest, double cellsASide) {
    return cellsASide == finest ? "" : fmt::format(" at {:g}", cellsASide);
}

Result<std::vector<ResolutionRun>> benchResolutions(const BenchSite& site, const Extent& extent,
                                                    const StartList& engines, const Work& work) {
    if (extent.resolutions.empty()) return failure("No resolution is possible for a square of this size");
    std::vector<double> costs(engines.contestants.size(), 0);
    std::vector<ResolutionRun> runs;
    Pieces pieces(work, "time and memory by resolution", extent.resolutions.size());
    for (const int resolution : extent.resolutions) {
        pieces.next();
        const double share = shareOfNext(extent.resolutions.size() - runs.size());
        const double left = std::max(0.0, work.allowance.secondsLeft()) * share;
        auto run = runAt(resolution, costs, left, site, extent, engines, work);
        if (!run) return tl::make_unexpected(run.error());
        runs.push_back(std::move(*run));
        for (std::size_t i = 0; i < costs.size(); ++i)
            if (runs.size() >= inAnyCase) costs[i] = growth * measureCost(runs.back().placings[i]);
    }
    return runs;
}

}  // namespace noonmark::bench
