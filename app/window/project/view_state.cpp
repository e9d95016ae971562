#include "app/window/project/view_state.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/window/project/element_settings_json.h"
#include "core/city/footprints/repair_footprint.h"
#include "core/receivers/roof_receivers.h"
#include "scenarios/project/tables/ring_json.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;
using Texts = std::map<std::string, std::string>;

Json regionJson(const Region& region) {
    Json polygons = Json::array();
    for (const Footprint& polygon : region.polygons) {
        Json rings = Json::array({ringJson(polygon.outer)});
        for (const Ring& hole : polygon.holes) rings.push_back(ringJson(hole));
        polygons.push_back(std::move(rings));
    }
    return {{"name", region.name}, {"polygons", std::move(polygons)}};
}

Region regionFrom(const Json& json) {
    Region region{json.at("name"), {}};
    for (const Json& polygon : json.at("polygons")) {
        std::vector<RawRing> rings;
        for (const Json& points : polygon) {
            const Ring ring = parseRing(points);
            rings.emplace_back(ring.begin(), ring.end());
        }
        for (Footprint& piece : repairFootprint(rings).pieces) region.polygons.push_back(std::move(piece));
    }
    return region;
}

Json windowJson(const SolarWindow& window) {
    return {{"after_sunrise_min", window.afterSunrise.count()},
            {"before_sunset_min", window.beforeSunset.count()},
            {"rule", int(window.rule)}};
}

SolarWindow windowFrom(const Json& json) {
    return {std::chrono::minutes(json.at("after_sunrise_min").get<int>()),
            std::chrono::minutes(json.at("before_sunset_min").get<int>()),
            json.at("rule") == int(SunriseRule::centre) ? SunriseRule::centre : SunriseRule::upperLimb};
}

Json periodJson(const Period& period) {
    Json json{{"start", formatText(period.start)}, {"days", period.days},
              {"from_min", period.from.count()},   {"hours", period.hours},
              {"step_min", period.stepMinutes},    {"zone", period.zone},
              {"refraction", period.refraction}};
    if (period.window) json["window"] = windowJson(*period.window);
    return json;
}

Period periodFrom(const Json& json) {
    Period period{.days = json.at("days"),
                  .from = std::chrono::minutes(json.at("from_min").get<int>()),
                  .hours = json.at("hours"),
                  .stepMinutes = json.at("step_min"),
                  .zone = json.at("zone"),
                  .refraction = json.at("refraction")};
    if (const auto start = parseDate(json.at("start").get<std::string>())) period.start = *start;
    if (json.contains("window")) period.window = windowFrom(json.at("window"));
    return period;
}

Json studyJson(const StudySettings& study) {
    Json options = Json::object();
    for (const auto& [key, value] : study.engineSettings) options[key] = value;
    return {{"region", regionJson(study.region)},
            {"cell_m", study.receivers.cellM},
            {"receivers_on", nameOf(study.receivers.places)},
            {"period", periodJson(study.period)},
            {"pressure_hpa", study.pressureHPa},
            {"temperature_c", study.temperatureC},
            {"engine", study.engine},
            {"options", std::move(options)},
            {"by_month", study.byMonth},
            {"contributions", study.contributions}};
}

std::optional<StudySettings> studyFrom(const std::string& text) try {
    const Json json = Json::parse(text);
    StudySettings study;
    study.region = regionFrom(json.at("region"));
    study.receivers.cellM = json.at("cell_m");
    if (json.contains("receivers_on"))
        study.receivers.places = parsePlaces(json.at("receivers_on").get<std::string>()).value();
    study.period = periodFrom(json.at("period"));
    study.pressureHPa = json.value("pressure_hpa", study.pressureHPa);
    study.temperatureC = json.value("temperature_c", study.temperatureC);
    const bool isAir = study.pressureHPa >= 0 && study.pressureHPa <= 1200 && study.temperatureC >= -90 &&
                       study.temperatureC <= 60;
    study.engine = json.at("engine");
    for (const auto& [key, value] : json.at("options").items()) study.engineSettings[key] = value;
    study.byMonth = json.at("by_month");
    study.contributions = json.at("contributions");
    if (!validate(study.period) || !(study.receivers.cellM > 0) || !isAir) return std::nullopt;
    return study;
} catch (const std::exception&) {  // unexpected JSON structure, a ring of two points, unnamed places
    return std::nullopt;
}

std::optional<ElementSettings> elementsFrom(const std::string& text) {
    return elementSettingsFrom(Json::parse(text, nullptr, false));
}

std::string cameraText(const CameraPose& pose) {
    Json numbers{pose.target.x, pose.target.y, pose.target.z, pose.distanceM, pose.headingDeg, pose.pitchDeg};
    if (pose.isParallel()) numbers.push_back(1);
    return numbers.dump();
}

std::optional<CameraPose> cameraFrom(const std::string& text) try {
    const auto numbers = Json::parse(text).get<std::vector<double>>();
    if (numbers.size() < 6 || numbers.size() > 7 || !(numbers[3] > 0) || numbers[3] > 1e7)
        return std::nullopt;
    const bool parallel = numbers.size() == 7 && numbers[6] == 1;
    return CameraPose{{numbers[0], numbers[1], numbers[2]},
                      numbers[3],
                      numbers[4],
                      numbers[5],
                      parallel ? Projection::parallel : Projection::perspective};
} catch (const Json::exception&) {
    return std::nullopt;
}

std::string sectionText(const SectionBox& box) {
    return Json{box.lowM.x, box.lowM.y, box.lowM.z, box.highM.x, box.highM.y, box.highM.z}.dump();
}

std::optional<SectionBox> sectionFrom(const std::string& text) try {
    const auto numbers = Json::parse(text).get<std::vector<double>>();
    if (numbers.size() != 6) return std::nullopt;
    return repairSection({{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}});
} catch (const Json::exception&) {
    return std::nullopt;
}

double secondsFrom(const std::string& text) try {
    return std::max(0.0, Json::parse(text).get<double>());
} catch (const Json::exception&) {
    return 0;
}

std::string found(const Texts& texts, const char* key) {
    const auto at = texts.find(key);
    return at == texts.end() ? std::string() : at->second;
}

// Values in the file, not the displayed names, which are translated.
constexpr const char* modes[] = {"exploration", "analysis", "ray reference"};

ViewMode modeFrom(const std::string& text) {
    for (int i = 0; i < 3; ++i)
        if (text == modes[i]) return ViewMode(i);
    return ViewMode::exploration;
}

}  // namespace

Texts textsOf(const ViewState& state) {
    Texts texts{{"mode", modes[int(state.mode)]},
                {"measure", state.measure == ShadowMeasure::gross ? "gross" : "continuous"},
                {changeScaleKey, formatText(state.changeScale)},
                {"scenario", state.scenario},
                {"baseline", state.baseline}};
    if (!state.answer.empty()) {
        texts["answer"] = state.answer;
        texts["answer_seconds"] = Json(state.answerSeconds).dump();
    }
    if (!state.review.empty()) texts["review"] = state.review;
    if (state.camera) texts["camera"] = cameraText(*state.camera);
    if (state.section) texts["section"] = sectionText(*state.section);
    if (state.study) texts["study"] = studyJson(*state.study).dump();
    if (state.elements) texts["elements"] = elementSettingsJson(*state.elements).dump();
    return texts;
}

ViewState parseViewState(const Texts& texts) {
    ViewState state;
    state.camera = cameraFrom(found(texts, "camera"));
    state.section = sectionFrom(found(texts, "section"));
    state.mode = modeFrom(found(texts, "mode"));
    if (found(texts, "measure") == "continuous") state.measure = ShadowMeasure::continuous;
    state.changeScale = changeScaleIn(texts);
    if (const std::string name = found(texts, "scenario"); !name.empty()) state.scenario = name;
    state.baseline = found(texts, "baseline");
    state.answer = found(texts, "answer");
    state.answerSeconds = secondsFrom(found(texts, "answer_seconds"));
    state.study = studyFrom(found(texts, "study"));
    state.elements = elementsFrom(found(texts, "elements"));
    state.review = found(texts, "review");
    return state;
}

}  // namespace noonmark
