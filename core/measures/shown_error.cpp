#include "core/measures/shown_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/base/wording.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::array shownErrorTable{
    ErrorFacts{"cell_gross", NM_TEXT("Gross shadow of a cell")},
    ErrorFacts{"cell_continuous", NM_TEXT("Longest shadow of a cell"), FigureUnit::minutes},
    ErrorFacts{"cell_month", NM_TEXT("Shadow of a cell in a month")},
    ErrorFacts{"change_gross", NM_TEXT("Change of gross shadow of a cell")},
    ErrorFacts{"change_continuous", NM_TEXT("Change of the longest shadow of a cell"), FigureUnit::minutes},
    ErrorFacts{"cell_score", NM_TEXT("Score of a cell"), FigureUnit::none},
    ErrorFacts{"score_m2", NM_TEXT("Shadow score"), FigureUnit::squareMetres},
    ErrorFacts{"weighted_shade_m2h", NM_TEXT("Weighted shade"), FigureUnit::squareMetreHours},
    ErrorFacts{"month_shadow_m2", NM_TEXT("Shadow area of a month"), FigureUnit::squareMetres},
    ErrorFacts{"month_score_m2", NM_TEXT("Shadow score of a month"), FigureUnit::squareMetres},
    ErrorFacts{"month_shade_m2h", NM_TEXT("Weighted shade of a month"), FigureUnit::squareMetreHours},
    ErrorFacts{"interval_shadow_m2", NM_TEXT("Shadow area of an interval"), FigureUnit::squareMetres},
    ErrorFacts{"interval_score_m2", NM_TEXT("Shadow score of an interval"), FigureUnit::squareMetres},
    ErrorFacts{"interval_shade_m2h", NM_TEXT("Weighted shade of an interval"), FigureUnit::squareMetreHours},
    ErrorFacts{"cell_sun", NM_TEXT("Least and most sun of a place, at a cell")},
    ErrorFacts{"place_mean", NM_TEXT("Mean sun of a place")},
    ErrorFacts{"place_small", NM_TEXT("Mean sun of a small place with cells of its own")},
    ErrorFacts{"place_month", NM_TEXT("Mean sun of a place in a month")},
    ErrorFacts{"place_enough", NM_TEXT("Share of a place with enough sun"), FigureUnit::share},
    ErrorFacts{"place_date", NM_TEXT("Mean sun of a place on a date")},
    ErrorFacts{"place_below", NM_TEXT("Share of a place with less than enough sun on a date"),
               FigureUnit::share},
    ErrorFacts{"place_change", NM_TEXT("Change of the mean sun of a place")},
    ErrorFacts{"cell_change", NM_TEXT("Largest loss and gain of a place, at a cell")},
    ErrorFacts{"place_lost", NM_TEXT("Share of a place that loses sun"), FigureUnit::share},
};

ShownError ofCells(std::string_view key, const CellError& error, std::size_t count) {
    return {findErrorFacts(key), {}, error.meanMin, error.p99Min, error.maxMin, count};
}

std::string_view unitKeyOf(FigureUnit unit) {
    switch (unit) {
        case FigureUnit::minutesADay:
            return "min_per_day";
        case FigureUnit::minutes:
            return "min";
        case FigureUnit::squareMetres:
            return "m2";
        case FigureUnit::squareMetreHours:
            return "m2h";
        case FigureUnit::share:
            return "share";
        default:
            return "1";
    }
}

bool isKnown(std::string_view key) {
    return std::ranges::find(shownErrorTable, key, &ErrorFacts::key) != shownErrorTable.end();
}

// The smallest error that is stated: the rounding of single precision lies below it.
double smallest(FigureUnit unit) { return unit == FigureUnit::share ? 0.00001 : 0.001; }

// Two digits that mean something: errors are small.
Amount amountOf(double value, FigureUnit unit) {
    const double shown = unit == FigureUnit::share ? 100 * value : value;
    const int decimals = shown > 0 ? std::clamp(1 - int(std::floor(std::log10(shown))), 0, 6) : 0;
    return {value, unit, decimals};
}

}  // namespace

const ErrorFacts& findErrorFacts(std::string_view key) {
    return *std::ranges::find(shownErrorTable, key, &ErrorFacts::key);
}

ShownError sumUpError(std::string_view key, std::vector<double> off, std::string of) {
    ShownError error{findErrorFacts(key), std::move(of)};
    error.count = off.size();
    error.mean = std::accumulate(off.begin(), off.end(), 0.0) / double(off.size());
    error.largest = std::ranges::max(off);
    const auto rank = std::size_t(std::ceil(0.99 * double(off.size()))) - 1;  // nearest rank
    std::ranges::nth_element(off, off.begin() + std::ptrdiff_t(rank));
    error.p99 = off[rank];
    return error;
}

ShownError sumUpTotalError(std::string_view key, std::span<const double> differences, double size) {
    constexpr double deviations = 2.58;  // 99 % of a normal distribution
    const auto count = double(differences.size());
    const double mean = std::accumulate(differences.begin(), differences.end(), 0.0) / count;
    double squares = 0;
    for (const double one : differences) squares += (one - mean) * (one - mean);
    const double spread = count > 1 ? std::sqrt(squares / (count - 1) / count) : std::abs(mean);
    return {findErrorFacts(key),
            {},
            std::abs(mean) * size,
            (std::abs(mean) + deviations * spread) * size,
            std::numeric_limits<double>::quiet_NaN(),
            differences.size()};
}

std::vector<ShownError> listErrors(const SampledError& error, bool ofChange) {
    std::vector<ShownError> errors{
        ofCells(ofChange ? "change_gross" : "cell_gross", error.gross, error.receivers)};
    if (hasRuns(error))
        errors.push_back(
            ofCells(ofChange ? "change_continuous" : "cell_continuous", error.continuous, error.receivers));
    return errors;
}

std::string labelOf(const ShownError& error) {
    const std::string label = localText(error.facts.label);
    return error.of.empty() ? label : label + ", " + error.of;
}

std::string formatDifference(double difference, FigureUnit unit) {
    if (std::isnan(difference)) return {};
    if (difference == 0 || difference >= smallest(unit)) return valueOf(amountOf(difference, unit));
    return "< " + valueOf({smallest(unit), unit, 3});
}

Sentence describe(const ShownError& error) {
    const Amount mean = amountOf(error.mean, error.facts.unit), p99 = amountOf(error.p99, error.facts.unit);
    if (std::isnan(error.largest)) return {NM_TEXT("%1, with 99 % certainty within %2"), {mean, p99}};
    if (error.largest == 0) return {NM_TEXT("%1 everywhere"), {mean}};
    if (error.largest < smallest(error.facts.unit))
        return {NM_TEXT("%1 at most"), {Amount{smallest(error.facts.unit), error.facts.unit, 3}}};
    return {NM_TEXT("%1 in the mean, 99 of 100 within %2, at most %3"),
            {mean, p99, amountOf(error.largest, error.facts.unit)}};
}

Json errorsJson(std::span<const ShownError> errors) {
    Json list = Json::array();
    for (const ShownError& error : errors) {
        Json one{{"quantity", error.facts.key}};
        if (!error.of.empty()) one["of"] = error.of;
        one["unit"] = unitKeyOf(error.facts.unit);
        one["mean"] = error.mean;
        one["p99"] = error.p99;
        one["max"] = std::isnan(error.largest) ? Json() : Json(error.largest);
        one["values"] = error.count;
        list.push_back(std::move(one));
    }
    return list;
}

std::vector<ShownError> parseErrors(const Json& json) {
    std::vector<ShownError> errors;
    for (const Json& one : json) {
        const auto key = one.at("quantity").get<std::string>();
        if (!isKnown(key)) continue;
        const Json& largest = one.at("max");
        errors.push_back(
            {findErrorFacts(key), one.value("of", std::string()), one.at("mean"), one.at("p99"),
             largest.is_null() ? std::numeric_limits<double>::quiet_NaN() : largest.get<double>(),
             one.at("values")});
    }
    return errors;
}

}  // namespace noonmark
