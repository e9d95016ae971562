#include <fmt/format.h>

#include <algorithm>

#include "app/report/book/flow.h"
#include "app/report/book/review/review_pages.h"
#include "app/report/sheets/report_sections.h"
#include "app/report/sheets/study_words.h"
#include "core/review/review_columns.h"
#include "core/review/rule_names.h"
#include "core/review/rule_text.h"
#include "core/review/verdict_text.h"

namespace noonmark {

namespace {

constexpr std::size_t commandLetters = 60;  // in a line of a column
constexpr double tablePt = 7.4;
constexpr std::size_t mostDaysAll = 31;  // of longer ranges only days with incremental shadow are listed

BookPage chapter(const QString& title, const QString& subtitle) { return {title, subtitle, title, 0, {}}; }

/// The rule's own table.
std::optional<NamedTable> ruleTable(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    PageTable table{{}, {}, {}, {}, tablePt * textScale(scene.settings.setup)};
    const auto columns = columnsIn(scene.settings.units, study.rule.deliverables.columns);
    for (const RuleColumn& column : columns) table.titles.push_back(plainText(column.title));
    if (table.titles.empty()) return std::nullopt;
    std::size_t leftOut = 0;
    for (const PlaceReview& review : study.places)
        for (const ReviewRow& row : review.rows) {
            if (review.rows.size() > mostDaysAll && row.durationMin <= 0) {
                ++leftOut;
                continue;
            }
            auto& texts = table.rows.emplace_back();
            for (const RuleColumn& column : columns)
                texts.push_back(plainText(columnText(review, row, column.key)));
        }
    const QString note = leftOut == 0
                             ? QString()
                             : QStringLiteral(". %1 days without incremental shadow are in review.csv only")
                                   .arg(describeCount(leftOut));
    return NamedTable{
        QStringLiteral("Table of the rule"),
        QStringLiteral("%1, clock: %2%3").arg(plainText(study.rule.name), plainText(study.clock), note),
        std::move(table)};
}

/// The numbers behind the verdicts.
std::optional<NamedTable> criteriaTable(const ReviewScene& scene) {
    PageTable table{{QStringLiteral("Place"), QStringLiteral("Criterion"), QStringLiteral("Measured"),
                     QStringLiteral("Former"), QStringLiteral("Limit"), QStringLiteral("Deciding day"),
                     QStringLiteral("Result")},
                    {},
                    {},
                    {},
                    tablePt * textScale(scene.settings.setup)};
    const QString none = QStringLiteral("-");
    const UnitSystem units = scene.settings.units;
    for (const PlaceReview& review : scene.source.study.places)
        for (std::size_t i = 0; i < review.criteria.size() && i < review.results.size(); ++i) {
            const Criterion& criterion = review.criteria[i];
            const CriterionResult& result = review.results[i];
            const auto measured = [&](const std::optional<Measured>& value) {
                return value ? plainText(formatMeasured(criterion.measure, value->value, units)) : none;
            };
            table.rows.push_back({plainText(review.name),
                                  plainText(criterion.name) +
                                      (criterion.advisory ? QStringLiteral(" (does not decide)") : QString()),
                                  measured(result.value), measured(result.former),
                                  criterion.limits.empty() ? QStringLiteral("none")
                                                           : plainText(describeLimits(criterion, units)),
                                  result.day ? dayText(*result.day) : none,
                                  plainText(nameOf(result.verdict))});
        }
    if (table.rows.empty()) return std::nullopt;
    return NamedTable{QStringLiteral("Criteria: the figures behind the verdicts"), {}, std::move(table)};
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
    if (scene.sun.sun.days.size() <= mostDaysAll) return std::nullopt;
    PageTable table{{QStringLiteral("Place"), QStringLiteral("Theoretical sun"),
                     QStringLiteral("Existing shadow"), QStringLiteral("share"),
                     QStringLiteral("With proposal"), QStringLiteral("share"), QStringLiteral("Incremental"),
                     QStringLiteral("share"), QStringLiteral("Days with incremental shadow"),
                     QStringLiteral("Day of most"), QStringLiteral("Duration on it")},
                    {},
                    {},
                    {},
                    tablePt * textScale(scene.settings.setup)};
    for (const PlaceReview& review : study.places) {
        const ReviewTotals& sum = review.totals;
        table.rows.push_back({plainText(review.name), areaHours(scene, sum.theoreticalM2h),
                              areaHours(scene, sum.baselineM2h), shareText(sum, sum.baselineM2h),
                              areaHours(scene, sum.scenarioM2h), shareText(sum, sum.scenarioM2h),
                              areaHours(scene, sum.incrementalM2h), shareText(sum, sum.incrementalM2h),
                              describeAmount(sum.daysWithIncremental, 0),
                              sum.largestDay ? dayText(*sum.largestDay) : QStringLiteral("-"),
                              describeAmount(sum.largestDayDurationMin, 0) + QStringLiteral(" min")});
    }
    return NamedTable{QStringLiteral("Sums"),
                      QStringLiteral("Over the days of the rule; shares of the theoretical sun"),
                      std::move(table)};
}

/// Which new building takes how much sun from which place; places that none reaches are left out.
std::optional<NamedTable> contributionTable(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    PageTable table{
        {QStringLiteral("New building"), QStringLiteral("Place"), QStringLiteral("Shadow"),
         QStringLiteral("share of the theoretical sun"), QStringLiteral("of the proposal's shadow")},
        {},
        {},
        {},
        tablePt * textScale(scene.settings.setup)};
    for (const ReviewContribution& building : study.contributions)
        for (std::size_t i = 0; i < study.places.size(); ++i) {
            const double m2h = building.incrementalM2h[i];
            const ReviewTotals& sum = study.places[i].totals;
            if (m2h <= 0) continue;
            table.rows.push_back({plainText(building.name.empty() ? building.id : building.name),
                                  plainText(study.places[i].name), areaHours(scene, m2h), shareText(sum, m2h),
                                  sum.incrementalM2h > 0 ? describeAmount(100 * m2h / sum.incrementalM2h, 1) +
                                                               QStringLiteral(" %")
                                                         : QStringLiteral("-")});
        }
    if (table.rows.empty()) return std::nullopt;
    return NamedTable{
        QStringLiteral("Sole contributions of the new buildings"),
        QStringLiteral("What each casts where all others of the proposal leave the sun, over the "
                       "days of the rule; shadow that two of them share is in neither row"),
        std::move(table)};
}

TextBlocks methodOf(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    const Observer& observer = scene.observer;
    TextBlocks blocks{heading(QStringLiteral("Method"))};
    const auto add = [&](const QString& text) { blocks.push_back(body(text)); };
    add(QStringLiteral("Engine: %1. Receivers: centres of square cells of %2 m on the places, not under a "
                       "building of baseline or proposal.")
            .arg(plainText(study.engine), describeAmount(study.settings.cellM, 2)));
    add(QStringLiteral("Time: %1 days, %2 steps of %3 min with the sun in the rule's hours. Clock: %4.")
            .arg(describeCount(scene.sun.sun.days.size()), describeCount(scene.sun.sun.steps.size()),
                 describeAmount(study.stepMinutes, 4), plainText(study.clock)));
    add(QStringLiteral("Sun: ERFA, topocentric, seen from %1; apparent altitude, with refraction.")
            .arg(describeLatLon(observer.place)));
    add(QStringLiteral("Frame: metres to the east and true north of %1 (WGS84).")
            .arg(describeLatLon(scene.source.baseline.frame.origin())));
    add(QStringLiteral(
        "Incremental shadow lies on what is sunlit in the baseline; sun gained is the reverse."));
    blocks.push_back(heading(QStringLiteral("Error")));
    add(
        QStringLiteral("Each run of minutes is uncertain by a step, each area by a cell. A value within its "
                       "error of a limit is borderline, never pass."));
    add(
        QStringLiteral("The outlines in diagrams are exact unions of projected buildings where the ground is "
                       "level; the figures come from the cells."));
    blocks.push_back(heading(QStringLiteral("Not modelled")));
    add(QStringLiteral(
        "Trees, small structures and penumbra; the sun is a point at the centre of its disc."));
    for (const std::string& text : study.notChecked) add(plainText(text));
    return blocks;
}

TextBlocks ruleBlocks(const Rule& rule) {
    TextBlocks blocks{heading(QStringLiteral("The rule, as it was read"))};
    for (const QString& line : QString::fromStdString(describeRule(rule)).split(u'\n'))
        if (!line.trimmed().isEmpty()) blocks.push_back(body(plainText(line)));
    return blocks;
}

void addBlocks(TextBlocks& to, const TextBlocks& blocks) {
    to.insert(to.end(), blocks.begin(), blocks.end());
}

/// Project, files, heights and warnings, as in the report of a study.
TextBlocks sourcesOf(const ReviewScene& scene) {
    Study study;
    study.city = scene.source.scenario;
    study.warnings = scene.source.study.warnings;
    study.provenance = scene.source.labels.provenance;
    study.heights = scene.source.heights;
    TextBlocks blocks;
    auto sections = sourceSections(study);
    sections.pop_back();  // cost and skipped work belong to a field
    for (const TextBlocks& section : sections) addBlocks(blocks, section);
    return blocks;
}

}  // namespace

std::vector<BookPage> makeReviewTablePages(const ReviewScene& scene) {
    std::vector<NamedTable> tables;
    for (auto& table : {sumTable(scene), contributionTable(scene), criteriaTable(scene), ruleTable(scene)})
        if (table) tables.push_back(table.value());
    if (tables.empty()) return {};
    return makeTablePages(scene.settings.setup, chapter(QStringLiteral("Tables"), {}), std::move(tables));
}

std::vector<BookPage> makeMethodPages(const ReviewScene& scene) {
    TextBlocks blocks = methodOf(scene);
    addBlocks(blocks, sourcesOf(scene));
    addBlocks(blocks, repeatBlocks(makeRepeatCommand(scene.source.study, scene.source.labels, commandLetters),
                                   false));
    addBlocks(blocks, ruleBlocks(scene.source.study.rule));
    return makeTextPages(scene.settings.setup, chapter(QStringLiteral("Method and sources"), {}), blocks);
}

}  // namespace noonmark
