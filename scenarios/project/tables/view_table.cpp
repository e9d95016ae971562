#include <nlohmann/json.hpp>

#include "core/base/clean_text.h"
#include "scenarios/project/read_project.h"
#include "scenarios/project/tables/checked_row.h"
#include "scenarios/project/write_project.h"

// Reads and writes the table `saved_views`.
namespace noonmark {

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
