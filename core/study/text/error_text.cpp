#include "core/study/text/error_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/safe_text.h"
#include "core/base/wording.h"
#include "core/describe/figure_text.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"

namespace noonmark {

namespace {

std::string describePlace(const Study& study, glm::dvec2 localM) {
    const LonLat place = study.city.frame.lonLatFromLocal(localM);
    return fmt::format("{:.5f} {}, {:.5f} {}", std::abs(place.latDeg), place.latDeg < 0 ? "S" : "N",
                       std::abs(place.lonDeg), place.lonDeg < 0 ? "W" : "E");
}

std::string describeCell(const Study& study, const CellError& error) {
    const std::string worst =
        fmt::format("worst {:.3f} % ({:.1f} min)", error.percent(error.maxMin), error.maxMin);
    const std::string place = error.maxMin > 0 ? " at " + describePlace(study, error.worstM) : "";
    return fmt::format("mean {:.4f} % ({:.2f} min), 99 % of cells within {:.3f} %, {}{}",
                       error.percent(error.meanMin), error.meanMin, error.percent(error.p99Min), worst,
                       place);
}

std::string describeSample(const Study& study, const SampledError& error) {
    const auto seconds = study.seconds.find("error_sample");
    return fmt::format("{} of {} against the ray reference, the same {}, in {:.2f} s", error.receivers,
                       countOf(error.ofReceivers, "receiver"), countOf(study.sun.steps.size(), "step"),
                       seconds == study.seconds.end() ? 0 : seconds->second);
}

}  // namespace

std::string whyNoError(const Study& study) {
    if (study.error) return {};
    if (study.byReference())
        return localText(
            NM_TEXT("The engine is the ray reference itself, against which others are measured."));
    if (study.settings.errorSample.receivers == 0)
        return localText(
            NM_TEXT("The engine's error against the ray reference was not measured: it was switched off."));
    return localText(
        NM_TEXT("The engine's error against the ray reference could not be measured: see the warnings."));
}

std::vector<ErrorLine> makeErrorLines(const Study& study) {
    if (!study.error) return {{"error", whyNoError(study)}};
    const SampledError& error = *study.error;
    std::vector<ErrorLine> lines;
    const auto add = [&lines](std::string name, std::string value) {
        lines.push_back({std::move(name), std::move(value)});
    };
    add("area error", fmt::format("{} % of the ground, standard error {:.4f}", formatSigned(error.areaPct, 4),
                                  error.areaStandardErrorPct));
    add("cell error, gross", describeCell(study, error.gross));
    if (study.sun.steps.size() > 1 && hasRuns(error))
        add("cell error, continuous", describeCell(study, error.continuous));
    add("error measured on", describeSample(study, error));
    return lines;
}

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

Json warningsJson(const Warnings& warnings) {
    Json groups = Json::array();
    for (const WarningGroup& group : groupWarnings(warnings))
        groups.push_back(Json{{"kind", nameOf(group.kind)},
                              {"what", group.what},
                              {"count", group.where.size()},
                              {"where", group.where}});
    return groups;
}

namespace {

bool hasNegativeZero(const Json& json) {
    if (json.is_structured()) return std::ranges::any_of(json, hasNegativeZero);
    return json.is_number_float() && json.get<double>() == 0 && std::signbit(json.get<double>());
}

// CSV states a plain zero, too.
void removeNegativeZeros(Json& json) {
    if (json.is_structured())
        for (Json& value : json) removeNegativeZeros(value);
    else if (hasNegativeZero(json))
        json = 0.0;
}

}  // namespace

std::string toJsonText(const Json& json) {
    const auto dump = [](const Json& plain) {
        return plain.dump(2, ' ', false, Json::error_handler_t::replace);
    };
    if (!hasNegativeZero(json)) return dump(json);
    Json plain = json;
    removeNegativeZeros(plain);
    return dump(plain);
}

}  // namespace noonmark
