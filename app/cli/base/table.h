#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/warnings.h"
#include "core/describe/figure_text.h"
#include "core/measures/shown_error.h"

namespace noonmark::cli {

/// Lines of "label  value" with aligned values.
class Table {
public:
    void add(std::string label, std::string value) { rows_.emplace_back(std::move(label), std::move(value)); }
    void print(std::ostream& out) const;

private:
    std::vector<std::pair<std::string, std::string>> rows_;
};

/// A row for each figure.
void addFigures(Table& table, const std::vector<FigureLine>& lines);
/// The same on one row: "more shadow 12 m2, less shadow 0 m2".
void addFigures(Table& table, std::string label, const std::vector<FigureLine>& lines);

/// A row for each: "error: mean sun of a place".
void addErrors(Table& table, std::span<const ShownError> errors);

/// "1,234,567"
std::string withCommas(std::size_t number);

/// Prints a heading and one line per group of warnings; nothing without warnings.
void printWarnings(std::ostream& out, const Warnings& warnings);

}  // namespace noonmark::cli
