#include "core/describe/text.h"
#include "core/engines/inverse/inverse_accrual_map.h"
#include "core/engines/ray/ray_scene.h"

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

}  // namespace noonmark
