#include "core/io/heights/height_facts.h"

#include <fmt/format.h>

namespace noonmark {

std::string formatThousands(std::size_t count) {
    const std::string digits = fmt::to_string(count);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

std::string describe(const UnknownField& field) {
    const char* const datum = field.kind == FieldKind::elevations ? " above the datum, not the ground" : "";
    return fmt::format("{} ({:g} to {:g}{} in {} features)", field.field, field.low, field.high, datum,
                       formatThousands(field.features));
}

std::string selectingOptions(const UnknownField& field) {
    const bool blank = field.field.find_first_of(" ()'\"") != std::string::npos;
    const std::string name = blank ? "\"" + field.field + "\"" : field.field;
    const std::string unit = field.unit.empty() ? "" : " --height-unit " + field.unit;
    switch (field.kind) {
        case FieldKind::storeys:
            return "--levels-field " + name;
        case FieldKind::either:
            return fmt::format("--levels-field {0} or --height-field {0}", name);
        case FieldKind::heights:
        case FieldKind::elevations:
            break;
    }
    return "--height-field " + name + unit;
}

std::string describe(const HeightField& field) {
    const std::string meaning = field.meaning.empty() ? "" : " (" + field.meaning + ")";
    return fmt::format("{}{}, {}: {} features", field.field, meaning, field.unit,
                       formatThousands(field.features));
}

}  // namespace noonmark
