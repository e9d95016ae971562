#include "core/engines/horizon/sweep_options.h"

#include "core/describe/text.h"

namespace noonmark {

namespace {

EngineOption errorOption() {
    return {"error",
            NM_TEXT("Error target"),
            "%",
            HorizonSweepSettings::minErrorPercent,
            HorizonSweepSettings::maxErrorPercent,
            HorizonSweepSettings{}.errorTargetPercent,
            OptionKind::number,
            NM_TEXT("Mean error of a cell's gross shadow, of the period: the sweep's azimuth bins are as "
                    "wide as it lets "
                    "them be; half of it takes twice as long")};
}

EngineOption binOption() {
    return {
        "bin",
        NM_TEXT("Azimuth bin"),
        "deg",
        0,
        HorizonSweepSettings::maxBinDeg,
        HorizonSweepSettings{}.binDeg,
        OptionKind::number,
        NM_TEXT("Suns whose azimuth is less than this apart share one horizon; 0: as the error target asks")};
}

EngineOption runsOption() {
    return {.key = "runs",
            .name = NM_TEXT("Continuous shadow"),
            .standard = 1,
            .kind = OptionKind::yesNo,
            .about = NM_TEXT(
                "The longest unbroken shadow is counted too; without it, gross shadow only, in about half "
                "the time")};
}

EngineOption checkOption() {
    return {
        .key = "check",
        .name = NM_TEXT("Check runs"),
        .standard = 0,
        .kind = OptionKind::yesNo,
        .about = NM_TEXT(
            "Rays look at every step of every longest run, so that a gap between two walls in one line is "
            "found too; without it, they look at what neighbouring bins leave in doubt")};
}

double valueOf(const EngineSettings& settings, const EngineOption& option) {
    const auto set = settings.find(option.key);
    return set == settings.end() ? option.standard : set->second;
}

}  // namespace

std::vector<EngineOption> sweepOptions() { return {errorOption(), binOption(), runsOption(), checkOption()}; }

HorizonSweepSettings readSweepSettings(const EngineSettings& settings) {
    const bool runs = valueOf(settings, runsOption()) != 0;
    return {.errorTargetPercent = valueOf(settings, errorOption()),
            .binDeg = valueOf(settings, binOption()),
            .counts = runs ? ShadowCounts::grossAndRuns : ShadowCounts::gross,
            .checksRuns = valueOf(settings, checkOption()) != 0};
}

}  // namespace noonmark
