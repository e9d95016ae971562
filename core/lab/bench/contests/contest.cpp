#include "core/lab/bench/contests/contest.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/engines/ray/ray_reference.h"
#include "core/lab/bench/bench_report.h"
#include "core/lab/bench/contests/moments.h"

namespace noonmark::bench {

namespace {

double standardOf(const Field& option) { return asNumber(option.standard).value_or(0); }

std::string describeSetting(const Field& option, double value) {
    if (value == standardOf(option)) return {};
    return fmt::format("{} {:g}{}{}", option.key, value, option.unit.empty() ? "" : " ", option.unit);
}

double clampToRange(const Field& option, double value) {
    const ValueRange range = option.range.value_or(ValueRange{0, 1});  // yes or no
    value = std::clamp(value, range.min, range.max);
    return option.kind != ValueKind::number ? std::round(value) : value;
}

void add(StartList& list, const EngineEntry& engine, const EngineSettings& settings, std::string words,
         const EngineList& engines) {
    auto made = makeEngine(engine.info.key, settings, engines);
    if (made)
        list.contestants.push_back({std::string(engine.info.key), std::string(engine.info.name),
                                    std::move(words), std::move(*made)});
    else
        list.absent.push_back(fmt::format("{}: {}", engine.info.key, made.error().text()));
}

void addLadder(StartList& list, const EngineEntry& engine, const Field& option, std::vector<double> values,
               const EngineList& engines) {
    for (double& value : values) value = clampToRange(option, value);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    for (const double value : values)
        add(list, engine, {{std::string(option.key), value}}, describeSetting(option, value), engines);
}

}  // namespace

std::string makeTitle(const Contestant& contestant) {
    return contestant.name + (contestant.setting.empty() ? "" : ", ") + contestant.setting;
}

StartList listDefaultEngines(const EngineList& engines) {
    StartList list;
    for (const EngineEntry& engine : engines) add(list, engine, {}, {}, engines);
    return list;
}

StartList listVariedEngines(const EngineList& engines, const std::vector<double>& factors) {
    StartList list;
    for (const EngineEntry& engine : engines) {
        const std::size_t absent = list.absent.size();
        add(list, engine, {}, {}, engines);
        if (list.absent.size() > absent) continue;
        for (const Field& option : engine.info.options) {
            std::vector<double> values;
            for (const double factor : factors) values.push_back(factor * standardOf(option));
            std::erase_if(values,
                          [&](double value) { return clampToRange(option, value) == standardOf(option); });
            addLadder(list, engine, option, values, engines);
        }
    }
    return list;
}

std::vector<Contestant> listVariants(const EngineList& engines, std::string_view engine,
                                     std::string_view option, const std::vector<double>& values) {
    StartList list;
    if (const EngineEntry* found = findEngine(engines, engine))
        for (const Field& known : found->info.options)
            if (known.key == option) addLadder(list, *found, known, values, engines);
    return list.contestants;
}

FieldError errorOf(const ShadowField& field, const ShadowField& truth, const Receivers& receivers) {
    if (receivers.cells.empty() || !(truth.sunlitMinutesPerDay > 0)) return {};
    const double toPct = 100 / truth.sunlitMinutesPerDay;
    const double count = double(receivers.cells.size());
    FieldError error;
    double balance = 0;
    std::vector<double> differences;
    for (const std::uint32_t cell : receivers.cells) {
        const double difference = toPct * (double(field.grossMin[cell]) - double(truth.grossMin[cell]));
        balance += difference / count;
        error.cellMeanPct += std::abs(difference) / count;
        differences.push_back(std::abs(difference));
    }
    std::ranges::sort(differences);
    error.areaPct = std::abs(balance);
    error.cellP99Pct = differences[(differences.size() - 1) * 99 / 100];
    error.cellMaxPct = differences.back();
    return error;
}

namespace {

/// Runs one contestant through its check and the rounds.
class Runner {
public:
    Runner(const Contestant& contestant, const Scene& scene, const Work& work)
        : contestant_(contestant), scene_(scene), work_(work) {}

    Result<void> check(const Truth& truth, double neverAboveS) {
        if (contestant_.needed) neverAboveS = std::numeric_limits<double>::infinity();
        Deadline deadline(neverAboveS, work_.stop);
        Forecast forecast(deadline, neverAboveS);
        Result<ShadowField> field;
        placing_.peakBytes = measurePeakMemory([&] {
            const Stopwatch watch;
            field = run(forecast, deadline.token());
            first_ = watch.seconds();
        });
        if (work_.stopped()) return cancelled();
        if (field)
            judge(errorOf(*field, truth.field, truth.receivers));
        else if (isCancelled(field.error()))
            refuse(fmt::format("stopped after {:.0f} s: it takes more than {:g} s", first_, neverAboveS),
                   true);
        else
            refuse(field.error().text());
        return {};
    }

    Result<void> round(double onceAboveS) {
        if (!placing_.refusal.empty() || first_ > onceAboveS) return {};
        const Stopwatch watch;
        NoProgress silent;
        const auto field = run(silent, work_.stop);
        if (!field) return tl::make_unexpected(field.error());
        seconds_.push_back(watch.seconds());
        return {};
    }

    Placing placing() && {
        if (placing_.refusal.empty()) {
            if (seconds_.empty()) seconds_.push_back(first_);
            placing_.medianS = computeMoments(seconds_).median;
            placing_.runs = int(seconds_.size());
        }
        return std::move(placing_);
    }

private:
    Result<ShadowField> run(Progress& progress, const std::stop_token& stop) {
        return contestant_.accumulator->accumulate(scene_.city, scene_.receivers, scene_.sun, progress, stop);
    }

    void judge(const FieldError& error) {
        placing_.error = error;
        if (error.cellMeanPct > wrongAbovePct)
            refuse(fmt::format("not timed: cells differ by {:.1f} % of the period on average",
                               error.cellMeanPct));
    }

    void refuse(std::string why, bool tooSlow = false) {
        placing_.refusal = std::move(why);
        placing_.tooSlow = tooSlow;
    }

    const Contestant& contestant_;
    const Scene& scene_;
    const Work& work_;
    Placing placing_;
    double first_ = 0;
    std::vector<double> seconds_;
};

Placing leftOut() { return {.refusal = "left out: there was no time for it", .tooSlow = true}; }

}  // namespace

double measureCost(const Placing& placing) {
    if (placing.tooSlow) return std::numeric_limits<double>::infinity();
    return placing.medianS * (placing.runs > 1 ? 1 + placing.runs : placing.runs);
}

Result<std::vector<Placing>> runContestWithin(double seconds, const std::vector<double>& costs,
                                              const Scene& scene, std::span<const Contestant> contestants,
                                              const Truth& truth, const Extent& extent, const Work& work) {
    const std::vector<bool> fits = canAfford(costs, seconds);
    std::vector<Contestant> starters;
    for (std::size_t i = 0; i < contestants.size(); ++i)
        if (fits[i]) starters.push_back(contestants[i]);
    auto made = runContest(scene, starters, truth, extent, work);
    if (!made) return made;
    std::vector<Placing> placings;
    std::size_t next = 0;
    for (const bool starts : fits) placings.push_back(starts ? std::move((*made)[next++]) : leftOut());
    return placings;
}

Result<std::vector<Placing>> runContest(const Scene& scene, std::span<const Contestant> contestants,
                                        const Truth& truth, const Extent& extent, const Work& work) {
    std::vector<Runner> runners;
    for (const Contestant& contestant : contestants) runners.emplace_back(contestant, scene, work);
    for (Runner& runner : runners)
        if (const auto done = runner.check(truth, extent.neverAboveS); !done)
            return tl::make_unexpected(done.error());
    for (int round = 0; round < extent.runs; ++round)
        for (Runner& runner : runners)
            if (const auto done = runner.round(extent.onceAboveS); !done)
                return tl::make_unexpected(done.error());
    std::vector<Placing> placings;
    for (Runner& runner : runners) placings.push_back(std::move(runner).placing());
    return placings;
}

Result<Truth> computeTruth(const Scene& scene, const Receivers& receivers, const Work& work) {
    NoProgress silent;
    auto field = RayReference().accumulate(scene.city, receivers, scene.sun, silent, work.stop);
    if (!field) return tl::make_unexpected(field.error());
    return Truth{std::move(*field), receivers};
}

double secondsForAll(const Truth& truth, const Receivers& receivers) {
    double all = 0;
    const double share =
        double(receivers.cells.size()) / double(std::max<std::size_t>(1, truth.receivers.cells.size()));
    for (const auto& [stage, seconds] : truth.field.cost.seconds)
        all += seconds * (stage == "trace" ? share : 1);
    return all;
}

}  // namespace noonmark::bench
