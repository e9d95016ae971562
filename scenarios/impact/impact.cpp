#include "scenarios/impact/impact.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/describe/field_values.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/shade_trees.h"
#include "core/measures/error_sample.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/study_cost.h"
#include "core/study/terrain_coverage.h"

namespace noonmark {

namespace {

/// A city and the field that an engine computed for it.
struct CityField {
    const City& city;
    const ShadowField& field;
};

ComparedCell changeOf(const ComparedCell& before, const ComparedCell& after) {
    return {.centreM = after.centreM,
            .grossMin = after.grossMin - before.grossMin,
            .referenceGrossMin = after.referenceGrossMin - before.referenceGrossMin,
            .continuousMin = after.continuousMin - before.continuousMin,
            .referenceContinuousMin = after.referenceContinuousMin - before.referenceContinuousMin};
}

/// Measures how far the change between two cities by an engine differs from the change by the ray reference,
/// on a sample of the receivers common to both cities. It traces twice the rays of a study's error, so a
/// limited number of rays covers half as many receivers.
Result<SampledError> measureChangeError(const CityField& before, const CityField& after,
                                        const Receivers& receivers, const SunSteps& sun,
                                        const ErrorSampleSettings& settings, Progress& progress,
                                        const std::stop_token& stop) {
    const std::vector<std::uint32_t> cells =
        spreadReceivers(receivers, sampleSize(settings, 2 * sun.steps.size()), settings.seed);
    std::vector<ComparedCell> changes[2];
    for (int i = 0; i < 2; ++i) {
        const auto& [city, field] = i == 0 ? before : after;
        ProgressShare share(progress, std::size_t(i), 2);
        auto compared = compareWithReference(city, receivers, sun, field, cells, share, stop);
        if (!compared) return tl::make_unexpected(compared.error());
        changes[i] = *std::move(compared);
    }
    for (std::size_t i = 0; i < cells.size(); ++i) changes[1][i] = changeOf(changes[0][i], changes[1][i]);
    SampledError error = errorOf(changes[1], after.field.sunlitMinutesPerDay, longestDayMinutes(sun));
    error.ofReceivers = receivers.cells.size();
    error.rays = 2 * cells.size() * sun.steps.size();
    return error;
}

std::vector<float> difference(const std::vector<float>& before, const std::vector<float>& after) {
    std::vector<float> change(before.size());
    for (std::size_t i = 0; i < before.size(); ++i) change[i] = after[i] - before[i];  // NaN stays NaN
    return change;
}

// Indices of the buildings of `after` that `before` does not share.
std::vector<std::size_t> newBuildings(const City& before, const City& after) {
    std::unordered_set<const Building*> known;
    for (const auto& building : before.buildings) known.insert(building.get());
    std::vector<std::size_t> fresh;
    for (std::size_t i = 0; i < after.buildings.size(); ++i)
        if (!known.contains(after.buildings[i].get())) fresh.push_back(i);
    return fresh;
}

// Whether the engine finds the same minutes for a receiver whichever other receivers there are.
bool isIndependent(const EngineList& engines, std::string_view key, bool flat) {
    const EngineEntry* engine = findEngine(engines, key);
    const Independence how = engine == nullptr ? Independence::none : engine->info.capabilities.independence;
    return how == Independence::always || (how == Independence::onLevelGround && flat);
}

// Computes the same study for several cities.
class ImpactRun {
public:
    ImpactRun(const ImpactSettings& settings, const EngineList& engines, Progress& progress,
              std::stop_token stop)
        : settings_(settings), engines_(engines), progress_(progress), stop_(std::move(stop)) {}

    Result<ImpactStudy> run(const City& before, const City& after) {
        const TreeColumns columns = settings_.study.trees;
        return runWith(withTreesFor(before, columns), withTreesFor(after, columns));
    }

private:
    Result<ImpactStudy> runWith(const City& before, const City& after) {
        if (auto ready = prepare(before, after); !ready) return tl::make_unexpected(ready.error());
        auto study = compare(before, after);
        while (auto other = chooseAnother(study, before, after)) {
            choice_ = std::move(other);
            auto moreExact = compare(before, after);
            if (study && !moreExact && !isCancelled(moreExact.error())) {
                study->total.warnings.push_back(
                    {WarningKind::leftOut, "a more exact engine, which failed", moreExact.error().text()});
                return study;
            }
            study = std::move(moreExact);
        }
        return study;
    }

    // Where the choice refused, or its sample is off by more than it aims at.
    [[nodiscard]] std::optional<EngineChoice> chooseAnother(const Result<ImpactStudy>& study,
                                                            const City& before, const City& after) const {
        if (!choice_) return std::nullopt;
        if (!study) return engine_->chooseInstead(*choice_, study.error());
        if (!study->error) return std::nullopt;
        const City* const cities[]{&before, &after};
        return engine_->chooseMoreExact(*choice_, study->error->grossOff(), cities, common_.receivers, sun_);
    }

    Result<ImpactStudy> compare(const City& before, const City& after) {
        done_ = 0;
        const auto fresh = settings_.byBuilding ? newBuildings(before, after) : std::vector<std::size_t>{};
        fields_ = 5 + fresh.size();  // two fields, their trees, their error, and one field per new building
        ImpactStudy study{.sun = sun_, .frame = after.frame};
        auto first = fieldOf(before);
        if (!first) return tl::make_unexpected(first.error());
        auto second = fieldOf(after);
        if (!second) return tl::make_unexpected(second.error());
        study.before = *std::move(first);
        study.after = *std::move(second);
        for (ShadowField* field : {&study.before, &study.after})
            if (field->engineKey.empty()) field->engineKey = settings_.study.engine;
        study.total = computeDifference(study.before, study.after, common_.change);
        if (auto done = addTrees(before, after, study); !done) return tl::make_unexpected(done.error());
        for (const std::size_t i : fresh)
            if (auto added = addBuilding(after, i, study); !added) return tl::make_unexpected(added.error());
        if (auto done = measureError(before, after, study); !done) return tl::make_unexpected(done.error());
        return study;
    }

    Result<void> addTrees(const City& before, const City& after, ImpactStudy& study) {
        bool any = false;
        for (const auto& [city, field] :
             {std::pair(&before, &study.before), std::pair(&after, &study.after)}) {
            ProgressShare share(progress_, done_++, fields_);
            auto shade =
                shadeTrees(*city, common_.receivers, sun_, *field, settings_.study.trees, share, stop_);
            if (!shade) return tl::make_unexpected(shade.error());
            field->trees = *std::move(shade);
            any = any || field->trees;
        }
        for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
            if (any && isAmong(settings_.study.trees, column))
                study.withTrees.push_back(
                    {column, computeDifference(fieldOfColumn(study.before, column),
                                               fieldOfColumn(study.after, column), common_.change)});
        return {};
    }

    // A missing error only adds a warning to the comparison; only a stop request ends it.
    Result<void> measureError(const City& before, const City& after, ImpactStudy& study) {
        const ErrorSampleSettings& sample = settings_.study.errorSample;
        if (sample.receivers == 0 || study.after.engineKey == referenceEngine) return {};
        ProgressShare share(progress_, done_++, fields_);
        return takeError(measureChangeError({before, study.before}, {after, study.after}, common_.receivers,
                                            sun_, sample, share, stop_),
                         study.error, study.total.warnings);
    }

    Result<void> prepare(const City& before, const City& after) {
        const StudySettings& study = settings_.study;
        if (auto ground = checkOnGround(study.receivers.places); !ground) return ground;
        if (auto ranges = checkRanges(impactFields().of(settings_)); !ranges) return ranges;
        if (settings_.thresholdsMin.empty())
            return failure("A comparison counts area above at least one threshold", "threshold",
                           "Give minutes of shadow a day, such as 30");
        auto engine = makeEngine(study.engine, study.engineSettings, engines_);
        if (!engine) return tl::make_unexpected(engine.error());
        engine_ = *std::move(engine);
        if (auto fits = checkMemory(after, study, engines_); !fits) return fits;
        auto common = findCommonReceivers(before, after, study.region, study.receivers, stop_);
        if (!common) return tl::make_unexpected(common.error());
        common_ = *std::move(common);
        if (common_.receivers.cells.empty())
            return failure("No cell of the region is open ground in both cities", study.region.name,
                           "Choose a larger region, or smaller cells");
        return validate(study.period).and_then([&](const Period& period) {
            return computeDaylightSteps(period, makeObserver(after, study), stop_)
                .and_then([&](SunSteps sun) {
                    sun_ = std::move(sun);
                    return checkCoverage(computeTerrainCoverage(after, common_.receivers, sun_),
                                         study.region.name);
                })
                .map([&] { chooseOnce(before, after); });
        });
    }

    // Left to itself, an engine that chooses would choose for every city anew, and the fields would differ by
    // the engines too.
    void chooseOnce(const City& before, const City& after) {
        const City* const cities[]{&before, &after};
        choice_ = engine_->choose(cities, common_.receivers, sun_);
    }

    Result<ShadowField> fieldOf(const City& city) { return fieldOf(city, common_.receivers); }

    Result<ShadowField> fieldOf(const City& city, const Receivers& receivers) {
        ProgressShare share(progress_, done_++, fields_);
        if (choice_) return choice_->accumulate(city, receivers, sun_, share, stop_);
        return engine_->accumulate(city, receivers, sun_, share, stop_);
    }

    Result<void> addBuilding(const City& after, std::size_t i, ImpactStudy& study) {
        City without = after;
        without.trees.reset();  // a building's contribution is that without trees
        without.buildings.erase(without.buildings.begin() + std::ptrdiff_t(i));
        const Building& building = *after.buildings[i];
        auto field = fieldWithout(without, after.buildings[i], study.after);
        if (!field) return tl::make_unexpected(field.error());
        study.byBuilding.push_back(
            {building.sourceId, building.name, computeDifference(*field, study.after, common_.change)});
        return {};
    }

    // Computes only where the building's shadow can fall; elsewhere the field with the building is the same.
    Result<ShadowField> fieldWithout(const City& without, const std::shared_ptr<const Building>& building,
                                     const ShadowField& with) {
        if (!isIndependent(engines_, with.engineKey, common_.receivers.flat())) return fieldOf(without);
        if (!reach_) reach_.emplace(sun_);
        const Receivers reached = findReached({building}, common_.receivers, *reach_);
        if (reached.cells.empty()) {
            ++done_;
            return with;
        }
        auto field = fieldOf(without, reached);
        if (field) fillUnreached(*field, with, common_.receivers);
        return field;
    }

    const ImpactSettings& settings_;
    const EngineList& engines_;
    Progress& progress_;
    std::stop_token stop_;
    std::unique_ptr<Engine> engine_;
    std::optional<EngineChoice> choice_;  // of the engine auto, for all fields
    CommonReceivers common_;
    SunSteps sun_;
    std::optional<ShadowReach> reach_;  // created on first use
    std::size_t fields_ = 2;
    std::size_t done_ = 0;
};

}  // namespace

CellChange compareKinds(CellKind before, CellKind after) {
    if (before == CellKind::outside || after == CellKind::outside) return CellChange::none;
    const bool wasGround = before == CellKind::ground, isGround = after == CellKind::ground;
    if (wasGround == isGround) return CellChange::none;
    return wasGround ? CellChange::becameBuilding : CellChange::becameGround;
}

Result<CommonReceivers> findCommonReceivers(const City& before, const City& after, const Region& region,
                                            const ReceiverSettings& settings, const std::stop_token& stop) {
    return gridOver(region, settings).and_then([&](const Grid& grid) {
        return findCommonReceiversInPart(before, after, region, grid, stop);
    });
}

Result<CommonReceivers> findCommonReceiversInPart(const City& before, const City& after, const Region& region,
                                                  const Grid& part, const std::stop_token& stop) {
    const auto old = placeReceiversInPart(before, region, part, stop);
    if (!old) return tl::make_unexpected(old.error());
    auto made = placeReceiversInPart(after, region, part, stop);
    if (!made) return tl::make_unexpected(made.error());
    CommonReceivers common{*std::move(made), {}};
    common.change.resize(common.receivers.kind.size());
    for (std::size_t i = 0; i < common.change.size(); ++i) {
        common.change[i] = compareKinds(old->kind[i], common.receivers.kind[i]);
        if (common.change[i] == CellChange::becameGround) common.receivers.kind[i] = CellKind::building;
    }
    std::erase_if(common.receivers.cells,
                  [&](std::uint32_t cell) { return common.receivers.kind[cell] != CellKind::ground; });
    return common;
}

Impact computeDifference(const ShadowField& before, const ShadowField& after,
                         std::vector<CellChange> change) {
    Impact impact{.grid = after.grid};
    impact.grossMin = difference(before.grossMin, after.grossMin);
    impact.continuousMin = difference(before.continuousMin, after.continuousMin);
    impact.change = std::move(change);
    impact.sunlitMinutesPerDay = after.sunlitMinutesPerDay;
    impact.stepMinutes = after.stepMinutes;
    impact.waterM2 = findWaterM2(after);
    impact.engine = after.engine;
    impact.warnings = after.warnings;
    return impact;
}

Result<ImpactStudy> runImpact(const City& before, const City& after, const ImpactSettings& settings,
                              Progress& progress, std::stop_token stop, const EngineList& engines) {
    return guardMemory(
        {.what = "this comparison", .advice = "Choose larger cells, a smaller region or fewer steps"},
        [&] { return ImpactRun(settings, engines, progress, std::move(stop)).run(before, after); });
}

}  // namespace noonmark
