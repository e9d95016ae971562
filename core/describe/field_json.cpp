#include "core/describe/field_json.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/json_number.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

struct ToJson {
    Json operator()(std::monostate) const { return {}; }
    template <class T>
    Json operator()(const T& value) const {
        return value;
    }
};

Json valueJson(const Field& field, const Value& value, FieldJson::Choices choices) {
    if (field.kind != ValueKind::choice || choices == FieldJson::Choices::keys || value == Value())
        return std::visit(ToJson(), value);
    const auto found = std::ranges::find(field.choices, std::get<std::string>(value), &KeyedLabel::key);
    return int(found - field.choices.begin());
}

Value choiceFrom(const Field& field, const Json& json) {
    if (json.is_string()) return json.get<std::string>();
    if (json.is_boolean()) return std::string(field.choices.at(json.get<bool>() ? 1 : 0).key);
    return std::string(field.choices.at(wholeNumberFrom<std::size_t>(json)).key);
}

// Throws what nlohmann throws for a value of another type, or std::out_of_range.
Value valueFrom(const Field& field, const Json& json) {
    if (json.is_null()) return {};
    switch (field.kind) {
        case ValueKind::yesNo:
            return json.get<bool>();
        case ValueKind::whole:
            return wholeNumberFrom<std::int64_t>(json);
        case ValueKind::number:
            return json.get<double>();
        case ValueKind::text:
            return json.get<std::string>();
        case ValueKind::choice:
            return choiceFrom(field, json);
        case ValueKind::numbers:
            return json.get<std::vector<double>>();
        case ValueKind::texts:
            return json.get<std::vector<std::string>>();
        case ValueKind::namedNumbers:
            return json.get<NamedNumbers>();
    }
    return {};
}

Result<void> readField(const Editable& settings, const Field& field, const Json& json) try {
    const auto found = json.find(field.key);
    if (found == json.end()) return {};
    return settings.set(field, valueFrom(field, *found));
} catch (const std::exception&) {  // of another type, or out of the range of its type
    return refuseValue(field);
}

const Json* groupIn(const Json& json, std::string_view group) {
    if (group.empty()) return &json;
    const auto found = json.find(group);
    return found != json.end() && found->is_object() ? &*found : nullptr;
}

bool isStated(const Described& settings, const Field& field, const Value& value, FieldJson::Which which) {
    if (which == FieldJson::Which::all) return true;
    if (!settings.applies(field)) return false;
    if (which == FieldJson::Which::applying || value != field.standard) return true;
    return which == FieldJson::Which::stated && field.restated;
}

}  // namespace

Json fieldsJson(const Described& settings, FieldJson form) {
    Json json = Json::object();
    for (const Field& field : settings.fields) {
        const Value value = settings.get(field);
        if (!isStated(settings, field, value, form.which)) continue;
        Json& object = field.group.empty() ? json : json[std::string(field.group)];
        object[std::string(field.key)] = valueJson(field, value, form.choices);
    }
    return json;
}

Result<void> readFieldsJson(const Editable& settings, const Json& json) {
    if (!json.is_object()) return failure("The settings are no JSON object");
    for (const Field& field : settings.fields)
        if (const Json* group = groupIn(json, field.group))
            if (auto read = readField(settings, field, *group); !read) return read;
    return {};
}

}  // namespace noonmark
