#include "app/gui/session/project/element_settings_json.h"

#include "core/describe/field_checks.h"
#include "core/describe/field_json.h"
#include "core/study/elements/element_fields.h"

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

}  // namespace noonmark
