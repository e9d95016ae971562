#include "scenarios/weights/time_weights.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>

#include "core/base/csv_text.h"
#include "core/describe/text.h"
#include "core/io/files/plain_file.h"
#include "core/io/files/readable_text.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/text/error_text.h"

namespace noonmark {

namespace {

using namespace std::chrono;

constexpr std::array<const char*, 12> monthNames{"January",   "February", "March",    "April",
                                                 "May",       "June",     "July",     "August",
                                                 "September", "October",  "November", "December"};
constexpr std::array<double, 12> paperWeights{-1, -1, -0.5, 0, 0.5, 1, 1, 1, 0.5, 0, -0.5, -1};

bool holdsDate(const WeightedInterval& interval, month_day date) {
    if (interval.first <= interval.last) return interval.first <= date && date <= interval.last;
    return interval.first <= date || date <= interval.last;
}

Result<void> validate(const WeightedInterval& interval) {
    if (!(interval.weight >= -1 && interval.weight <= 1))
        return failure(fmt::format("A weight cannot be {:g}", interval.weight), interval.name,
                       "Give -1 (unwanted shadow) to 1 (wanted shade)");
    if (!interval.first.ok() || !interval.last.ok())
        return failure("A date is not in the calendar", interval.name, "Give a month and a day of it");
    if (interval.from < minutes(0) || interval.to > hours(24) || interval.from >= hours(24) ||
        interval.to < minutes(0) || interval.from == interval.to)
        return failure("The hours are not a valid range", interval.name,
                       "Give two different hours, 0:00 to 24:00; a later one first spans midnight");
    return {};
}

// The hours before and after midnight of one date.
bool holdsTime(const WeightedInterval& interval, minutes time) {
    if (interval.from < interval.to) return interval.from <= time && time < interval.to;
    return interval.from <= time || time < interval.to;
}

// Mean weight of all hours of three months of the northern half's summer or winter; time without a weight
// counts as 0.
double meanWeight(const TimeWeights& weights, sys_days first, sys_days end) {
    double sum = 0;
    for (sys_days day = first; day < end; day += days(1))
        for (hours hour(0); hour < hours(24); ++hour)
            for (const WeightedInterval& interval : weights.intervals)
                if (interval.holds(day, hour)) sum += interval.weight;
    return sum / double((end - first).count() * 24);
}

bool overlap(const WeightedInterval& a, const WeightedInterval& b) {
    const bool dates = holdsDate(a, b.first) || holdsDate(b, a.first);
    return dates && (holdsTime(a, b.from) || holdsTime(b, a.from));
}

}  // namespace

bool WeightedInterval::holds(CivilDate date, std::chrono::minutes timeOfDay) const {
    return holdsDate(*this, date.month() / date.day()) && holdsTime(*this, timeOfDay);
}

std::optional<Warning> findSeasonMismatch(const TimeWeights& weights, double latitudeDeg) {
    constexpr double tropicDeg = 23.44, minimum = 0.05;
    const auto wantsShade = [](const WeightedInterval& one) { return one.weight > 0; };
    if (std::abs(latitudeDeg) <= tropicDeg || std::ranges::none_of(weights.intervals, wantsShade))
        return std::nullopt;
    const double juneToAugust =
        meanWeight(weights, sys_days(2001y / June / 1), sys_days(2001y / September / 1));
    const double decemberToFebruary =
        meanWeight(weights, sys_days(2001y / December / 1), sys_days(2002y / March / 1));
    const double summerMinusWinter =
        latitudeDeg > 0 ? juneToAugust - decemberToFebruary : decemberToFebruary - juneToAugust;
    if (summerMinusWinter > -minimum) return std::nullopt;
    return Warning{
        WarningKind::assumed,
        fmt::format("the weights want more shade in {}, the winter of this place, than in its summer",
                    latitudeDeg > 0 ? "December to February" : "June to August"),
        weights.name};
}

TimeWeights makeMonthlyWeights() {
    TimeWeights table{NM_TEXT("default"), {}};
    for (unsigned i = 0; i < 12; ++i) {
        const month at{i + 1};
        table.intervals.push_back({.name = monthNames[i],
                                   .first = at / 1,
                                   .last = month_day(at, (2000y / at / std::chrono::last).day()),
                                   .weight = paperWeights[i]});
    }
    return table;
}

Result<void> validate(const TimeWeights& weights) {
    if (weights.name.empty()) return failure("The table has no name", "time weights", "Give it a name");
    if (weights.intervals.empty())
        return failure("The table has no intervals", weights.name, "Add months or dates with a weight");
    for (std::size_t i = 0; i < weights.intervals.size(); ++i) {
        if (const auto sound = validate(weights.intervals[i]); !sound) return sound;
        for (std::size_t j = 0; j < i; ++j)
            if (overlap(weights.intervals[j], weights.intervals[i]))
                return failure(fmt::format("'{}' and '{}' overlap", weights.intervals[j].name,
                                           weights.intervals[i].name),
                               weights.name, "Give every time only one weight");
    }
    return {};
}

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

Result<std::chrono::minutes> hourOf(const Row& row, const char* column, std::chrono::minutes standard) {
    const std::string text = row[column];
    if (text.empty()) return standard;
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
