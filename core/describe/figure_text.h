#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/csv_text.h"
#include "core/describe/figure.h"

namespace noonmark {

/// The figures by key, in the order of the table; what was not counted is null.
nlohmann::ordered_json figuresJson(const DescribedFigures& figures);

/// What the figures mean, by key.
nlohmann::ordered_json definitionsJson(std::span<const Figure> figures);

/// Reads what figuresJson() wrote, also in an earlier version. Null is NaN. Throws nlohmann's exceptions for
/// JSON of another structure, std::out_of_range for a count that is none.
template <class R>
R readFigures(const Figures<R>& table, const nlohmann::ordered_json& json);

/// The keys as columns of a table.
std::vector<std::string> listColumns(std::span<const Figure> figures);

/// Adds the figures to a row, with their decimals.
void addFigures(CsvText& csv, const DescribedFigures& figures);

namespace figures {
double readFigure(const Figure& figure, const nlohmann::ordered_json& json);
}

template <class R>
R readFigures(const Figures<R>& table, const nlohmann::ordered_json& json) {
    R result;
    for (const Figure& figure : table.rows()) figure.set(&result, figures::readFigure(figure, json));
    return result;
}

}  // namespace noonmark
