#pragma once

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "core/base/warnings.h"

namespace noonmark::cli {

/// Lines of "label  value" with aligned values.
class Table {
public:
    void add(std::string label, std::string value) { rows_.emplace_back(std::move(label), std::move(value)); }
    void print(std::ostream& out) const;

private:
    std::vector<std::pair<std::string, std::string>> rows_;
};

/// A line that says how much of the region was left out as water; nothing for none.
void addWater(Table& table, double waterM2);

/// "1,234,567"
std::string withCommas(std::size_t number);

/// Prints a heading and one line per group of warnings; nothing without warnings.
void printWarnings(std::ostream& out, const Warnings& warnings);

}  // namespace noonmark::cli
