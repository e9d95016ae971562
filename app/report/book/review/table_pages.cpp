#include <algorithm>

#include "app/report/book/flow.h"
#include "app/report/book/review/review_pages.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/study_text.h"
#include "core/review/places/review_columns.h"
#include "core/review/places/verdict_text.h"

namespace noonmark {

namespace {

constexpr double denseTablePt = 7.4;
constexpr std::size_t maxDaysAll = 31;  // of longer ranges only days with incremental shadow are listed

/// The places that tables list one by one.
std::vector<const PlaceRow*> singleRows(const ReviewScene& scene) {
    std::vector<const PlaceRow*> rows;
    for (const PlaceRow& row : scene.list.rows)
        if (row.reviews.size() == 1) rows.push_back(&row);
    return rows;
}

bool hasManyDays(const PlaceReview& review) { return review.rows.size() > maxDaysAll; }

/// The day of a month with most incremental shadow, the first of equal ones.
bool isWorstOfMonth(const PlaceReview& review, const ReviewRow& row) {
    const auto sortKey = [](const ReviewRow& one) { return std::pair(-one.incrementalM2h, one.day); };
    return std::ranges::none_of(review.rows, [&](const ReviewRow& other) {
        return other.day.year() == row.day.year() && other.day.month() == row.day.month() &&
               sortKey(other) < sortKey(row);
    });
}

/// Rows without incremental shadow are left out of long tables, and where the place has others. Of many days
/// one a month is listed unless all pages are asked for.
bool isLeftOut(const ReviewScene& scene, const PlaceReview& review, const ReviewRow& row) {
    const bool all = scene.settings.allPages;
    if (row.durationMin > 0) return !all && hasManyDays(review) && !isWorstOfMonth(review, row);
    return hasManyDays(review) || (!all && review.totals.incrementalM2h > 0);
}

/// What a table says of the days that it leaves out; `isMonthly`: among them days with incremental shadow.
QString leftOutDaysText(std::size_t days, bool isMonthly) {
    if (days == 0) return {};
    const QString which =
        !isMonthly ? sheetText(". %1 days without incremental shadow are in review.csv only")
                   : sheetText(
                         ". Of each month the day of most incremental shadow; %1 further days are in "
                         "review.csv, and here with the option --all-pages");
    return which.arg(describeCount(days));
}

QString leftOutText(const ReviewScene& scene) {
    const std::size_t listed = singleRows(scene).size(), all = scene.source.study.places.size();
    if (listed == all) return {};
    return sheetText("%1 of %2 places; review.csv has all").arg(describeCount(listed), describeCount(all));
}

/// The rule's own table.
std::optional<NamedTable> ruleTable(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    PageTable table{{}, {}, {}, {}, denseTablePt * textScale(scene.settings.setup)};
    const auto columns = columnsIn(scene.settings.units, study.rule.deliverables.columns);
    for (const RuleColumn& column : columns) table.titles.push_back(sheetRuleText(column.title));
    if (table.titles.empty()) return std::nullopt;
    std::size_t leftOut = 0;
    bool isMonthly = false;
    for (const PlaceRow* listed : singleRows(scene)) {
        const PlaceReview& review = study.places[listed->reviews.front()];
        for (const ReviewRow& row : review.rows) {
            if (isLeftOut(scene, review, row)) {
                ++leftOut;
                isMonthly = isMonthly || row.durationMin > 0;
                continue;
            }
            auto& texts = table.rows.emplace_back();
            for (const RuleColumn& column : columns)
                texts.push_back(column.key == "place" ? numberedName(*listed)
                                : column.key == "day"
                                    ? dayText(row.day)
                                    : plainText(localNumbers(columnText(review, row, column.key))));
        }
    }
    if (table.rows.empty()) return std::nullopt;
    QString note = leftOutDaysText(leftOut, isMonthly);
    if (const QString places = leftOutText(scene); !places.isEmpty()) note += QStringLiteral(". ") + places;
    return NamedTable{
        sheetText("Table of the rule"),
        sheetText("%1, clock: %2%3").arg(sheetRuleText(study.rule.name), clockText(scene), note),
        std::move(table)};
}

constexpr qsizetype formerColumn = 3;

bool isEmptyColumn(const PageTable& table, qsizetype column, const QString& none) {
    return std::ranges::all_of(table.rows, [&](const auto& row) { return row[column] == none; });
}

void removeColumn(PageTable& table, qsizetype column) {
    table.titles.erase(table.titles.begin() + column);
    for (auto& row : table.rows) row.erase(row.begin() + column);
}

/// The numbers behind the verdicts.
std::optional<NamedTable> criteriaTable(const ReviewScene& scene) {
    PageTable table{{sheetText("Place"), sheetText("Criterion"), sheetText("Measured"), sheetText("Former"),
                     sheetText("Limit"), sheetText("Deciding day"), sheetText("Result")},
                    {},
                    {},
                    {},
                    denseTablePt * textScale(scene.settings.setup)};
    const QString none = QStringLiteral("-");
    const UnitSystem units = scene.settings.units;
    for (const PlaceRow* listed : singleRows(scene)) {
        const PlaceReview& review = scene.source.study.places[listed->reviews.front()];
        for (std::size_t i = 0; i < review.criteria.size() && i < review.results.size(); ++i) {
            const Criterion& criterion = review.criteria[i];
            const CriterionResult& result = review.results[i];
            const auto measured = [&](const std::optional<Measured>& value) {
                return value ? plainText(formatMeasured(criterion.measure, value->value, units)) : none;
            };
            table.rows.push_back(
                {numberedName(*listed),
                 sheetRuleText(criterion.name) +
                     (criterion.advisory ? sheetText(" (does not decide)") : QString()),
                 measured(result.value), measured(result.former),
                 criterion.limits.empty() ? sheetText("none") : plainText(describeLimits(criterion, units)),
                 result.day ? dayText(*result.day) : none, sheetText(nameResult(criterion, result))});
        }
    }
    if (table.rows.empty()) return std::nullopt;
    QStringList notes;
    if (isEmptyColumn(table, formerColumn, none))
        removeColumn(table, formerColumn);
    else
        notes << sheetText("Former: the same in the baseline, where a limit compares with it");
    if (const QString leftOut = leftOutText(scene); !leftOut.isEmpty()) notes << leftOut;
    return NamedTable{sheetText("Criteria: the figures behind the verdicts"),
                      notes.join(QStringLiteral(". ")), std::move(table)};
}

QString areaHours(const ReviewScene& scene, double m2h) {
    return QString::fromStdString(formatAreaHours(m2h, scene.settings.units));
}

QString shareText(const ReviewTotals& totals, double m2h) {
    if (totals.theoreticalM2h <= 0) return QStringLiteral("-");
    return describeAmount(100 * m2h / totals.theoreticalM2h, 3) + QStringLiteral(" %");
}

/// Sums over the rule's days, for rules about a range of days.
std::optional<NamedTable> sumTable(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    if (scene.sun.sun.days.size() <= maxDaysAll) return std::nullopt;
    PageTable table{
        {sheetText("Place"), sheetText("Theoretical sun"), sheetText("Existing shadow"), sheetText("share"),
         sheetText("With proposal"), sheetText("share"), sheetText("Incremental"), sheetText("share"),
         sheetText("Days with incremental shadow"), sheetText("Day of most"), sheetText("Duration on it")},
        {},
        {},
        {},
        denseTablePt * textScale(scene.settings.setup)};
    for (const PlaceRow* listed : singleRows(scene)) {
        const ReviewTotals& sum = study.places[listed->reviews.front()].totals;
        table.rows.push_back({numberedName(*listed), areaHours(scene, sum.theoreticalM2h),
                              areaHours(scene, sum.baselineM2h), shareText(sum, sum.baselineM2h),
                              areaHours(scene, sum.scenarioM2h), shareText(sum, sum.scenarioM2h),
                              areaHours(scene, sum.incrementalM2h), shareText(sum, sum.incrementalM2h),
                              describeAmount(sum.daysWithIncremental, 0),
                              sum.largestDay ? dayText(*sum.largestDay) : QStringLiteral("-"),
                              describeAmount(sum.largestDayDurationMin, 0) + sheetText(" min")});
    }
    return NamedTable{sheetText("Sums"),
                      sheetText("Over the days of the rule; shares of the theoretical sun"),
                      std::move(table)};
}

/// Time and extent of incremental shadow by season, for rules about a range of days.
std::optional<NamedTable> seasonTable(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    if (scene.sun.sun.days.size() <= maxDaysAll || study.rule.days.mirrored) return std::nullopt;
    PageTable table{{sheetText("Place"), sheetText("Months"), sheetText("Days with shadow"),
                     sheetText("Enters at the earliest"), sheetText("Exits at the latest"),
                     sheetText("Longest on a day"), sheetText("Largest area"), sheetText("Incremental")},
                    {},
                    {},
                    {},
                    denseTablePt * textScale(scene.settings.setup)};
    for (const PlaceRow* listed : singleRows(scene))
        for (const SeasonSum& season : sumSeasons(study.places[listed->reviews.front()])) {
            if (season.daysWithShadow <= 0) continue;
            const UnitSystem units = scene.settings.units;
            table.rows.push_back(
                {numberedName(*listed), sheetText(season.months),
                 sheetText("%1 of %2")
                     .arg(describeAmount(season.daysWithShadow, 0), describeAmount(season.days, 0)),
                 plainText(season.earliest), plainText(season.latest),
                 describeAmount(season.longestMin, 0) + sheetText(" min"),
                 QString::fromStdString(formatArea(season.maxAreaM2, units)),
                 areaHours(scene, season.incrementalM2h)});
        }
    if (table.rows.empty()) return std::nullopt;
    return NamedTable{
        sheetText("Incremental shadow by season"),
        sheetText("Seasons without incremental shadow are left out. Clock: %1").arg(clockText(scene)),
        std::move(table)};
}

/// Which new building takes how much sun from which place; places that none reaches are left out.
std::optional<NamedTable> contributionTable(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    PageTable table{{sheetText("New building"), sheetText("Place"), sheetText("Shadow"),
                     sheetText("share of the theoretical sun"), sheetText("of the proposal's shadow")},
                    {},
                    {},
                    {},
                    denseTablePt * textScale(scene.settings.setup)};
    for (const ReviewContribution& building : study.contributions)
        for (const PlaceRow* listed : singleRows(scene)) {
            const std::size_t i = listed->reviews.front();
            const double m2h = building.incrementalM2h[i];
            const ReviewTotals& sum = study.places[i].totals;
            if (m2h <= 0) continue;
            table.rows.push_back({plainText(building.name.empty() ? building.id : building.name),
                                  numberedName(*listed), areaHours(scene, m2h), shareText(sum, m2h),
                                  sum.incrementalM2h > 0 ? describeAmount(100 * m2h / sum.incrementalM2h, 1) +
                                                               QStringLiteral(" %")
                                                         : QStringLiteral("-")});
        }
    if (table.rows.empty()) return std::nullopt;
    return NamedTable{
        sheetText("Sole contributions of the new buildings"),
        sheetText("What each casts where the baseline and all others of the proposal leave the sun, over the "
                  "days of the rule; shadow that two of them share is in neither row"),
        std::move(table)};
}

}  // namespace

std::vector<NamedTable> listReviewTables(const ReviewScene& scene) {
    std::vector<NamedTable> tables;
    for (auto& table : {sumTable(scene), seasonTable(scene), contributionTable(scene), criteriaTable(scene),
                        ruleTable(scene)})
        if (table) tables.push_back(table.value());
    return tables;
}

std::vector<BookPage> makeReviewTablePages(const ReviewScene& scene, std::vector<NamedTable> tables) {
    if (tables.empty()) return {};
    return makeTablePages(scene.settings.setup, {sheetText("Tables"), {}, sheetText("Tables"), 0, {}},
                          std::move(tables));
}

}  // namespace noonmark
