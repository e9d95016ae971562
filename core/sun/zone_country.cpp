#include "core/sun/zone_country.h"

#include <algorithm>
#include <fstream>
#include <vector>

namespace noonmark {

namespace {

std::vector<std::string> splitTabs(const std::string& line) {
    std::vector<std::string> fields(1);
    for (const char letter : line)
        if (letter == '\t')
            fields.emplace_back();
        else
            fields.back() += letter;
    return fields;
}

/// The field `wanted` of the first line of a table of the tz database whose field `key` is `value`.
std::string findInTable(const char* table, std::size_t key, std::string_view value, std::size_t wanted) {
    std::ifstream file(std::string("/usr/share/zoneinfo/") + table);
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) continue;
        const std::vector<std::string> fields = splitTabs(line);
        if (fields.size() > std::max(key, wanted) && fields[key] == value) return fields[wanted];
    }
    return {};
}

}  // namespace

std::string countryOfZone(std::string_view zone) { return findInTable("zone.tab", 2, zone, 0); }

std::string countryName(std::string_view code) {
    std::string name = findInTable("iso3166.tab", 0, code, 1);
    return name.empty() ? std::string(code) : name;
}

}  // namespace noonmark
