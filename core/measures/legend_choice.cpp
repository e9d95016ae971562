#include "core/measures/legend_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/describe/field_json.h"
#include "core/describe/text.h"
#include "core/engines/shade_trees.h"
#include "core/measures/shadow_figures.h"

namespace noonmark {

namespace {

using Kind = LegendClasses::Kind;

constexpr std::array rampList{
    Choice<Ramp>{Ramp::noonmark, "noonmark", NM_TEXT("Sun to indigo")},
    Choice<Ramp>{Ramp::viridis, "viridis", NM_TEXT("Viridis")},
    Choice<Ramp>{Ramp::cividis, "cividis", NM_TEXT("Cividis")},
    Choice<Ramp>{Ramp::magma, "magma", NM_TEXT("Magma")},
    Choice<Ramp>{Ramp::grey, "grey", NM_TEXT("Grey")},
    Choice<Ramp>{Ramp::trafficLight, "traffic-light", NM_TEXT("Green to red")},
    Choice<Ramp>{Ramp::violetOrange, "violet-orange", NM_TEXT("Orange to violet")},
};

constexpr std::array changeRampList{
    Choice<Ramp>{Ramp::greenBrown, "green-brown", NM_TEXT("Green-blue to brown")},
    Choice<Ramp>{Ramp::orangePurple, "orange-purple", NM_TEXT("Orange to purple")},
    Choice<Ramp>{Ramp::blueRed, "blue-red", NM_TEXT("Blue to red")},
    Choice<Ramp>{Ramp::greenRed, "green-red", NM_TEXT("Green to red, pale in the middle")},
};

// Independent of the locale; nothing may follow the number.
std::optional<double> finiteNumberIn(std::string_view text) {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end || !std::isfinite(number)) return std::nullopt;
    return number;
}

std::string_view withoutBlanks(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
}

std::optional<int> classCountIn(std::string_view text) {
    const auto number = finiteNumberIn(text);
    if (!number || *number != std::floor(*number) || *number < LegendClasses::minCount ||
        *number > LegendClasses::maxCount)
        return std::nullopt;
    return int(*number);
}

std::optional<std::vector<double>> ascendingNumbersIn(std::string_view text) {
    std::vector<double> numbers;
    while (true) {
        const auto comma = text.find(',');
        const auto number = finiteNumberIn(text.substr(0, comma));
        if (!number || (!numbers.empty() && *number <= numbers.back())) return std::nullopt;
        numbers.push_back(*number);
        if (comma == std::string_view::npos) break;
        text.remove_prefix(comma + 1);
    }
    return numbers.size() < std::size_t(LegendClasses::maxCount) ? std::optional(numbers) : std::nullopt;
}

}  // namespace

std::span<const Choice<Ramp>> rampChoices() { return rampList; }

std::span<const Choice<Ramp>> changeRampChoices() { return changeRampList; }

std::string formatText(LegendRange range) { return fmt::format("{}:{}", range.low, range.high); }

Result<LegendRange> parseLegendRange(std::string_view text) {
    for (const std::string_view between : {":", "..", " to ", "\u2013", "-"}) {
        const auto at = text.find(between, 1);  // a minus may come first
        if (at == std::string_view::npos) continue;
        const auto low = finiteNumberIn(withoutBlanks(text.substr(0, at)));
        const auto high = finiteNumberIn(withoutBlanks(text.substr(at + between.size())));
        if (low && high && *low < *high) return LegendRange{*low, *high};
    }
    return failure("The range of the legend is not two numbers, the smaller one first", std::string(text),
                   "Write it like 0:8, in the unit that is shown");
}

std::string formatText(LegendClasses classes) {
    switch (classes.kind) {
        case Kind::continuous:
            return "continuous";
        case Kind::equal:
            return fmt::format("equal:{}", classes.count);
        case Kind::quantiles:
            return fmt::format("quantiles:{}", classes.count);
        case Kind::breaks:
            return fmt::format("{}", fmt::join(classes.breaks, ","));
    }
    return {};
}

Result<LegendClasses> parseLegendClasses(std::string_view text) {
    if (text == "continuous") return LegendClasses{};
    const auto colon = text.find(':');
    if (colon == std::string_view::npos) {
        if (auto breaks = ascendingNumbersIn(text)) return LegendClasses{Kind::breaks, 5, *std::move(breaks)};
    } else if (const auto count = classCountIn(text.substr(colon + 1))) {
        if (text.substr(0, colon) == "equal") return LegendClasses{Kind::equal, *count, {}};
        if (text.substr(0, colon) == "quantiles") return LegendClasses{Kind::quantiles, *count, {}};
    }
    return failure("The classes of the legend are not known", std::string(text),
                   "Write continuous, equal:5, quantiles:5 (2 to 12 classes), or ascending numbers between "
                   "the classes like 2,4,6");
}

std::vector<CommandOption> listLegendOptions(const LegendChoice& choice, bool aroundZero) {
    LegendChoice drawn{.show = choice.show, .trees = choice.trees};
    if (aroundZero) {
        drawn.changeRamp = choice.changeRamp;
        drawn.changeReversed = choice.changeReversed;
        drawn.changeClasses = choice.changeClasses;
    } else {
        drawn.ramp = choice.ramp;
        drawn.reversed = choice.reversed;
        drawn.range = choice.range;
        drawn.classes = choice.classes;
    }
    return listOptions(legendFields().of(drawn));
}

std::string formatText(const LegendChoice& choice) {
    return fieldsJson(legendFields().of(choice), {.which = FieldJson::Which::changed}).dump();
}

LegendChoice parseLegendChoice(const std::string& text) {
    LegendChoice choice;
    const auto json = nlohmann::ordered_json::parse(text, nullptr, false);
    if (!json.is_object() || !readFieldsJson(legendFields().of(choice), json)) return {};
    return choice;
}

LegendChoice showAs(const LegendChoice& choice, ShownAs as, double sunlitMin) {
    LegendChoice shown = choice;
    shown.show = as;
    const ShownQuantity from{choice.show, sunlitMin}, to{as, sunlitMin};
    const auto convert = [&](double value) { return to.of(from.minutesOf(value)); };
    if (choice.range) {
        const auto [low, high] = std::minmax({convert(choice.range->low), convert(choice.range->high)});
        shown.range = low < high ? std::optional(LegendRange{low, high}) : std::nullopt;
    }
    for (double& value : shown.classes.breaks) value = convert(value);
    std::vector<double>& breaks = shown.classes.breaks;
    std::ranges::sort(breaks);
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    // Minutes of sun that are gained are those of shadow that are lost.
    if (from.isSun() != to.isSun()) {
        for (double& value : shown.changeClasses.breaks) value = -value;
        std::ranges::reverse(shown.changeClasses.breaks);
    }
    return shown;
}

Sentence nameColumn(TreeColumns trees) {
    if (trees == TreeColumns::without) return {NM_TEXT("Trees are not included.")};
    return {trees == TreeColumns::evergreen ? NM_TEXT("This is with trees as evergreens.")
                                            : NM_TEXT("This is with trees by their seasons.")};
}

AnswerPage makePage(const ShadowField& field, const ShadowStatistics& statistics, const std::string& where,
                    const LegendChoice& shown) {
    const ShadowField& column = fieldOfColumn(field, shown.trees);
    if (&column == &field) return makePage(field, statistics, where, shown.show);
    AnswerPage page = makePage(column, computeStatistics(column), where, shown.show);
    page.findings.insert(page.findings.begin(), nameColumn(shown.trees));
    return page;
}

}  // namespace noonmark
