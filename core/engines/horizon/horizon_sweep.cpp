#include "core/engines/horizon/horizon_sweep.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/progress.h"
#include "core/describe/field_values.h"
#include "core/describe/text.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/horizon/attribution/horizon_breakdown.h"
#include "core/engines/horizon/counting/longest_runs.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/sweep/period_sweep.h"
#include "core/engines/horizon/trees/crown_sweep.h"

namespace noonmark {

namespace {

Value countsRuns(const HorizonSweepSettings& settings) {
    return settings.counts == ShadowCounts::grossAndRuns;
}

Result<void> countRuns(HorizonSweepSettings& settings, const Value& value) {
    settings.counts = value == Value(true) ? ShadowCounts::grossAndRuns : ShadowCounts::gross;
    return {};
}

}  // namespace

const Fields<HorizonSweepSettings>& sweepFields() {
    static const Fields<HorizonSweepSettings> fields{
        field(&HorizonSweepSettings::errorTargetPercent,
              {.key = "error",
               .label = NM_TEXT("Error target"),
               .help = NM_TEXT("Target for the mean error of a cell's gross shadow, of the period. Halving "
                               "it doubles the time of a run"),
               .unit = "%",
               .range = ValueRange{0.005, 1}}),
        field(&HorizonSweepSettings::binDeg,
              {.key = "bin",
               .label = NM_TEXT("Azimuth bin"),
               .help = NM_TEXT("Suns whose azimuth is less than this apart share one horizon; 0: as the "
                               "error target asks"),
               .unit = "deg",
               .range = ValueRange{0, HorizonSweepSettings::maxBinDeg},
               .whenEmpty = NM_TEXT("automatic")}),
        derivedField<HorizonSweepSettings>(
            ValueKind::yesNo, countsRuns, countRuns,
            {.key = "runs",
             .label = NM_TEXT("Continuous shadow"),
             .help = NM_TEXT("The longest unbroken shadow is counted too; without it, gross shadow only, in "
                             "about half the time")}),
        field(
            &HorizonSweepSettings::checksRuns,
            {.key = "check",
             .label = NM_TEXT("Check runs"),
             .help = NM_TEXT("Rays look at every step of every longest run, so that a gap between two "
                             "walls in one line is "
                             "found too; without it, they look at what neighbouring bins leave in doubt")})};
    return fields;
}

namespace {
constexpr std::uint32_t maxStepsADay = 32'767;  // runs are counted in 16 bits
}

Result<void> checkBinWidth(double binDeg) {
    if (binDeg >= HorizonSweepSettings::minBinDeg && binDeg <= HorizonSweepSettings::maxBinDeg) return {};
    return failure(fmt::format("An azimuth bin of {} deg is out of range", binDeg), "bin width",
                   fmt::format("Choose {:g} to {:g} deg", HorizonSweepSettings::minBinDeg,
                               HorizonSweepSettings::maxBinDeg));
}

Result<void> checkSweepSettings(const HorizonSweepSettings& settings) {
    if (settings.binDeg != 0) return checkBinWidth(settings.binDeg);
    return checkRanges(sweepFields().of(settings));
}

Result<void> checkHorizonDays(const SunSteps& sun) {
    for (const SunDay& day : sun.days)
        if (day.count > maxStepsADay)
            return failure(fmt::format("A day of {} steps is more than the horizon sweep counts", day.count),
                           "step", NM_TEXT("Choose a step of 3 seconds or more"));
    return {};
}

namespace {

void addDecided(const RunRays& rays, const Receivers& receivers, ShadowField& field) {
    field.cost.rays += rays.rays();
    if (rays.receivers() == 0) return;
    field.engine += fmt::format("; the longest run of {} of {} receivers decided by rays", rays.receivers(),
                                receivers.cells.size());
}

// At most the sunlit time, as in addTakenMinutes() (core/engines/shade_trees.cpp).
void addTakenSteps(const ShadowField& without, const std::vector<std::uint32_t>& cells,
                   const std::vector<double>& steps, const std::vector<std::int16_t>& runs,
                   ShadowField& column) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double minutes =
            double(without.grossMin[cells[i]]) + steps[i] * without.stepMinutes / without.days;
        column.grossMin[cells[i]] = float(std::min(minutes, without.sunlitMinutesPerDay));
        if (!runs.empty()) column.continuousMin[cells[i]] = float(runs[cells[i]] * without.stepMinutes);
    }
    if (runs.empty()) std::ranges::fill(column.continuousMin, std::numeric_limits<float>::quiet_NaN());
}

std::string describeCrowns(bool countsRuns) {
    return fmt::format(
        "Horizon sweep: the length of each path through each crown at up to {} altitudes in each azimuth "
        "bin{}",
        CrownSweep::maxLevels, countsRuns ? "" : "; longest runs are not counted");
}

std::shared_ptr<const TreeShade> addTaken(const ShadowField& without, const Receivers& receivers,
                                          const PeriodSweep::TakenSteps& taken, std::size_t trees) {
    TreeShade shade = makeTreeShade(without, trees);
    addTakenSteps(without, receivers.cells, taken.evergreen.front(), taken.evergreenRuns, *shade.evergreen);
    addTakenSteps(without, receivers.cells, taken.seasonal.front(), taken.seasonalRuns, *shade.seasonal);
    shade.how = describeCrowns(!taken.seasonalRuns.empty());
    return std::make_shared<const TreeShade>(std::move(shade));
}

Result<ShadowField> sweepHorizons(const City& city, const Receivers& receivers, const SunSteps& sun,
                                  const HorizonSweepSettings& settings, Progress& progress,
                                  const std::stop_token& stop) {
    ShadowField field = makeBlankField(receivers, sun);
    if (settings.counts == ShadowCounts::gross)
        std::ranges::fill(field.continuousMin, std::numeric_limits<float>::quiet_NaN());
    const Stopwatch watch;
    const std::vector<std::uint32_t> used = findBuildingsInReach(city, receivers, sun, field.cost);
    OverhangParts overhangs;
    const WallList walls = collectStandingObstacles(city, used, receivers, overhangs);
    const auto overhanging = makeOverhangShapes(overhangs, receivers.grid, walls.datumM);
    if (!overhanging) return tl::make_unexpected(overhanging.error());
    const BinnedSun binned = binSun(sun, settings);
    field.engine = fmt::format(
        "Horizon sweep: the slope of each receiver's horizon in {}, every step of every day counted{}",
        formatText(binned), settings.counts == ShadowCounts::gross ? ", gross shadow only" : "");
    std::optional<RunRays> rays;
    if (settings.counts == ShadowCounts::grossAndRuns) {
        auto made = RunRays::over(city, used, receivers, sun, settings.checksRuns, stop);
        if (!made) return tl::make_unexpected(made.error());
        rays.emplace(*std::move(made));
    }
    const CrownScene crowns = findCrowns(city, receivers, sun);
    std::optional<CrownSweep> crownSweep;
    PeriodSweep sweep(walls, *overhanging, receivers, sun, binned, settings.counts, rays ? &*rays : nullptr,
                      progress, stop);
    if (!crowns.empty() && crowns.phases.empty())
        crownSweep.emplace(crowns, binned, makeOneSet(sun), receivers.grid, walls.datumM,
                           CrownSweep::widestGroupDeg(settings.counts));
    if (crownSweep) sweep.weigh(&*crownSweep, crowns.inLeaf);
    field.cost.seconds["build"] = watch.seconds();
    if (const auto done = sweep.run(field); !done) return tl::make_unexpected(done.error());
    field.cost.skipped["prisms and solids whose shadow cannot reach a tile (each x azimuth bins)"] =
        sweep.outOfReach();
    if (rays) addDecided(*rays, receivers, field);
    if (crownSweep) field.trees = addTaken(field, receivers, sweep.takenSteps(), crowns.crowns.size());
    progress.report(1, NM_TEXT("sweeping horizons"));
    return field;
}

std::vector<std::vector<float>> toMinutes(const std::vector<std::vector<double>>& steps, double stepMinutes) {
    std::vector<std::vector<float>> minutes;
    for (const std::vector<double>& ofSet : steps)
        for (auto& own = minutes.emplace_back(); const double one : ofSet)
            own.push_back(float(one * stepMinutes));
    return minutes;
}

}  // namespace

// Of a receiver a ray to a step takes as long as some bins of azimuth.
bool areRaysQuicker(const SunSteps& sun) {
    constexpr std::size_t binsOfRay = 4;
    return binsOfRay * sun.steps.size() <= binCount(sun, HorizonSweepSettings());
}

namespace {

/// A period's steps of one leaf phase.
struct PhaseSteps {
    SunSteps sun;
    StepSets sets;
    CrownScene crowns;  ///< whose depth out of season is that in the phase
};

PhaseSteps selectPhase(std::size_t phase, const CrownScene& crowns, const SunSteps& sun,
                       const StepSets& sets) {
    const StepSets phases{{}, crowns.phases.ofStep};
    PhaseSteps own{phases.stepsOf(phase, sun), {sets.names, {}}, {crowns.crowns, crowns.trees}};
    for (std::size_t step = 0; step < sun.steps.size(); ++step)
        if (phases.ofStep[step] == phase) own.sets.ofStep.push_back(sets.ofStep[step]);
    own.crowns.inLeaf.assign(own.sun.steps.size(), 0);
    for (Crown& crown : own.crowns.crowns) crown.leafOffPerM = crowns.phases.perM(phase, crown);
    return own;
}

SweptRuns listRuns(const ShadowField& without, const PeriodSweep::TakenSteps& taken,
                   const Receivers& receivers) {
    SweptRuns runs;
    for (const std::uint32_t cell : receivers.cells) {
        runs.without.push_back(without.continuousMin[cell]);
        runs.evergreen.push_back(float(taken.evergreenRuns[cell] * without.stepMinutes));
        runs.seasonal.push_back(float(taken.seasonalRuns[cell] * without.stepMinutes));
    }
    return runs;
}

void keepLonger(std::vector<float>& longest, const std::vector<float>& more) {
    longest.resize(more.size());
    std::ranges::transform(longest, more, longest.begin(),
                           [](float one, float other) { return std::max(one, other); });
}

// Runs are of single days, and days of single phases.
void keepLonger(SweptRuns& longest, const SweptRuns& more) {
    keepLonger(longest.without, more.without);
    keepLonger(longest.evergreen, more.evergreen);
    keepLonger(longest.seasonal, more.seasonal);
}

void addMinutes(std::vector<std::vector<float>>& sum, const std::vector<std::vector<float>>& more) {
    if (sum.empty()) sum.resize(more.size());
    for (std::size_t set = 0; set < more.size(); ++set) {
        sum[set].resize(more[set].size());
        for (std::size_t i = 0; i < more[set].size(); ++i) sum[set][i] += more[set][i];
    }
}

// One sweep for each phase, which the steps of the others do not enter.
Result<TakenBySet> sweepPhases(const City& city, const CrownScene& crowns, const Receivers& receivers,
                               const SunSteps& sun, const StepSets& sets, Progress& progress,
                               const std::stop_token& stop, ShadowCounts counts) {
    TakenBySet sum{.treesUsed = crowns.crowns.size()};
    for (std::size_t phase = 0; phase < crowns.phases.count(); ++phase) {
        ProgressShare share(progress, phase, crowns.phases.count());
        const PhaseSteps own = selectPhase(phase, crowns, sun, sets);
        auto taken = sweepCrowns(city, own.crowns, receivers, own.sun, own.sets, share, stop, counts);
        if (!taken) return taken;
        keepLonger(sum.runs, taken->runs);
        addMinutes(sum.evergreen, taken->evergreen);
        addMinutes(sum.seasonal, taken->seasonal);
        sum.how = taken->how;
    }
    return sum;
}

}  // namespace

Result<TakenBySet> sweepCrowns(const City& city, const CrownScene& crowns, const Receivers& receivers,
                               const SunSteps& sun, const StepSets& sets, Progress& progress,
                               const std::stop_token& stop, ShadowCounts counts) {
    if (!crowns.phases.empty())
        return sweepPhases(city, crowns, receivers, sun, sets, progress, stop, counts);
    const bool hasRuns = counts == ShadowCounts::grossAndRuns;
    if (hasRuns)
        if (const auto able = checkHorizonDays(sun); !able) return tl::make_unexpected(able.error());
    OverhangParts overhangs;
    const WallList walls =
        collectStandingObstacles(city, findBuildingsInReach(city, receivers, sun), receivers, overhangs);
    const auto overhanging = makeOverhangShapes(overhangs, receivers.grid, walls.datumM);
    if (!overhanging) return tl::make_unexpected(overhanging.error());
    const BinnedSun binned = binSun(sun, HorizonSweepSettings{.counts = counts});
    const CrownSweep crownSweep(crowns, binned, sets, receivers.grid, walls.datumM,
                                CrownSweep::widestGroupDeg(counts));
    ProgressShare whole(progress, 0, 1);  // without the partial results, which know no trees
    PeriodSweep sweep(walls, *overhanging, receivers, sun, binned, counts, nullptr, whole, stop);
    sweep.weigh(&crownSweep, crowns.inLeaf);
    ShadowField field = makeBlankField(receivers, sun);
    if (const auto done = sweep.run(field); !done) return tl::make_unexpected(done.error());
    const PeriodSweep::TakenSteps& taken = sweep.takenSteps();
    TakenBySet found{toMinutes(taken.evergreen, sun.stepMinutes), toMinutes(taken.seasonal, sun.stepMinutes)};
    if (hasRuns) found.runs = listRuns(field, taken, receivers);
    found.treesUsed = crowns.crowns.size();
    found.how = describeCrowns(hasRuns);
    return found;
}

HorizonSweep::HorizonSweep(HorizonSweepSettings settings) : settings_(settings) {}

Result<ShadowField> HorizonSweep::compute(const City& city, const Receivers& receivers, const SunSteps& sun,
                                          Progress& progress, std::stop_token stop) const {
    if (const auto able = checkSweepSettings(settings_); !able) return tl::make_unexpected(able.error());
    if (const auto able = checkHorizonDays(sun); !able) return tl::make_unexpected(able.error());
    return sweepHorizons(city, receivers, sun, settings_, progress, stop);
}

Result<ShadowBreakdown> HorizonSweep::computeBreakdown(const City& city, const Receivers& receivers,
                                                       const SunSteps& sun, const StepSets& sets,
                                                       bool byBuilding, Progress& progress,
                                                       std::stop_token stop) const {
    return computeHorizonBreakdown(city, receivers, sun, sets, {settings_, byBuilding}, progress,
                                   std::move(stop));
}

}  // namespace noonmark
