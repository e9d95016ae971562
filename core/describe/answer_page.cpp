#include "core/describe/answer_page.h"

#include <fmt/format.h>
#include <cctype>

#include "core/base/wording.h"
#include "core/describe/figure_text.h"
#include "core/describe/fill_text.h"

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

std::string fillText(std::string_view english, std::initializer_list<std::string> values) {
    return fillIn(localText(english), {values.begin(), values.size()});
}

std::string formatText(const Sentence& sentence, UnitSystem units) {
    std::vector<std::string> values;
    for (const Sentence::Argument& argument : sentence.arguments) {
        const auto* amount = std::get_if<Amount>(&argument);
        values.push_back(amount ? valueOf(*amount, units) : std::get<std::string>(argument));
    }
    std::string text = fillIn(localText(sentence.source), values);
    if (!text.empty()) text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

Bars changesOf(const Bars& bars, std::string_view title) {
    Bars changes{.title = title, .groupName = bars.groupName, .series = {}, .isChange = true};
    if (bars.series.size() < 2) return changes;
    changes.series.assign(bars.series.begin() + 1, bars.series.end());
    for (const Bars::Group& group : bars.groups) {
        Bars::Group& change = changes.groups.emplace_back(Bars::Group{group.name, {}, group.tone});
        for (std::size_t i = 1; i < group.values.size(); ++i)
            change.values.push_back(group.values[i] - group.values.front());
    }
    return changes;
}

Bars firstSeries(Bars bars, std::size_t maximum) {
    if (bars.series.size() <= maximum) return bars;
    bars.series.resize(maximum);
    for (Bars::Group& group : bars.groups) group.values.resize(maximum);
    return bars;
}

std::string groupKey(const Bars::Group& group) {
    if (const auto* text = std::get_if<std::string>(&group.name)) return *text;
    if (const auto* values = std::get_if<Bars::Class>(&group.name))
        return fmt::format("{:g} to {:g}", values->low, values->high);
    const auto* month = std::get_if<std::chrono::year_month>(&group.name);
    return fmt::format("{:04}-{:02}", int(month->year()), unsigned(month->month()));
}

}  // namespace noonmark
