#include "scenarios/settings_json.h"

#include "core/base/version.h"
#include "core/describe/field_json.h"
#include "core/simd/instruction_set.h"
#include "core/study/study_fields.h"
#include "core/sun/period_fields.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

Json settingsJson(const StudySettings& settings) {
    const Period& period = settings.period;
    Json times{{"text", formatText(period)}};
    times.update(fieldsJson(periodFields().of(period), {.which = FieldJson::Which::all}));
    if (period.window) {
        times["from"] = times["hours"] = nullptr;
        times["window"] = formatText(*period.window);
    }
    times.erase("centre");  // the text of the window states it
    Json json{{"program", "Noonmark " + std::string(version())},
              {"instruction_set", nameOf(instructionSetInUse())},
              {"engine", {{"key", settings.engine}, {"settings", settings.engineSettings}}},
              {"period", std::move(times)},
              {"observer", fieldsJson(airFields().of(settings))},
              {"region", settings.region.name}};
    json.update(fieldsJson(cellFields().of(settings)));
    json.update(fieldsJson(surfaceFields().of(settings)));
    return json;
}

RepeatQuestion projectQuestion(const std::string& command, const StudySettings& settings,
                               const Provenance& provenance, const std::string& engineKey,
                               std::vector<CommandOption> options) {
    RepeatQuestion question{command, settings, provenance,        engineKey, periodFlagsBesideScenarios(),
                            true,    true,     std::move(options)};
    question.settings.byMonth = question.settings.contributions = false;
    return question;
}

}  // namespace noonmark
