#include "core/engines/accrual/interval_options.h"

#include "core/describe/text.h"

namespace noonmark {

namespace {

EngineOption mapOption(int largestMap) {
    return {
        "map",
        NM_TEXT("Map size"),
        "texels",
        AccrualSettings::minMapSize,
        double(largestMap),
        double(AccrualSettings{}.mapSize),
        OptionKind::wholeNumber,
        NM_TEXT(
            "Texels along a side of the depth map that is stretched over the region; no more than cells are "
            "used")};
}

EngineOption biasOption() {
    return {"bias",
            NM_TEXT("Bias"),
            "m",
            0,
            double(AccrualSettings::maxBiasM),
            double(AccrualSettings{}.biasM),
            OptionKind::number,
            NM_TEXT("How high above the ground something must be to shade it")};
}

EngineOption intervalOption() {
    return {"interval",
            NM_TEXT("Interval"),
            "min",
            0.1,
            120,
            DirectionGraphSettings{}.intervalMinutes,
            OptionKind::number,
            NM_TEXT("How long the sun is taken to move in a straight line")};
}

EngineOption boundOption() {
    return {"bound",
            NM_TEXT("Direction bound"),
            "deg",
            0.1,
            20,
            DirectionGraphSettings{}.boundDeg,
            OptionKind::number,
            NM_TEXT("Hours whose sun is less than this apart are computed once")};
}

}  // namespace

std::vector<EngineOption> graphOptions() { return {intervalOption(), boundOption()}; }

DirectionGraphSettings readGraphSettings(const EngineSettings& settings) {
    return {.boundDeg = settings.at("bound"), .intervalMinutes = settings.at("interval")};
}

std::vector<EngineOption> accrualOptions(int largestMap) {
    return {mapOption(largestMap), biasOption(), intervalOption(), boundOption()};
}

AccrualSettings readAccrualSettings(const EngineSettings& settings) {
    return {.mapSize = int(settings.at("map")), .biasM = float(settings.at("bias"))};
}

}  // namespace noonmark
