#include "core/describe/figure_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "core/base/json_number.h"
#include "core/base/wording.h"
#include "core/describe/shown_as.h"
#include "core/describe/text.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::array shownList{
    Choice<ShownAs>{ShownAs::shadow, "shadow", NM_TEXT("Shadow")},
    Choice<ShownAs>{ShownAs::sun, "sun", NM_TEXT("Sun")},
    Choice<ShownAs>{ShownAs::share, "share", NM_TEXT("Share of the sunlit time")},
};

// Of core/base/units.cpp, which lies below the macro.
[[maybe_unused]] constexpr std::array unitWords{NM_TEXT("ft"), NM_TEXT("sq ft"), NM_TEXT("acres")};

bool isTime(FigureUnit unit) {
    return unit == FigureUnit::minutes || unit == FigureUnit::minutesADay || unit == FigureUnit::hours ||
           unit == FigureUnit::hoursADay;
}

double computeShare(const Figure& figure, double value, const FigureContext& context) {
    const double whole = figure.whole == Whole::area         ? context.areaM2
                         : figure.whole == Whole::sunlitTime ? context.sunlitMin
                                                             : 0;
    return whole > 0 ? 100 * value / whole : std::numeric_limits<double>::quiet_NaN();
}

double rounded(const Figure& figure, double value) {
    return figure.jsonDecimals ? roundAsText(value, *figure.jsonDecimals) : value;
}

std::string withoutTrailingZeros(std::string number) {
    if (number.find('.') == std::string::npos) return number;
    number.erase(number.find_last_not_of('0') + 1);
    if (number.ends_with('.')) number.pop_back();
    return number;
}

std::string amountOf(const FigureLine& line, UnitSystem units) {
    const FigureUnit unit = line.figure->unit;
    if (unit == FigureUnit::squareMetres) return formatSmallArea(line.value, units);
    if (unit == FigureUnit::squareMetreHours) return formatAreaHours(line.value, units);
    const bool inHours = unit == FigureUnit::hours || unit == FigureUnit::hoursADay;
    const double amount = inHours                     ? line.value / minutesPerHour
                          : unit == FigureUnit::share ? 100 * line.value
                                                      : line.value;
    const int decimals = line.figure->isCount ? 0 : line.figure->shownDecimals;
    return localNumbers(withoutTrailingZeros(formatNumber(amount, decimals))) + localText(unitText(unit));
}

}  // namespace

std::span<const Choice<ShownAs>> shownChoices() { return shownList; }

std::string_view unitText(FigureUnit unit) {
    switch (unit) {
        case FigureUnit::minutes:
            return NM_TEXT(" min");
        case FigureUnit::minutesADay:
            return NM_TEXT(" min a day");
        case FigureUnit::hours:
            return NM_TEXT(" h");
        case FigureUnit::hoursADay:
            return NM_TEXT(" h a day");
        case FigureUnit::share:
        case FigureUnit::percent:
            return NM_TEXT(" %");
        default:
            return {};
    }
}

std::vector<FigureLine> listLines(const DescribedFigures& figures, FigureUse use,
                                  const FigureContext& context) {
    std::vector<FigureLine> lines;
    for (const Figure& figure : figures.figures) {
        const double value = figures.get(figure);
        if (figure.use != use || !isShownAs(figure, context.show) ||
            (context.isInstant && isTime(figure.unit)) || (figure.onlyIfPositive && !(value > 0)))
            continue;
        lines.push_back({&figure, value, computeShare(figure, value, context)});
    }
    return lines;
}

std::vector<FigureLine> listLines(const DescribedFigures& figures, const FigureContext& context) {
    std::vector<FigureLine> lines = listLines(figures, FigureUse::result, context);
    std::ranges::copy(listLines(figures, FigureUse::basis, context), std::back_inserter(lines));
    return lines;
}

std::string labelOf(const FigureLine& line) {
    const std::string label = localText(line.figure->label);
    if (line.measure.empty()) return label;
    const std::string over =
        line.thresholdMin
            ? fmt::format(" > {} min",
                          localNumbers(withoutTrailingZeros(formatNumber(*line.thresholdMin, 2))))
            : "";
    return fmt::format("{}{}: {}", localText(line.measure), over, isEnglishInUse() ? lowered(label) : label);
}

namespace {

// "0 m²" of what rounds to zero has none.
bool hasValue(std::string_view amount) {
    return amount.substr(0, amount.find(' ')).find_first_not_of("0.") != std::string_view::npos;
}

}  // namespace

std::string formatSigned(double value, int decimals) {
    const std::string number = formatNumber(value, decimals);
    return (value > 0 && hasValue(number) ? "+" : "") + number;
}

std::string valueOf(const FigureLine& line, UnitSystem units) {
    if (std::isnan(line.value)) return localText(NM_TEXT("not counted"));
    const std::string share =
        std::isnan(line.sharePct)
            ? std::string()
            : fmt::format(" ({} %)", localNumbers(withoutTrailingZeros(formatNumber(line.sharePct, 1))));
    const std::string amount = amountOf(line, units);
    const bool plus = line.figure->isChange && line.value > 0 && hasValue(amount);
    return fmt::format("{}{}{}", plus ? "+" : "", amount, share);
}

std::string joinLines(const std::vector<FigureLine>& lines) {
    std::string text;
    for (const FigureLine& line : lines)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                            isEnglishInUse() ? lowered(line.figure->label) : localText(line.figure->label),
                            valueOf(line));
    return text;
}

std::string definitionsOf(const std::vector<FigureLine>& lines) {
    std::string text;
    std::set<const Figure*> defined;
    for (const FigureLine& line : lines)
        if (!line.figure->definition.empty() && defined.insert(line.figure).second)
            text += fmt::format("{}{}: {}.", text.empty() ? "" : " ", localText(line.figure->label),
                                localText(line.figure->definition));
    return text;
}

std::string lowered(std::string_view label) {
    std::string text(label);
    if (!text.empty()) text[0] = char(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

void addPiece(std::span<const Figure> figures, void* whole, double wholeWeight, const void* piece,
              double pieceWeight) {
    const double weight = wholeWeight + pieceWeight;
    for (const Figure& figure : figures) {
        const double a = figure.get(whole), b = figure.get(piece);
        if (figure.together == Aggregation::sum) figure.set(whole, a + b);
        if (figure.together == Aggregation::max) figure.set(whole, std::max(a, b));
        if (figure.together == Aggregation::mean)
            figure.set(whole, weight > 0 ? (a * wholeWeight + b * pieceWeight) / weight : 0);
    }
}

const Figure& findFigure(std::span<const Figure> figures, std::string_view key) {
    return *std::ranges::find(figures, key, &Figure::key);
}

Json figuresJson(const DescribedFigures& figures) {
    Json json = Json::object();
    for (const Figure& figure : figures.figures) {
        if (!figure.inFiles) continue;
        const double value = figures.get(figure);
        json[std::string(figure.key)] =
            figure.isCount ? Json(std::uint64_t(value)) : Json(rounded(figure, value));
    }
    return json;
}

Json definitionsJson(std::span<const Figure> figures) {
    Json json = Json::object();
    for (const Figure& figure : figures)
        if (figure.inFiles && !figure.definition.empty()) json[std::string(figure.key)] = figure.definition;
    return json;
}

double figures::readFigure(const Figure& figure, const Json& json) {
    if (figure.valueIfMissing && !json.contains(figure.key)) return *figure.valueIfMissing;
    const Json& value = json.at(std::string(figure.key));
    if (figure.isCount) return double(wholeNumberFrom<std::size_t>(value));
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

std::vector<std::string> listColumns(std::span<const Figure> figures) {
    std::vector<std::string> columns;
    for (const Figure& figure : figures)
        if (figure.inFiles) columns.emplace_back(figure.key);
    return columns;
}

void addFigures(CsvText& csv, const DescribedFigures& figures) {
    for (const Figure& figure : figures.figures) {
        if (!figure.inFiles) continue;
        const double value = figures.get(figure);
        if (figure.isCount)
            csv.whole(std::uint64_t(value));
        else if (figure.decimals == allDigits)
            csv.number(value);
        else
            csv.number(value, figure.decimals);
    }
}

}  // namespace noonmark
