#include "app/gui/session/project/view_state.h"

#include <algorithm>

#include "core/city/footprints/repair_footprint.h"
#include "core/describe/field_json.h"
#include "core/describe/field_values.h"
#include "core/study/elements/element_fields.h"
#include "core/study/study_fields.h"
#include "scenarios/project/tables/geometry_blob.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

Json elementSettingsJson(const ElementSettings& elements) {
    return fieldsJson(elementFields().of(elements), {.which = FieldJson::Which::all});
}

std::optional<ElementSettings> elementSettingsFrom(const Json& json) {
    if (!json.is_object() || !json.contains("places")) return std::nullopt;
    ElementSettings elements;
    const Editable fields = elementFields().of(elements);
    if (!readFieldsJson(fields, json) || !checkRanges(fields)) return std::nullopt;
    return elements;
}

namespace {

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

Json studyJson(const StudySettings& study) {
    Json json = fieldsJson(studyFields().of(study), {.which = FieldJson::Which::all});
    json["region"] = regionJson(study.region);
    return json;
}

// As versions wrote it whose times were numbers and whose months were yes or no.
void renameOldFields(Json& study) {
    Json& period = study.at("period");
    if (period.contains("from_min"))
        period["from"] = formatText(std::chrono::minutes(period.at("from_min").get<int>()));
    if (const Json window = period.value("window", Json()); window.is_object()) {
        const SolarHours read{std::chrono::minutes(window.at("after_sunrise_min").get<int>()),
                              std::chrono::minutes(window.at("before_sunset_min").get<int>())};
        period["window"] = formatText(read);
        period["centre"] = window.at("rule") == int(SunriseRule::centre);
    }
    if (study.value("by_month", false)) study["by"] = "month";
}

std::optional<StudySettings> studyFrom(const std::string& text) try {
    Json json = Json::parse(text);
    renameOldFields(json);
    StudySettings study;
    const Region region = regionFrom(json.at("region"));
    json.erase("region");
    const Editable fields = studyFields().of(study);
    if (!readFieldsJson(fields, json) || !checkRanges(fields) || !validate(study.period)) return std::nullopt;
    study.region = region;
    return study;
} catch (const std::exception&) {  // unexpected JSON structure, a ring of two points
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
constexpr const char* modes[] = {"exploration", "analysis", "review"};

ViewMode modeFrom(const std::string& text) {
    for (int i = 0; i < 3; ++i)
        if (text == modes[i]) return ViewMode(i);
    // A mode of files saved before: its method is that of the study.
    return text == "ray reference" ? ViewMode::analysis : ViewMode::exploration;
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
    if (!state.shown.empty()) texts["shown"] = state.shown;
    if (state.legend != LegendChoice()) texts["legend"] = formatText(state.legend);
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
    state.legend = parseLegendChoice(found(texts, "legend"));
    if (const std::string name = found(texts, "scenario"); !name.empty()) state.scenario = name;
    state.baseline = found(texts, "baseline");
    state.answer = found(texts, "answer");
    state.shown = found(texts, "shown");
    state.answerSeconds = secondsFrom(found(texts, "answer_seconds"));
    state.study = studyFrom(found(texts, "study"));
    state.elements = elementsFrom(found(texts, "elements"));
    state.review = found(texts, "review");
    return state;
}

}  // namespace noonmark
