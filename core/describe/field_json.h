#pragma once

#include <nlohmann/json.hpp>

#include "core/describe/field.h"

namespace noonmark {

/// Which fields a JSON states, and how.
struct FieldJson {
    /// The fields that apply; all, for files that give back what does not apply now; those that apply and
    /// differ from their default; or these with those that are always restated, as commands state them.
    enum class Which { applying, all, changed, stated };
    /// Numbers count choices from 0, as projects of all versions do for the settings of reading a city.
    enum class Choices { keys, numbers };
    Which which = Which::applying;
    Choices choices = Choices::keys;
};

/// The fields by key, in the order of the table; those of a group in an object of that name. An unset value
/// is null.
nlohmann::ordered_json fieldsJson(const Described& settings, FieldJson form = {});

/// Takes the fields that the JSON has; the others stay. Choices are read in both forms. Error, with the key:
/// a value of another kind, or none of the choices. Ranges are not checked: see
/// field_values.h.
Result<void> readFieldsJson(const Editable& settings, const nlohmann::ordered_json& json);

}  // namespace noonmark
