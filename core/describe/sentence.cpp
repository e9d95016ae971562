#include "core/describe/sentence.h"

#include <cctype>

#include "core/describe/figure_text.h"

namespace noonmark {

std::string valueOf(const Amount& amount, UnitSystem units) {
    Figure figure;
    figure.unit = amount.unit;
    figure.shownDecimals = amount.decimals;
    figure.isChange = amount.isChange;
    return valueOf(FigureLine{&figure, amount.value}, units);
}

std::string fillIn(std::string_view text, std::span<const std::string> values) {
    std::string filled;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t number = i + 1 < text.size() ? std::size_t(text[i + 1] - '1') : values.size();
        if (text[i] == '%' && number < values.size()) {
            filled += values[number];
            ++i;
        } else {
            filled += text[i];
        }
    }
    return filled;
}

std::string formatText(const Sentence& sentence, UnitSystem units) {
    std::vector<std::string> values;
    for (const Sentence::Argument& argument : sentence.arguments) {
        const auto* amount = std::get_if<Amount>(&argument);
        values.push_back(amount ? valueOf(*amount, units) : std::get<std::string>(argument));
    }
    std::string text = fillIn(sentence.source, values);
    if (!text.empty()) text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

}  // namespace noonmark
