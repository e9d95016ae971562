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
    return fmt::format("{} ({:g} to {:g} in {} features)", field.field, field.low, field.high,
                       formatThousands(field.features));
}

std::string describe(const HeightField& field) {
    const std::string meaning = field.meaning.empty() ? "" : " (" + field.meaning + ")";
    return fmt::format("{}{}, {}: {} features", field.field, meaning, field.unit,
                       formatThousands(field.features));
}

}  // namespace noonmark
