#include "scenarios/weights/weights_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <vector>

#include "core/base/csv_rows.h"
#include "core/base/csv_text.h"
#include "core/io/files/fold_text.h"
#include "core/io/files/plain_file.h"
#include "core/study/provenance/source_columns.h"
#include "core/study/text/warnings_json.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::array columns{"name", "first", "last", "from", "to", "weight"};
constexpr std::size_t largestFile = 1'000'000;

// The texts of one interval; `where` tells the user which one.
struct Row {
    std::string where;
    std::map<std::string, std::string> fields;

    [[nodiscard]] std::string operator[](const char* column) const {
        const auto found = fields.find(column);
        return found == fields.end() ? "" : found->second;
    }
};

std::string formatText(std::chrono::month_day date) {
    return fmt::format("{:02}-{:02}", unsigned(date.month()), unsigned(date.day()));
}

// "Jun" means its first day where an interval begins, its last where it ends.
std::optional<std::chrono::month_day> monthAsDay(const std::string& text, bool last) {
    const std::string folded = foldText(text);
    if (folded.size() < 3) return std::nullopt;
    for (const WeightedInterval& month : makeMonthlyWeights().intervals)
        if (foldText(month.name).starts_with(folded)) return last ? month.last : month.first;
    return std::nullopt;
}

Result<std::chrono::month_day> dayOf(const Row& row, const char* column) {
    const std::string text = row[column];
    if (const auto month = monthAsDay(text, column == std::string_view("last"))) return *month;
    unsigned month = 0, day = 0;
    const char* const end = text.data() + text.size();
    const auto [dash, first] = std::from_chars(text.data(), end, month);
    if (first == std::errc{} && dash != end && *dash == '-') {
        const auto [last, second] = std::from_chars(dash + 1, end, day);
        const std::chrono::month_day date{std::chrono::month(month), std::chrono::day(day)};
        // chrono stores months and days in bytes: 257 would become 1.
        if (second == std::errc{} && last == end && month <= 12 && day <= 31 && date.ok()) return date;
    }
    return failure(fmt::format("'{}' is not a day of the year", text),
                   fmt::format("{}, {}", row.where, column), "Give month and day: 12-31, or a month: June");
}

Result<std::chrono::minutes> hourOf(const Row& row, const char* column, std::chrono::minutes usual) {
    const std::string text = row[column];
    if (text.empty()) return usual;
    return parseTimeOfDay(text).map_error([&](Error error) {
        error.where = fmt::format("{}, {}", row.where, column);
        return error;
    });
}

Result<double> weightOf(const Row& row) {
    const std::string text = row["weight"];
    double weight = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, weight);
    if (error == std::errc{} && rest == end && weight >= -1 && weight <= 1) return weight;
    return failure(fmt::format("'{}' is not a weight", text), row.where,
                   "Give -1 (unwanted shadow) to 1 (wanted shade)");
}

Result<WeightedInterval> intervalOf(const Row& row) {
    for (const auto& [key, value] : row.fields)
        if (std::ranges::find(columns, key) == columns.end())
            return failure(fmt::format("There is no column '{}'", key), row.where,
                           fmt::format("The columns are: {}", fmt::join(columns, ", ")));
    const auto first = dayOf(row, "first"), last = dayOf(row, "last");
    if (!first) return tl::make_unexpected(first.error());
    if (!last) return tl::make_unexpected(last.error());
    WeightedInterval interval{.name = row["name"], .first = *first, .last = *last};
    const auto from = hourOf(row, "from", interval.from), to = hourOf(row, "to", interval.to);
    if (!from) return tl::make_unexpected(from.error());
    if (!to) return tl::make_unexpected(to.error());
    const auto weight = weightOf(row);
    if (!weight) return tl::make_unexpected(weight.error());
    interval.from = *from;
    interval.to = *to;
    interval.weight = *weight;
    if (interval.name.empty()) interval.name = formatText(*first) + " to " + formatText(*last);
    return interval;
}

Result<TimeWeights> tableOf(const std::vector<Row>& rows, const std::string& name) {
    TimeWeights table{name, {}};
    for (const Row& row : rows) {
        auto interval = intervalOf(row);
        if (!interval) return tl::make_unexpected(interval.error());
        table.intervals.push_back(*std::move(interval));
    }
    return validate(table).map([&] { return table; });
}

}  // namespace

std::map<std::string, std::string> textsOf(const WeightedInterval& interval) {
    return {{"name", interval.name},
            {"first", formatText(interval.first)},
            {"last", formatText(interval.last)},
            {"from", noonmark::formatText(interval.from)},
            {"to", noonmark::formatText(interval.to)},
            {"weight", fmt::to_string(interval.weight)}};
}

Result<WeightedInterval> intervalFrom(const std::map<std::string, std::string>& texts,
                                      const std::string& where) {
    return intervalOf(Row{where, texts});
}

std::string weightsCsv(const TimeWeights& weights) {
    CsvText csv({columns.begin(), columns.end()});
    for (const WeightedInterval& interval : weights.intervals) {
        const auto texts = textsOf(interval);
        for (const char* column : columns) csv.text(texts.at(column));
        csv.endRow();
    }
    return csv.take();
}

std::string weightsJson(const TimeWeights& weights) {
    Json entries = Json::array();
    for (const WeightedInterval& interval : weights.intervals) {
        const auto texts = textsOf(interval);
        Json& entry = entries.emplace_back(Json::object());
        for (const char* column : columns) entry[column] = texts.at(column);
        entry["weight"] = interval.weight;
    }
    return toJsonText(entries);
}

Result<TimeWeights> parseWeightsCsv(std::string_view text, const std::string& name) {
    const auto lines = parseCsvRows(text);
    if (lines.empty()) return failure("The table is empty", name, "Start from the output of `weights show`");
    std::vector<Row> rows;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const std::vector<std::string>&heading = lines[0].fields, &fields = lines[i].fields;
        Row row{fmt::format("line {}", lines[i].line), {}};
        if (fields.size() != heading.size())
            return failure(
                fmt::format("The row has {} fields, the heading {}", fields.size(), heading.size()),
                row.where, "Give a field for every column");
        for (std::size_t column = 0; column < fields.size(); ++column)
            if (!row.fields.emplace(foldText(heading[column]), fields[column]).second)
                return failure(fmt::format("The column '{}' appears twice", heading[column]), "heading",
                               "Remove one of them");
        rows.push_back(std::move(row));
    }
    return tableOf(rows, name);
}

Result<TimeWeights> parseWeightsJson(std::string_view text, const std::string& name) {
    const Json entries = Json::parse(text, nullptr, false);
    if (!entries.is_array())
        return failure("The text is not a JSON array of intervals", name,
                       "Start from the output of `weights show --json`");
    std::vector<Row> rows;
    for (const Json& entry : entries) {
        Row row{fmt::format("entry {}", rows.size() + 1), {}};
        if (!entry.is_object())
            return failure("The entry is not an object", row.where, "Give {\"first\": \"06-01\", ...}");
        for (const auto& [key, value] : entry.items())
            row.fields[key] = value.is_string() ? value.get<std::string>() : value.dump();
        rows.push_back(std::move(row));
    }
    return tableOf(rows, name);
}

Result<TimeWeights> readWeights(const std::filesystem::path& file, const std::string& name) {
    if (const auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    std::ifstream stream(file, std::ios::binary);
    std::string text(largestFile + 1, '\0');
    stream.read(text.data(), std::streamsize(text.size()));
    text.resize(std::size_t(std::max<std::streamsize>(0, stream.gcount())));
    if (text.empty()) return failure("The file cannot be read, or is empty", file.string(), "Check its name");
    if (text.size() > largestFile)
        return failure("The file is too large for a time-weight table", file.string(),
                       "Give a table of less than 1 MB");
    const auto start = text.find_first_not_of(" \t\r\n");
    const bool json = start != std::string::npos && (text[start] == '[' || text[start] == '{');
    return (json ? parseWeightsJson(text, name) : parseWeightsCsv(text, name)).map_error([&](Error error) {
        error.where = fmt::format("{}, {}", file.string(), error.where);
        return error;
    });
}

}  // namespace noonmark
