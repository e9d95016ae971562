#include <fmt/format.h>

#include "core/base/clean_text.h"
#include "core/describe/field_checks.h"
#include "core/describe/field_json.h"
#include "core/sun/period_fields.h"
#include "scenarios/project/read_project.h"
#include "scenarios/project/tables/checked_row.h"
#include "scenarios/project/tables/schema.h"
#include "scenarios/project/write_project.h"

// Reads and writes the table `periods`. Since version 9 its column `settings` holds every field of a period
// as JSON, and is what the program reads. The columns of version 1 are written beside it for people and
// scripts that read them; a field that is new since then has none.
namespace noonmark {

namespace {

constexpr NumberLimits dayMinutes{0, 24 * 60};
constexpr NumberLimits offsetMinutes{-12 * 60, 12 * 60};
constexpr const char* centreName = "centre";

// The range of a field of a period, which has one.
NumberLimits limitsOf(std::string_view key) {
    const auto fields = periodFields().rows();
    const ValueRange range = std::ranges::find(fields, key, &Field::key)->range.value();
    return {range.min, range.max};
}

std::string settingsText(const Period& period) {
    return fieldsJson(periodFields().of(period), {.which = FieldJson::Which::all})
        .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

// From the columns of version 1; `row` begins with the id.
Period periodOfColumns(const Statement& row) {
    Period period;
    const CheckedRow checked(row, "periods");
    const auto start = parseDate(row.text(1));
    if (!start) checked.refuse("the date is not valid");
    period.start = *start;
    period.days = checked.integer(2, "days", limitsOf("days"));
    period.from = std::chrono::minutes(checked.integer(3, "from_min", dayMinutes));
    period.hours = checked.number(4, "hours", limitsOf("hours"));
    period.stepMinutes = checked.number(5, "step_min", limitsOf("step_min"));
    if (!row.isNull(6))
        period.window =
            SolarHours{std::chrono::minutes(checked.integer(6, "after_sunrise_min", offsetMinutes)),
                       std::chrono::minutes(checked.integer(7, "before_sunset_min", offsetMinutes)),
                       row.text(8) == centreName ? SunriseRule::centre : SunriseRule::upperLimb};
    period.zone = row.text(9);
    period.refraction = row.integer(10) != 0;
    return period;
}

Period periodOf(const Statement& row) {
    const CheckedRow checked(row, "periods");
    const auto json = nlohmann::ordered_json::parse(row.text(2), nullptr, false);
    if (!json.is_object()) checked.refuse("the settings are not a JSON object");
    Period period;
    const Editable settings = periodFields().of(period);
    if (const auto read = readFieldsJson(settings, json); !read) checked.refuse(read.error().text());
    if (const auto ranges = checkRanges(settings); !ranges) checked.refuse(ranges.error().text());
    return period;
}

}  // namespace

void addPeriodSettings(Database& database) {
    Statement set = database.prepare("UPDATE periods SET settings = ? WHERE id = ?");
    Statement row = database.prepare(
        "SELECT id, start, days, from_min, hours, step_min, after_sunrise_min, before_sunset_min, "
        "sunrise_rule, zone, refraction FROM periods");
    while (row.step()) set.run(settingsText(periodOfColumns(row)), row.integer(0));
}

void writePeriods(Database& database, const std::vector<NamedPeriod>& periods) {
    database.execute("DELETE FROM periods");
    Statement add = database.prepare(
        "INSERT INTO periods (name, start, days, from_min, hours, step_min, after_sunrise_min, "
        "before_sunset_min, sunrise_rule, zone, refraction, settings) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
        "?, ?)");
    for (const auto& [name, period] : periods) {
        std::optional<int> after, before;
        std::optional<std::string> rule;
        if (period.window) {
            after = int(period.window->afterSunrise.count());
            before = int(period.window->beforeSunset.count());
            rule = period.window->rule == SunriseRule::centre ? centreName : "upper limb";
        }
        add.run(name, formatText(period.start), period.days, int(period.from.count()), period.hours,
                period.stepMinutes, after, before, rule, period.zone, period.refraction,
                settingsText(period));
    }
}

std::vector<NamedPeriod> readPeriods(Database& database) {
    std::vector<NamedPeriod> periods;
    Statement row = database.prepare("SELECT id, name, settings FROM periods ORDER BY id");
    while (row.step()) periods.push_back({cleanText(row.text(1)), periodOf(row)});
    return periods;
}

}  // namespace noonmark
