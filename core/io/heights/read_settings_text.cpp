#include "core/io/heights/read_settings_text.h"

#include "core/describe/field_json.h"
#include "core/io/read_fields.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

// Earlier versions knew two axes.
void renameAxis(Json& json) {
    const auto old = json.find("z_up");
    if (old == json.end()) return;
    json["up"] = old->get<bool>() ? "z" : "y";
    json.erase("z_up");
}

}  // namespace

std::string formatText(const ReadSettings& reading) {
    const Json json = fieldsJson(readSettingsFields().of(reading),
                                 {FieldJson::Which::changed, FieldJson::Choices::numbers});
    return json.empty() ? std::string() : json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<ReadSettings> readSettingsFrom(const std::string& text) try {
    ReadSettings reading;
    if (text.empty()) return reading;
    Json json = Json::parse(text);
    renameAxis(json);
    if (!readFieldsJson(readSettingsFields().of(reading), json)) return std::nullopt;
    return reading;
} catch (const std::exception&) {  // not JSON, or of another structure
    return std::nullopt;
}

}  // namespace noonmark
