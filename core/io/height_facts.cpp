#include "core/io/height_facts.h"

#include <fmt/format.h>

namespace noonmark {

std::string withThousands(std::size_t count) {
    const std::string digits = fmt::to_string(count);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

std::string wordsOf(const UnknownField& field) {
    return fmt::format("{} ({:g} to {:g} in {} features)", field.field, field.low, field.high,
                       withThousands(field.features));
}

std::string wordsOf(const HeightField& field) {
    const std::string meaning = field.meaning.empty() ? "" : " (" + field.meaning + ")";
    return fmt::format("{}{}, {}: {} features", field.field, meaning, field.unit,
                       withThousands(field.features));
}

}  // namespace noonmark
