#include "core/study/verification/result_record.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "core/base/csv_text.h"
#include "core/base/safe_text.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 16> notCompared{"seconds",
                                                       "accumulate_seconds",
                                                       "write_seconds",
                                                       "mega_rays_per_s",
                                                       "rays",
                                                       "skipped",
                                                       "buildings_skipped",
                                                       "program",
                                                       "engine",
                                                       "engine_settings",
                                                       "instruction_set",
                                                       "repeat",
                                                       "repeat_note",
                                                       "path",
                                                       "contributions_of_places",
                                                       "verdicts"};
bool isCompared(const std::string& key) { return std::ranges::find(notCompared, key) == notCompared.end(); }

// The values of a record by their paths, in order of appearance.
class Leaves {
public:
    explicit Leaves(const Json& record) { collect(record, {}); }
    std::vector<std::pair<std::string, const Json*>> all;

private:
    void collect(const Json& json, const std::string& path) {
        if (json.is_object()) {
            for (const auto& [key, value] : json.items())
                if (isCompared(key)) collect(value, path.empty() ? key : fmt::format("{}.{}", path, key));
        } else if (json.is_array()) {
            for (std::size_t i = 0; i < json.size(); ++i) collect(json[i], fmt::format("{}[{}]", path, i));
        } else {
            all.emplace_back(path, &json);
        }
    }
};

bool agree(const Json& a, const Json& b) {
    if (!a.is_number() || !b.is_number()) return a == b;
    return noonmark::agree(a.get<double>(), b.get<double>());
}

std::string textOf(const Json* json) {
    return json ? json->dump(-1, ' ', false, Json::error_handler_t::replace) : std::string();
}

}  // namespace

bool agree(double recorded, double computed) {
    constexpr double agreement = 1e-9;
    return recorded == computed ||
           std::abs(recorded - computed) <= agreement * std::max(std::abs(recorded), std::abs(computed));
}

RecordComparison compareRecords(const Json& recorded, const Json& computed) {
    const Leaves before(recorded), after(computed);
    std::map<std::string, const Json*> left(after.all.begin(), after.all.end());
    RecordComparison result;
    for (const auto& [path, value] : before.all) {
        const auto found = left.find(path);
        if (found == left.end()) {
            result.differences.push_back({path, textOf(value), {}});
            continue;
        }
        ++result.compared;
        if (!agree(*value, *found->second))
            result.differences.push_back({path, textOf(value), textOf(found->second)});
        left.erase(found);
    }
    for (const auto& [path, value] : left) result.differences.push_back({path, {}, textOf(value)});
    return result;
}

namespace {

using RowFields = std::vector<std::string>;

std::optional<double> numberIn(const std::string& text) {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc{} && rest == end ? std::optional(number) : std::nullopt;
}

bool agreeAsFields(const std::string& recorded, const std::string& computed) {
    if (recorded == computed) return true;
    const auto a = numberIn(recorded), b = numberIn(computed);
    return a && b && agree(*a, *b);
}

/// Compares row by row.
class TableReading {
public:
    TableReading(const std::string& name, const std::vector<CsvRow>& recorded,
                 const std::vector<CsvRow>& computed, const std::vector<std::string>& leftOut)
        : recorded_(recorded), computed_(computed), leftOut_(leftOut) {
        result_.name = name;
    }

    TableComparison compare() && {
        for (std::size_t row = 0; row < std::max(recorded_.size(), computed_.size()); ++row) {
            if (row >= recorded_.size() || row >= computed_.size())
                differ(row, "", std::string(row < recorded_.size() ? "a row" : ""),
                       std::string(row < computed_.size() ? "a row" : ""));
            else
                compareRow(row, recorded_[row].fields, computed_[row].fields);
        }
        return std::move(result_);
    }

private:
    void compareRow(std::size_t row, const RowFields& recorded, const RowFields& computed) {
        const RowFields& heading = recorded_.front().fields;
        if (recorded.size() != heading.size())
            differ(row, "", fmt::format("{} fields", recorded.size()),
                   fmt::format("{} in the heading", heading.size()));
        else if (recorded.size() != computed.size())
            differ(row, "", fmt::format("{} fields", recorded.size()), fmt::format("{}", computed.size()));
        else
            for (std::size_t i = 0; i < recorded.size(); ++i) {
                if (std::ranges::find(leftOut_, heading[i]) != leftOut_.end()) continue;
                ++result_.fields;
                if (!agreeAsFields(recorded[i], computed[i]))
                    differ(row, ", " + heading[i], recorded[i], computed[i]);
            }
    }

    void differ(std::size_t row, const std::string& column, std::string recorded, std::string computed) {
        const std::size_t line = row < recorded_.size() ? recorded_[row].line : computed_[row].line;
        result_.differences.push_back({fmt::format("{}, line {}{}", result_.name, line, column),
                                       std::move(recorded), std::move(computed)});
    }

    const std::vector<CsvRow>&recorded_, &computed_;
    const std::vector<std::string>& leftOut_;
    TableComparison result_;
};

}  // namespace

TableComparison compareTables(const std::string& name, std::string_view recorded, std::string_view computed,
                              const std::vector<std::string>& leftOut) {
    const auto before = parseCsvRows(recorded), after = parseCsvRows(computed);
    return TableReading(name, before, after, leftOut).compare();
}

namespace {

using Words = std::vector<std::string>;

constexpr std::size_t matchWords = 3;
constexpr std::size_t searchedWords = 400;
constexpr std::size_t wordsBefore = 4;

bool hasDigit(const std::string& word) {
    return std::ranges::any_of(word, [](char c) { return c >= '0' && c <= '9'; });
}

// Durations of the computation become a star: "0.1 s in total".
void maskDurations(Words& words) {
    for (std::size_t i = 0; i + 3 < words.size(); ++i)
        if (hasDigit(words[i]) && words[i + 2] == "in" && words[i + 3].starts_with("total")) words[i] = "*";
}

Words wordsOf(const std::string& text) {
    std::istringstream stream(text);
    Words words;
    for (std::string word; stream >> word;) words.push_back(std::move(word));
    maskDurations(words);
    return words;
}

bool matches(const Words& a, std::size_t i, const Words& b, std::size_t j) {
    if (i == a.size() && j == b.size()) return true;
    const std::size_t maximum = std::min({matchWords, a.size() - i, b.size() - j});
    return maximum > 0 && std::equal(a.begin() + std::ptrdiff_t(i), a.begin() + std::ptrdiff_t(i + maximum),
                                     b.begin() + std::ptrdiff_t(j));
}

// The nearest place at which both texts go on alike; their ends if there is none.
std::pair<std::size_t, std::size_t> findMatch(const Words& a, std::size_t i, const Words& b, std::size_t j) {
    for (std::size_t distance = 1; distance <= searchedWords; ++distance)
        for (std::size_t skipped = 0; skipped <= distance; ++skipped)
            if (i + skipped <= a.size() && j + distance - skipped <= b.size() &&
                matches(a, i + skipped, b, j + distance - skipped))
                return {i + skipped, j + distance - skipped};
    return {a.size(), b.size()};
}

std::string join(const Words& words, std::size_t from, std::size_t to) {
    std::string text;
    for (std::size_t i = from; i < to; ++i) text += (i > from ? " " : "") + words[i];
    return text;
}

}  // namespace

WordComparison compareWords(const std::string& recorded, const std::string& computed) {
    const Words a = wordsOf(recorded), b = wordsOf(computed);
    WordComparison result{std::size_t(std::ranges::count_if(a, hasDigit)), {}};
    std::size_t i = 0, j = 0;
    while (i < a.size() || j < b.size()) {
        if (i < a.size() && j < b.size() && a[i] == b[j]) {
            ++i, ++j;
            continue;
        }
        const auto [nextI, nextJ] = findMatch(a, i, b, j);
        WordDifference difference{join(a, i - std::min(i, wordsBefore), i), join(a, i, nextI),
                                  join(b, j, nextJ), false};
        difference.hasFigure = hasDigit(difference.recorded) || hasDigit(difference.computed);
        result.differences.push_back(std::move(difference));
        i = nextI;
        j = nextJ;
    }
    return result;
}

}  // namespace noonmark
