#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/safe_text.h"
#include "core/describe/field_json.h"
#include "core/describe/field_values.h"
#include "core/sun/period_fields.h"
#include "scenarios/project/read_project.h"
#include "scenarios/project/tables/database.h"
#include "scenarios/project/tables/schema.h"
#include "scenarios/project/title_fields.h"
#include "scenarios/project/write_project.h"

namespace noonmark {

// Reads and writes the table `periods`. Since version 9 its column `settings` holds every field of a period
// as JSON, and is what the program reads. The columns of version 1 are written beside it for people and
// scripts that read them; a field that is new since then has none.

namespace {

constexpr NumberLimits offsetMinutes{-12 * 60, 12 * 60};
constexpr const char* centreName = "centre";

// The range of a field of a period, which has one.
NumberLimits limitsOf(std::string_view key) {
    const ValueRange range = *fieldWithKey(periodFields().rows(), key).range;
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

// Reads and writes the table `sheet_settings`: what the project's sheets carry, and the units of its results.

namespace {

constexpr const char* logoKey = "logo";

void readSetting(const Statement& row, SheetSettings& settings) {
    const std::string key = row.text(0);
    if (key == logoKey) settings.titleBlock.logo = row.blob(1);
    const Editable fields = sheetFields().of(settings);
    for (const Field& field : fields.fields)
        if (key == field.key && !fields.set(field, row.text(1)))
            throwDamaged(fmt::format("the {} of the sheets are unknown", key));
}

}  // namespace

void writeSheetSettings(Database& database, const SheetSettings& settings) {
    database.execute("DELETE FROM sheet_settings");
    Statement add = database.prepare("INSERT INTO sheet_settings (key, value) VALUES (?, ?)");
    for (const Field& field : sheetFields().rows())
        if (const std::string value = formatText(field.get(&settings)); !value.empty())
            add.run(field.key, value);
    if (!settings.titleBlock.logo.empty()) add.run(logoKey, AsBlob{settings.titleBlock.logo});
}

SheetSettings readSheetSettings(Database& database) {
    SheetSettings settings;
    Statement row = database.prepare("SELECT key, value FROM sheet_settings");
    while (row.step()) readSetting(row, settings);
    if (const auto sound = validate(settings.titleBlock); !sound) throwDamaged(sound.error().what);
    return settings;
}

// Reads and writes the table `saved_views`.

namespace {

constexpr NumberLimits heightLimitsM{-1e6, 1e6};
constexpr NumberLimits distanceLimitsM{1e-3, 1e7};
constexpr NumberLimits dayLimitsMin{0, 24 * 60};
constexpr const char* parallelName = "parallel";
constexpr const char* perspectiveName = "perspective";

bool isParallel(const CheckedRow& checked, const std::string& projection) {
    if (projection != parallelName && projection != perspectiveName)
        checked.refuse("the projection is unknown");
    return projection == parallelName;
}

std::optional<ViewMoment> momentOf(const Statement& row, const CheckedRow& checked) {
    if (row.isNull(9)) return std::nullopt;
    const auto date = parseDate(row.text(9));
    if (!date) checked.refuse("the date is not valid");
    return ViewMoment{*date, std::chrono::minutes(checked.integer(10, "at_min", dayLimitsMin))};
}

std::optional<std::string> textOf(const std::optional<ViewBox>& box) {
    if (!box) return std::nullopt;
    return nlohmann::json{box->lowM.x, box->lowM.y, box->lowM.z, box->highM.x, box->highM.y, box->highM.z}
        .dump();
}

std::optional<ViewBox> sectionOf(const Statement& row, const CheckedRow& checked) try {
    if (row.isNull(11)) return std::nullopt;
    const auto numbers = nlohmann::json::parse(row.text(11)).get<std::vector<double>>();
    if (numbers.size() != 6) checked.refuse("the section has not six numbers");
    const ViewBox box{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
    if (!isBox(box)) checked.refuse("the section is no box");
    return box;
} catch (const nlohmann::json::exception&) {
    checked.refuse("the section is not a list of numbers");
}

SavedView viewOf(const Statement& row) {
    const CheckedRow checked(row, "saved_views");
    return {cleanText(row.text(1)),
            {checked.number(2, "target_x_m", placeLimitsM), checked.number(3, "target_y_m", placeLimitsM),
             checked.number(4, "target_z_m", heightLimitsM)},
            checked.number(5, "distance_m", distanceLimitsM),
            checked.number(6, "heading_deg", {0, 360}),
            checked.number(7, "pitch_deg", {0, 90}),
            isParallel(checked, row.text(8)),
            momentOf(row, checked),
            sectionOf(row, checked)};
}

}  // namespace

void writeSavedViews(Database& database, const std::vector<SavedView>& views) {
    database.execute("DELETE FROM saved_views");
    Statement add = database.prepare(
        "INSERT INTO saved_views (name, target_x_m, target_y_m, target_z_m, distance_m, heading_deg, "
        "pitch_deg, projection, date, at_min, section) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (const SavedView& view : views) {
        std::optional<std::string> date;
        std::optional<int> at;
        if (view.moment) {
            date = formatText(view.moment->date);
            at = int(view.moment->at.count());
        }
        add.run(view.name, view.targetM.x, view.targetM.y, view.targetM.z, view.distanceM, view.headingDeg,
                view.pitchDeg, view.parallel ? parallelName : perspectiveName, date, at,
                textOf(view.section));
    }
}

std::vector<SavedView> readSavedViews(Database& database) {
    std::vector<SavedView> views;
    Statement row = database.prepare(
        "SELECT id, name, target_x_m, target_y_m, target_z_m, distance_m, heading_deg, pitch_deg, "
        "projection, date, at_min, section FROM saved_views ORDER BY id");
    while (row.step()) views.push_back(viewOf(row));
    return views;
}

}  // namespace noonmark
