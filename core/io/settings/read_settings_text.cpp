#include "core/io/settings/read_settings_text.h"

#include "core/describe/field_json.h"
#include "core/io/settings/read_fields.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

// Projects name the axis by whether z points up, as all versions read it.
constexpr const char* axisKey = "z_up";

void readAxis(Json& json) {
    const auto found = json.find(axisKey);
    if (found == json.end()) return;
    json["up"] = found->get<bool>() ? "z" : "y";
    json.erase(axisKey);
}

}  // namespace

std::string formatText(const ReadSettings& reading) {
    Json json = fieldsJson(readSettingsFields().of(reading),
                           {FieldJson::Which::changed, FieldJson::Choices::numbers});
    json.erase("up");
    if (reading.upAxis != UpAxis::automatic) json[axisKey] = reading.upAxis == UpAxis::z;
    return json.empty() ? std::string() : json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<ReadSettings> readSettingsFrom(const std::string& text) try {
    ReadSettings reading;
    if (text.empty()) return reading;
    Json json = Json::parse(text);
    readAxis(json);
    if (!readFieldsJson(readSettingsFields().of(reading), json)) return std::nullopt;
    return reading;
} catch (const std::exception&) {  // not JSON, or of another structure
    return std::nullopt;
}

}  // namespace noonmark
