#include "app/gui/tools/live/live_shadow.h"

#include <algorithm>
#include <limits>

#include "core/engines/common/shadow_reach.h"
#include "core/measures/has_runs.h"
#include "core/receivers/roof_receivers.h"

namespace noonmark {

namespace {

constexpr int cellsToASide = 400;
constexpr float none = std::numeric_limits<float>::quiet_NaN();

// Moments spread over the days and hours of a long period, as one day.
SunSteps spread(const SunSteps& sun) {
    const std::size_t all = sun.steps.size(), most = LiveRule::someMoments;
    SunSteps chosen{.stepMinutes = sun.stepMinutes};
    for (std::size_t k = 0; k < most; ++k) chosen.steps.push_back(sun.steps[(2 * k + 1) * all / (2 * most)]);
    chosen.days.push_back({.count = std::uint32_t(most)});
    return chosen;
}

// Only what can shade: each picture looks through it.
City keepShading(const City& city, const Receivers& receivers, const SunSteps& sun) {
    City around{.frame = city.frame, .terrain = city.terrain};
    for (const std::uint32_t building : findBuildingsInReach(city, receivers, sun))
        around.buildings.push_back(city.buildings[building]);
    return around;
}

double lowestM(const City& city) {
    if (!city.terrain) return 0;
    return double(*std::ranges::min_element(city.terrain->elevationM));
}

bool suits(const LiveQuestion& question, const LivePlace& place, const SunSteps& sun) {
    if (!question.onRegion || question.region.polygons.empty()) return false;
    const auto grid = gridOver(question.region, question.receivers);
    if (!grid || grid->size() > LiveRule::maxCells) return false;
    return ShadowReach(sun).touches(place.volume.box, double(place.volume.topM) - lowestM(place.rest),
                                    bounds(question.region));
}

// Roof receivers alone would come and go with the shape, and each change would sweep all horizons anew. So
// the ground is computed too, and not shown.
ReceiverSettings makeCacheSettings(ReceiverSettings settings) {
    if (settings.places == ReceiverPlaces::roofs) settings.places = ReceiverPlaces::both;
    return settings;
}

// Where the shadow is measured.
struct LiveArea {
    Region region;
    ReceiverSettings settings;
};

LiveArea chooseArea(const LivePlace& place, const LiveQuestion& question, const SunSteps& sun) {
    LiveArea area{question.region, makeCacheSettings(question.receivers)};
    if (suits(question, place, sun)) return area;
    const glm::vec2 centre = (place.volume.box.low + place.volume.box.high) / 2.0F;
    const auto half = glm::vec2(float(place.halfM));
    area.region = makeRegionFromLocalBox({centre - half, centre + half});
    area.settings.cellM = 2 * place.halfM / cellsToASide;
    return area;
}

}  // namespace

Result<std::shared_ptr<LiveShadow>> LiveShadow::at(LivePlace place, const LiveQuestion& question,
                                                   std::shared_ptr<SharedHorizonCache> horizons,
                                                   Progress& progress, const std::stop_token& stop) {
    const auto sun = computeDaylightSteps(question.sun.period, question.sun.observer, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    const LiveArea area = chooseArea(place, question, *sun);
    auto receivers = LiveReceivers::of(place.rest, area.region, area.settings, stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    std::shared_ptr<LiveShadow> live(
        new LiveShadow(std::move(place.rest), *std::move(receivers), question, std::move(horizons)));
    auto begun = live->begin(*sun, progress, stop);
    if (begun && place.baseline && question.receivers.places != ReceiverPlaces::roofs) {
        auto before = placeReceivers(*place.baseline, area.region, area.settings, stop);
        if (!before) return tl::make_unexpected(before.error());
        live->placeCells_ = findPlaceCells(question.places, before->grid);
        begun = live->addBaseline({*place.baseline, *std::move(before)}, *sun, progress, stop);
    }
    if (!begun) return tl::make_unexpected(begun.error());
    return live;
}

Result<void> LiveShadow::begin(const SunSteps& sun, Progress& progress, const std::stop_token& stop) {
    steps_ = sun.steps.size();
    sunlitMinutesPerDay_ = sun.sunlitMinutes() / double(std::max<std::size_t>(1, sun.dayCount()));
    Result<void> begun;
    for (const LiveEngine engine : liveEngines(city_, places_, steps_)) {
        begun = begin(engine, sun, progress, stop);
        if (begun || isCancelled(begun.error())) break;
    }
    return begun;
}

Result<void> LiveShadow::begin(LiveEngine engine, const SunSteps& sun, Progress& progress,
                               const std::stop_token& stop) {
    engine_ = engine;
    counted_ = engine == LiveEngine::moments ? LiveRule::someMoments : steps_;
    if (engine == LiveEngine::horizons)
        return fieldOf(city_, receivers(), ShadowCounts::gross, progress, stop).map([](const ShadowField&) {
        });
    const SunSteps steps = engine == LiveEngine::moments ? spread(sun) : sun;
    City around = keepShading(city_, receivers(), steps);
    auto cache = ShadowCache::make(around, receivers(), steps, progress, stop);
    if (!cache) return tl::make_unexpected(cache.error());
    city_ = std::move(around);
    shadows_ = std::move(*cache);
    return {};
}

Result<void> LiveShadow::addBaseline(Baseline baseline, const SunSteps& sun, Progress& progress,
                                     const std::stop_token& stop) {
    if (shadows_)
        baseline.city = keepShading(baseline.city, baseline.receivers,
                                    engine_ == LiveEngine::moments ? spread(sun) : sun);
    auto field = fieldOf(baseline.city, baseline.receivers, ShadowCounts::gross, progress, stop);
    if (!field) return tl::make_unexpected(field.error());
    baseline.field = std::make_shared<const ShadowField>(*std::move(field));
    baseline_ = std::move(baseline);
    return {};
}

// Continuous shadow of the baseline, where it costs more, is counted when it is first asked for.
Result<std::shared_ptr<const ShadowField>> LiveShadow::baselineField(ShadowCounts counts, Progress& progress,
                                                                     const std::stop_token& stop) {
    const auto known = [this] {
        const std::lock_guard lock(baselineField_);
        return baseline_->field;
    }();
    const bool countsRuns = engine_ == LiveEngine::horizons && counts == ShadowCounts::grossAndRuns;
    if (!countsRuns || hasRuns(*known)) return known;
    auto field = fieldOf(baseline_->city, baseline_->receivers, counts, progress, stop);
    if (!field) return tl::make_unexpected(field.error());
    const std::lock_guard lock(baselineField_);
    baseline_->field = std::make_shared<const ShadowField>(*std::move(field));
    return baseline_->field;
}

Result<void> LiveShadow::compare(ShadowCounts counts, LiveAnswer& answer, Progress& progress,
                                 const std::stop_token& stop) {
    return baselineField(counts, progress, stop).map([&](const auto& before) {
        answer.change =
            computeLiveChange(baseline_->receivers, *before, answer.receivers, answer.field, placeCells_);
    });
}

Result<LiveAnswer> LiveShadow::with(const LiveReceivers::Shape& shape, ShadowCounts counts,
                                    Progress& progress, const std::stop_token& stop) {
    City city = city_;
    city.buildings.insert(city.buildings.end(), shape.begin(), shape.end());
    LiveAnswer answer{.receivers = receivers_.with(shape),
                      .engine = engine_,
                      .counted = counted_,
                      .steps = steps_,
                      .runs = engine_ == LiveEngine::shadows ||
                              (engine_ == LiveEngine::horizons && counts == ShadowCounts::grossAndRuns)};
    auto field = fieldOf(city, answer.receivers, counts, progress, stop);
    if (!field) return tl::make_unexpected(field.error());
    answer.field = *std::move(field);
    if (baseline_)
        if (const auto done = compare(counts, answer, progress, stop); !done)
            return tl::make_unexpected(done.error());
    if (places_ == ReceiverPlaces::roofs) leaveGroundOut(answer);
    return answer;
}

Result<ShadowField> LiveShadow::fieldOf(const City& city, const Receivers& receivers, ShadowCounts counts,
                                        Progress& progress, const std::stop_token& stop) {
    if (!shadows_) return horizons_->field(city, receivers, sun_, counts, progress, stop);
    if (const auto done = shadows_->change(city, receivers, progress, stop); !done)
        return tl::make_unexpected(done.error());
    ShadowField field = shadows_->field();
    if (engine_ == LiveEngine::moments) spreadMoments(field);
    return field;
}

// Scales the minutes to the whole period. Separate moments have no continuous shadow.
void LiveShadow::spreadMoments(ShadowField& field) const {
    const double minutes = sunlitMinutesPerDay_ / field.sunlitMinutesPerDay;
    for (float& gross : field.grossMin) gross = float(double(gross) * minutes);
    field.sunlitMinutesPerDay = sunlitMinutesPerDay_;
    std::ranges::fill(field.continuousMin, none);
}

void LiveShadow::leaveGroundOut(LiveAnswer& answer) const {
    for (const std::uint32_t cell : answer.receivers.cells) {
        if (answer.receivers.kind[cell] != CellKind::ground) continue;
        answer.receivers.kind[cell] = CellKind::outside;
        answer.field.grossMin[cell] = answer.field.continuousMin[cell] = none;
    }
    std::erase_if(answer.receivers.cells,
                  [&](std::uint32_t cell) { return answer.receivers.kind[cell] == CellKind::outside; });
}

}  // namespace noonmark
