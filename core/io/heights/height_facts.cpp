#include "core/io/heights/height_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/safe_text.h"
#include "core/describe/figure_text.h"
#include "core/describe/text.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

constexpr std::array standRules{StandRule::asStated, StandRule::shifted, StandRule::setDown};

const char* describeRule(StandRule rule) {
    switch (rule) {
        case StandRule::asStated:
            return NM_TEXT("they stand where the file states");
        case StandRule::shifted:
            return NM_TEXT("all were shifted onto it");
        case StandRule::setDown:
            return NM_TEXT("each building was set down on it");
    }
    return "";
}

}  // namespace

std::string_view nameOf(StandRule rule) {
    switch (rule) {
        case StandRule::asStated:
            return "as stated";
        case StandRule::shifted:
            return "shifted";
        case StandRule::setDown:
            return "set down";
    }
    return "unknown";
}

std::optional<StandRule> parseStandRule(std::string_view name) {
    const auto* const found =
        std::ranges::find(standRules, name, [](StandRule rule) { return nameOf(rule); });
    if (found == standRules.end()) return std::nullopt;
    return *found;
}

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
    return fmt::format("{} ({:g} to {:g}{} in {})", field.field, field.low, field.high, datum,
                       countOf(field.features, "feature"));
}

bool BaseFit::fits() const {
    constexpr double sillM = 1;  // smaller gaps are those of sills and of slopes
    return std::abs(gapM) <= std::max(sillM, spreadM);
}

bool BaseFit::isRemarkable() const { return rule != StandRule::asStated || apart > 0 || !fits(); }

std::vector<Sentence> listSentences(const BaseFit& fit) {
    const auto count = [](std::size_t number) { return Amount{double(number), FigureUnit::none, 0}; };
    std::vector<Sentence> sentences{
        {fit.gapM < 0 ? NM_TEXT("bases of %1 lie %2 m below the terrain (median of %3, spread %4 m)")
                      : NM_TEXT("bases of %1 lie %2 m above the terrain (median of %3, spread %4 m)"),
         {fit.file, Amount{std::abs(fit.gapM)}, count(fit.buildings), Amount{fit.spreadM}}},
        {describeRule(fit.rule), {}}};
    if (fit.apart > 0)
        sentences.push_back(
            {NM_TEXT("%1 far from that gap were set down by themselves"), {count(fit.apart)}});
    if (fit.aloft > 0) sentences.push_back({NM_TEXT("%1 stay above the ground"), {count(fit.aloft)}});
    return sentences;
}

std::string describe(const BaseFit& fit) {
    std::string text;
    for (const Sentence& sentence : listSentences(fit))
        text += text.empty() ? formatText(sentence) : "; " + lowered(formatText(sentence));
    return text;
}

std::string selectingOptions(const UnknownField& field) {
    const std::string name = quoteForShell(field.field);
    const std::string unit = field.unit.empty() ? "" : ' ' + readOption("height_unit", field.unit);
    switch (field.kind) {
        case FieldKind::storeys:
            return readOption("levels_field", name);
        case FieldKind::either:
            return fmt::format("{} or {}", readOption("levels_field", name),
                               readOption("height_field", name));
        case FieldKind::heights:
        case FieldKind::elevations:
            break;
    }
    return readOption("height_field", name) + unit;
}

std::string describe(const HeightDoubt& doubt) {
    return fmt::format("{}: {}: {}", doubt.file, doubt.field, doubt.why);
}

std::string describe(const HeightField& field) {
    const std::string meaning = field.meaning.empty() ? "" : " (" + field.meaning + ")";
    return fmt::format("{}{}, {}: {}", field.field, meaning, field.unit, countOf(field.features, "feature"));
}

}  // namespace noonmark
