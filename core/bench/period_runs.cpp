#include "core/bench/period_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/accumulate/graph_accumulator.h"
#include "core/accumulate/inverse_accrual_map.h"

namespace noonmark::bench {

namespace {

constexpr const char* rayKey = "ray";

/// The inverse accrual map as the paper's brute force: every hour of every day anew.
void addWithoutGraph(StartList& list) {
    const auto usual = std::ranges::find(list.contestants, "iam", &Contestant::engine);
    const auto map = InverseAccrualMap::make({});
    if (usual == list.contestants.end() || !map) return;
    list.contestants.push_back(
        {"iam", usual->name, withoutGraph,
         std::make_shared<GraphAccumulator>(*map, DirectionGraphSettings{.merge = false})});
}

std::string nameOf(int days) {
    return days == 1 ? "a day" : days == 30 ? "a month" : days == 365 ? "a year" : "";
}

/// What is known of a contestant from shorter periods.
class History {
public:
    void add(int days, double seconds) { periods_.push_back({days, seconds}); }

    /// Seconds over so many days, where the last three periods grew almost in proportion; else 0: who knows.
    [[nodiscard]] double expected(int days) const {
        if (periods_.size() < 3) return 0;
        const Period* last = &periods_.back();
        const bool proportional = growth(last[-2], last[-1]) > 0.75 && growth(last[-1], last[0]) > 0.75;
        return proportional ? last->seconds * days / last->days : 0;
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

/// One period after the other, shortest first.
class Series {
public:
    Series(const BenchSite& site, const Receivers& receivers, const Extent& extent, const Work& work)
        : site_(site), receivers_(receivers), extent_(extent), work_(work) {}

    Result<PeriodRun> run(PeriodRun period, const SunSteps& sun, const StartList& engines) {
        const Scene scene{site_.city, receivers_, sun};
        const auto truth = truthOver(scene, period);
        if (!truth) return tl::make_unexpected(truth.error());
        period.contestants = engines.contestants;
        period.placings.resize(period.contestants.size());
        // The usual settings first: what they take decides about the others.
        for (const bool usual : {true, false})
            if (const auto done = compete(period, usual, scene, *truth); !done)
                return tl::make_unexpected(done.error());
        return period;
    }

private:
    Result<Truth> truthOver(const Scene& scene, const PeriodRun& period) const {
        if (period.days == 1) return truthOf(scene, receivers_, work_);
        return truthOf(scene, sampleOf(receivers_, extent_.sampleReceivers, site_.seed), work_);
    }

    Result<void> compete(PeriodRun& period, bool usual, const Scene& scene, const Truth& truth) {
        std::vector<Contestant> starters;
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < period.contestants.size(); ++i) {
            const Contestant& contestant = period.contestants[i];
            if (contestant.setting.empty() != usual) continue;
            if (contestant.engine == rayKey && period.days > 1) {
                period.placings[i] = rayPlacing(truth);
            } else if (std::string why = whyNot(contestant, period); !why.empty()) {
                period.placings[i] = {.refusal = std::move(why), .tooSlow = true};
            } else {
                starters.push_back(contestant);
                places.push_back(i);
            }
        }
        auto placings = contest(scene, starters, truth, extent_, work_);
        if (!placings) return tl::make_unexpected(placings.error());
        for (std::size_t k = 0; k < places.size(); ++k)
            period.placings[places[k]] = noted(std::move((*placings)[k]), starters[k], period);
        return {};
    }

    /// Why a contestant takes no part; empty if it does.
    [[nodiscard]] std::string whyNot(const Contestant& contestant, const PeriodRun& period) {
        const std::string title = titleOf(contestant);
        if (slow_.contains(title)) return "left out: too slow over fewer days";
        if (const double seconds = history_[title].expected(period.days); seconds > extent_.neverAboveS)
            return fmt::format("left out: some {:.0f} s are expected", seconds);
        if (contestant.setting.empty() || contestant.setting == withoutGraph) return {};
        for (std::size_t i = 0; i < period.contestants.size(); ++i)
            if (titleOf(period.contestants[i]) == contestant.name) return whyNotVaried(period.placings[i]);
        return {};
    }

    [[nodiscard]] std::string whyNotVaried(const Placing& usual) const {
        if (usual.timed() && usual.medianS < extent_.settingsBelowS) return {};
        return "left out: the usual settings take too long, or are refused";
    }

    Placing noted(Placing placing, const Contestant& contestant, const PeriodRun& period) {
        if (placing.timed() && period.hours > 1)
            history_[titleOf(contestant)].add(period.days, placing.medianS);
        if (placing.tooSlow) slow_.insert(titleOf(contestant));
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

/// The periods in their order.
std::vector<PeriodRun> periodsOf(const Extent& extent) {
    std::vector<PeriodRun> periods{{.name = "an hour", .hours = 1}};
    for (const int days : extent.dayCounts) periods.push_back({.name = nameOf(days), .days = days});
    return periods;
}

}  // namespace

Result<std::vector<PeriodRun>> periodRuns(const BenchSite& site, const Extent& extent,
                                          const EngineList& engines, const Work& work) {
    const auto receivers = middleReceivers(site, work.stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    StartList usual = usualEngines(engines), varied = variedEngines(engines, extent.factors);
    addWithoutGraph(usual);
    addWithoutGraph(varied);
    Series series(site, *receivers, extent, work);
    std::vector<PeriodRun> runs = periodsOf(extent);
    Pieces pieces(work, "periods from an hour to a year", runs.size());
    for (PeriodRun& period : runs) {
        pieces.next();
        const auto sun = period.hours == 1 ? noonHour(site) : sunOver(site, site.date, period.days);
        if (!sun) return tl::make_unexpected(sun.error());
        auto run = series.run(period, *sun, period.name.empty() ? usual : varied);
        if (!run) return tl::make_unexpected(run.error());
        period = std::move(*run);
    }
    return runs;
}

}  // namespace noonmark::bench
