#include "scenarios/settings_json.h"

#include "core/base/version.h"
#include "core/receivers/roof_receivers.h"
#include "core/simd/instruction_set.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

Json settingsJson(const StudySettings& settings) {
    Json engine{{"key", settings.engine}, {"settings", Json::object()}};
    for (const auto& [key, value] : settings.engineSettings) engine["settings"][key] = value;
    const Period& period = settings.period;
    return {{"program", "Noonmark " + std::string(version())},
            {"instruction_set", nameOf(instructionSetInUse())},
            {"engine", engine},
            {"period",
             {{"text", formatText(period)},
              {"start", formatText(period.start)},
              {"days", period.days},
              {"from", period.window ? Json() : Json(formatText(period.from))},
              {"hours", period.window ? Json() : Json(period.hours)},
              {"window", period.window ? Json(formatText(*period.window)) : Json()},
              {"step_min", period.stepMinutes},
              {"zone", period.zone},
              {"refraction", period.refraction}}},
            {"observer", {{"pressure_hpa", settings.pressureHPa}, {"temperature_c", settings.temperatureC}}},
            {"region", settings.region.name},
            {"cell_m", settings.receivers.cellM},
            {"receivers_on", nameOf(settings.receivers.places)}};
}

RepeatQuestion projectQuestion(const std::string& command, const StudySettings& settings,
                               const Provenance& provenance, const std::string& engineKey,
                               std::vector<RepeatOption> options) {
    return {command, settings, provenance, engineKey, "--at", true, std::move(options)};
}

}  // namespace noonmark
