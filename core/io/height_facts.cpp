#include "core/io/height_facts.h"

#include <fmt/format.h>

namespace noonmark {

std::string withThousands(std::size_t count) {
    std::string text = fmt::to_string(count);
    for (std::ptrdiff_t at = std::ptrdiff_t(text.size()) - 3; at > 0; at -= 3)
        text.insert(std::size_t(at), ",");
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
