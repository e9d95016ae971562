#include "core/study/text/error_json.h"

#include "core/measures/has_runs.h"
#include "core/study/text/error_words.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

Json cellErrorJson(const CellError& error, const Frame& frame) {
    const LonLat worst = frame.lonLatFromLocal(error.worstM);
    return {{"mean_pct", error.percent(error.meanMin)},
            {"p99_pct", error.percent(error.p99Min)},
            {"max_pct", error.percent(error.maxMin)},
            {"mean_min", error.meanMin},
            {"p99_min", error.p99Min},
            {"max_min", error.maxMin},
            {"whole_min", error.wholeMin},
            {"worst_lonlat", {worst.lonDeg, worst.latDeg}},
            {"worst_m", {error.worstM.x, error.worstM.y}}};
}

}  // namespace

Json errorJson(const SampledError& error, const Frame& frame) {
    return {{"reference", referenceEngine},
            {"sample_receivers", error.receivers},
            {"of_receivers", error.ofReceivers},
            {"rays", error.rays},
            {"area_pct", error.areaPct},
            {"area_standard_error_pct", error.areaStandardErrorPct},
            {"gross", cellErrorJson(error.gross, frame)},
            {"continuous", hasRuns(error) ? cellErrorJson(error.continuous, frame) : Json()}};
}

Json errorJson(const Study& study) {
    Json json = errorJson(study.error.value_or(SampledError{}), study.city.frame);
    if (!study.error)
        for (auto& [key, value] : json.items())
            if (key != "reference") value = nullptr;
    const auto seconds = study.seconds.find("error_sample");
    json["seconds"] = seconds == study.seconds.end() ? Json() : Json(seconds->second);
    json["why_not"] = study.error ? Json() : Json(whyNoError(study));
    return json;
}

}  // namespace noonmark
