#include "core/describe/figure_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/json_number.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

const Figure& findFigure(std::span<const Figure> figures, std::string_view key) {
    return *std::ranges::find(figures, key, &Figure::key);
}

Json figuresJson(const DescribedFigures& figures) {
    Json json = Json::object();
    for (const Figure& figure : figures.figures) {
        const double value = figures.get(figure);
        json[std::string(figure.key)] = figure.isCount ? Json(std::uint64_t(value)) : Json(value);
    }
    return json;
}

Json definitionsJson(std::span<const Figure> figures) {
    Json json = Json::object();
    for (const Figure& figure : figures)
        if (!figure.definition.empty()) json[std::string(figure.key)] = figure.definition;
    return json;
}

double figures::readFigure(const Figure& figure, const Json& json) {
    if (figure.whenMissing && !json.contains(figure.key)) return *figure.whenMissing;
    const Json& value = json.at(std::string(figure.key));
    if (figure.isCount) return double(wholeNumberFrom<std::size_t>(value));
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

std::vector<std::string> listColumns(std::span<const Figure> figures) {
    std::vector<std::string> columns;
    for (const Figure& figure : figures) columns.emplace_back(figure.key);
    return columns;
}

void addFigures(CsvText& csv, const DescribedFigures& figures) {
    for (const Figure& figure : figures.figures) {
        const double value = figures.get(figure);
        if (figure.isCount)
            csv.whole(std::uint64_t(value));
        else
            csv.number(value, figure.decimals);
    }
}

}  // namespace noonmark
