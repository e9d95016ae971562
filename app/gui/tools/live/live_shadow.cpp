#include "app/gui/tools/live/live_shadow.h"

#include <QObject>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/gui/base/widgets/number_text.h"
#include "core/engines/common/shadow_reach.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/rasterize.h"
#include "core/receivers/roof_receivers.h"

namespace noonmark {

namespace {

QString describeStep(std::size_t steps) {
    return steps == 1 ? QObject::tr("this moment")
                      : QObject::tr("all %1 step(s)", "", pluralNumber(steps)).arg(formatCount(steps));
}

}  // namespace

std::vector<LiveEngine> liveEngines(const City& city, ReceiverPlaces places, std::size_t steps) {
    const bool level = !city.terrain && places == ReceiverPlaces::ground;
    if (!level) return {LiveEngine::horizons};
    if (steps <= LiveLimits::maxSteps) return {LiveEngine::shadows, LiveEngine::horizons};
    return {LiveEngine::horizons, LiveEngine::moments};
}

QString describeExactness(LiveEngine engine, std::size_t counted, std::size_t steps, bool runs) {
    switch (engine) {
        case LiveEngine::shadows:
            return QObject::tr("exact at %1").arg(describeStep(steps));
        case LiveEngine::moments:
            return QObject::tr("exact at %1 of %2 step(s)", "", pluralNumber(steps))
                .arg(formatCount(counted), formatCount(steps));
        case LiveEngine::horizons:
            break;
    }
    const QString words = QObject::tr("%1, within 0.25° of azimuth").arg(describeStep(steps));
    return runs ? words : QObject::tr("%1; continuous shadow follows").arg(words);
}

namespace {

City within(const City& city, const Grid& grid) {
    City some{.frame = city.frame, .terrain = city.terrain, .context = city.context};
    for (const auto& building : city.buildings)
        if (overlaps(bounds(*building), grid)) some.buildings.push_back(building);
    return some;
}

// First and last cell of an interval along one axis, widened by one cell on either side and limited to the
// grid.
std::pair<int, int> cellsOf(double low, double high, double beginM, double cellM, int count) {
    const auto at = [&](double metres) { return std::clamp((metres - beginM) / cellM, -2.0, count + 2.0); };
    return {std::clamp(int(std::floor(at(low))) - 1, 0, count - 1),
            std::clamp(int(std::floor(at(high))) + 1, 0, count - 1)};
}

/// A rectangle of a grid's cells.
struct Patch {
    Grid grid;
    int column = 0, row = 0;  // its first cell in the whole grid
};

std::optional<Patch> patchOf(const Box2& box, const Grid& whole) {
    if (!overlaps(box, whole)) return std::nullopt;
    const auto [west, east] =
        cellsOf(double(box.low.x), double(box.high.x), whole.westM, whole.cellM, whole.columns);
    const auto [south, north] =
        cellsOf(double(box.low.y), double(box.high.y), whole.southM, whole.cellM, whole.rows);
    return Patch{{whole.westM + west * whole.cellM, whole.southM + south * whole.cellM, whole.cellM,
                  east - west + 1, north - south + 1},
                 west,
                 south};
}

// Copies the kind of each cell and the height of roofs. The ground keeps its height, whatever is built on it.
void paste(const Receivers& part, const Patch& patch, Receivers& receivers) {
    for (int row = 0; row < part.grid.rows; ++row)
        for (int column = 0; column < part.grid.columns; ++column) {
            const std::size_t from = part.grid.index(column, row),
                              to = receivers.grid.index(patch.column + column, patch.row + row);
            receivers.kind[to] = part.kind[from];
            if (part.kind[from] == CellKind::roof) receivers.groundM[to] = part.groundM[from];
        }
}

void listReceivers(Receivers& receivers) {
    receivers.cells.clear();
    for (std::size_t cell = 0; cell < receivers.kind.size(); ++cell)
        if (isReceiver(receivers.kind[cell])) receivers.cells.push_back(std::uint32_t(cell));
}

}  // namespace

Result<LiveReceivers> LiveReceivers::of(const City& city, const Region& region,
                                        const ReceiverSettings& settings, const std::stop_token& stop) {
    auto base = placeReceivers(city, region, settings, stop);
    if (!base) return tl::make_unexpected(base.error());
    LiveReceivers made;
    made.near_ = within(city, base->grid);
    made.region_ = region;
    made.places_ = settings.places;
    made.base_ = *std::move(base);
    return made;
}

Receivers LiveReceivers::with(const Shape& shape) const {
    Receivers receivers = base_;
    for (const auto& added : shape) patch(receivers, *added, shape);
    if (!shape.empty()) listReceivers(receivers);
    return receivers;
}

void LiveReceivers::patch(Receivers& receivers, const Building& added, const Shape& shape) const {
    const auto patch = patchOf(bounds(added), receivers.grid);
    if (!patch) return;
    City city = within(near_, patch->grid);
    city.buildings.insert(city.buildings.end(), shape.begin(), shape.end());
    const auto ground = placeReceiversInPart(city, region_, patch->grid);
    if (ground) paste(placeAtHeights(*ground, city, places_), *patch, receivers);  // fails only if stopped
}

namespace {

constexpr int cellsToASide = 400;
constexpr float none = std::numeric_limits<float>::quiet_NaN();

// Moments spread over the days and hours of a long period, as one day.
SunSteps spread(const SunSteps& sun) {
    const std::size_t all = sun.steps.size(), maximum = LiveLimits::sampledMoments;
    SunSteps chosen{.stepMinutes = sun.stepMinutes};
    for (std::size_t k = 0; k < maximum; ++k)
        chosen.steps.push_back(sun.steps[(2 * k + 1) * all / (2 * maximum)]);
    chosen.days.push_back({.count = std::uint32_t(maximum)});
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
    if (!grid || grid->size() > LiveLimits::maxCells) return false;
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
    counted_ = engine == LiveEngine::moments ? LiveLimits::sampledMoments : steps_;
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
