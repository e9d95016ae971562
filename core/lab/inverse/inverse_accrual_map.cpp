#include "core/lab/inverse/inverse_accrual_map.h"

#include <fmt/format.h>
#include <cmath>

#include "core/describe/field_values.h"
#include "core/describe/text.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/ray/ray_scene.h"
#include "core/lab/graph/ray_intervals.h"
#include "core/lab/inverse/shadow_lines_opencl.h"
#include "core/lab/inverse/sources/projected_source_finder.h"
#include "core/lab/inverse/sources/source_finder.h"

namespace noonmark {

namespace {

using Settings = InverseAccrualSettings;

Value findsByRays(const Settings& settings) { return settings.sourceFinder == SourceFinderKind::rays; }

Result<void> findByRays(Settings& settings, const Value& value) {
    settings.sourceFinder = value == Value(true) ? SourceFinderKind::rays : SourceFinderKind::projected;
    return {};
}

constexpr std::int64_t processor = -1;

Value deviceOf(const Settings& settings) { return std::int64_t(settings.openClDevice.value_or(processor)); }

Result<void> setDevice(Settings& settings, const Value& value) {
    const auto device = codecOf<int>().fromValue(value);
    if (!device) return tl::make_unexpected(device.error());
    settings.openClDevice = *device == processor ? std::nullopt : std::optional(*device);
    return {};
}

}  // namespace

const Fields<InverseAccrualSettings>& inverseFields() {
    static const Fields<Settings> fields{
        field(&Settings::levels,
              {.key = "levels",
               .label = NM_TEXT("Source levels"),
               .help = NM_TEXT("How many occluders, nearest first, are followed from each cell"),
               .range = ValueRange{1, RayScene::maxLevels}}),
        field(&Settings::nearestHitM,
              {.key = "nearest",
               .label = NM_TEXT("Nearest hit"),
               .help = NM_TEXT("Occluders nearer to a cell than this are left out (the paper: 1 m)"),
               .unit = "m",
               .range = ValueRange{0.01, 10}}),
        derivedField<Settings>(
            ValueKind::yesNo, findsByRays, findByRays,
            {.key = "rays",
             .label = NM_TEXT("Sources by rays"),
             .help = NM_TEXT("Embree finds the occluders at an interval's ends; otherwise filled polygons "
                             "do, which "
                             "is faster")}),
        derivedField<Settings>(
            ValueKind::whole, deviceOf, setDevice,
            {.key = "device",
             .label = NM_TEXT("OpenCL device"),
             .help = NM_TEXT("Which OpenCL device draws, counted from 0; -1: the processor itself"),
             .range = ValueRange{processor, 63},
             .whenEmpty = NM_TEXT("none: the processor")})};
    return fields;
}

namespace {

Result<void> check(const InverseAccrualSettings& settings) {
    if (auto ranges = checkRanges(inverseFields().of(settings)); !ranges) return ranges;
    if (!(settings.marginM >= 0 && settings.marginM <= 500))
        return failure(fmt::format("A margin of {} m is out of range", settings.marginM), "margin",
                       "Give 0 to 500 m");
    if (!(settings.minSunDeg >= 0 && settings.minSunDeg <= 45))
        return failure(fmt::format("Rays below a sun of {} degrees are out of range", settings.minSunDeg),
                       "lowest sun", "Give 0 to 45 degrees");
    return {};
}

Result<std::unique_ptr<SourceFinder>> finderOver(const City& city, const std::vector<std::uint32_t>& used,
                                                 const Grid& grid, const InverseAccrualSettings& settings,
                                                 std::stop_token stop) {
    const float nearest = settings.nearestHitM;
    if (settings.sourceFinder == SourceFinderKind::projected)
        return std::make_unique<ProjectedSourceFinder>(makeSurfaceFacets(city, used, grid, nearest),
                                                       settings.levels, nearest);
    auto scene = RayScene::over(city, used, std::move(stop));
    if (!scene) return tl::make_unexpected(scene.error());
    return std::make_unique<RaySourceFinder>(std::move(*scene), grid, settings.levels, nearest);
}

}  // namespace

InverseAccrualMap::InverseAccrualMap(InverseAccrualSettings settings) : settings_(settings) {}

Result<std::shared_ptr<const InverseAccrualMap>> InverseAccrualMap::make(
    const InverseAccrualSettings& settings) {
    if (const auto ok = check(settings); !ok) return tl::make_unexpected(ok.error());
    std::shared_ptr<InverseAccrualMap> engine(new InverseAccrualMap(settings));
    engine->drawer_ = makeShadowLineDrawer();
    if (settings.openClDevice) {
        auto drawer = makeOpenClDrawer(*settings.openClDevice);
        if (!drawer) return tl::make_unexpected(drawer.error());
        engine->drawer_ = std::move(*drawer);
    }
    return engine;
}

Result<std::unique_ptr<IntervalScene>> InverseAccrualMap::prepare(const City& city,
                                                                  const Receivers& receivers,
                                                                  const SunSteps& directions,
                                                                  std::stop_token stop) const {
    const LowSun lowSun(settings_.minSunDeg);
    const SunSteps low = lowSun.of(directions, true), high = lowSun.of(directions, false);
    std::unique_ptr<IntervalScene> rays;
    if (!low.steps.empty()) {
        auto scene = RayIntervals().prepare(city, receivers, low, stop);
        if (!scene) return tl::make_unexpected(scene.error());
        rays = std::move(*scene);
    }
    const std::vector<std::uint32_t> used = findBuildingsInReach(city, receivers, high);
    const int margin = int(std::ceil(settings_.marginM / receivers.grid.cellM));
    auto finder = finderOver(city, used, padGrid(receivers.grid, margin), settings_, std::move(stop));
    if (!finder) return tl::make_unexpected(finder.error());
    return makeInverseAccrualScene({.finder = std::move(*finder),
                                    .drawer = drawer_,
                                    .rays = std::move(rays),
                                    .lowSun = lowSun,
                                    .marginCells = margin,
                                    .buildingsUsed = std::uint32_t(used.size())},
                                   receivers);
}

std::string InverseAccrualMap::describe() const {
    return fmt::format(
        "Inverse accrual map, {} levels, {}, sun below {:g} deg by rays, intervals "
        "halved where a check of their middle misses more than {:g} %",
        settings_.levels, drawer_->describe(), settings_.minSunDeg, 100 * maxMissedShare);
}

}  // namespace noonmark
