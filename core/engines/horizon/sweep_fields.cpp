#include "core/describe/text.h"
#include "core/engines/horizon/horizon_sweep.h"

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
               .help = NM_TEXT("Mean error of a cell's gross shadow, of the period: the sweep's azimuth bins "
                               "are as wide as it lets "
                               "them be; half of it takes twice as long"),
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

}  // namespace noonmark
