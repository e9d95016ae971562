#include "app/report/book/review/glazing_book.h"

#include <algorithm>

#include "app/report/book/answer_books.h"
#include "app/report/book/flow.h"
#include "app/report/maps/answer_legends.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/report_sections.h"
#include "app/report/sheets/study_text.h"
#include "core/review/library/rule_text.h"
#include "core/review/rule/rule_names.h"
#include "core/study/text/error_text.h"

namespace noonmark {

namespace {

constexpr double glazingTablePt = 7;

QString countsText(const VerdictCounts& counts) {
    return sheetText("%1 pass, %2 borderline, %3 fail, %4 not applicable")
        .arg(describeCount(counts.pass), describeCount(counts.borderline), describeCount(counts.fail),
             describeCount(counts.notJudged()));
}

void addChanges(TextBlocks& blocks, const QString& what, const VerdictChanges& changes) {
    blocks.push_back(body(sheetText("%1 before: %2.").arg(what, countsText(changes.before))));
    blocks.push_back(body(sheetText("%1 after: %2.").arg(what, countsText(changes.after))));
    blocks.push_back(body(sheetText("%1 whose verdict gets worse: %2; better: %3.")
                              .arg(what, describeCount(changes.worse), describeCount(changes.better))));
}

TextBlocks summaryOf(const GlazingBookSource& source) {
    const GlazingStudy& study = source.study;
    TextBlocks blocks{heading(sheetText("Summary"))};
    addChanges(blocks, sheetText("Windows"), study.windowChanges);
    addChanges(blocks, sheetText("Buildings"), study.buildingChanges);
    blocks.push_back(body(sheetRuleText(study.rule.summary)));
    blocks.push_back(body(sheetText("Proposal: %1. Baseline: %2.")
                              .arg(scenarioText(source.labels.to), scenarioText(source.labels.from))));
    blocks.push_back(body(plainText(describeLeastCertain(study.rule))));
    blocks.push_back(body(plainText(study.trees) + u'.'));
    blocks.push_back(heading(sheetText("Not checked")));
    for (const std::string& text : study.notChecked) blocks.push_back(body(sheetText(localRuleText(text))));
    return blocks;
}

NamedTable buildingTable(const GlazingBookSource& source, double points, std::size_t maxRows) {
    PageTable table{
        {sheetText("Building"), sheetText("Windows"), sheetText("Fail before"), sheetText("Fail after"),
         sheetText("Worse"), sheetText("Verdict before"), sheetText("Verdict after")},
        {},
        {},
        {},
        points};
    for (const BuildingReview& building : source.study.buildings) {
        if (table.rows.size() == maxRows) break;
        const std::string& name = building.name.empty() ? building.id : building.name;
        table.rows.push_back(
            {name.empty() ? sheetText("none") : plainText(name), describeCount(building.windows.after.all()),
             describeCount(building.windows.before.fail), describeCount(building.windows.after.fail),
             describeCount(building.windows.worse), sheetText(nameOf(building.formerVerdict)),
             sheetText(nameOf(building.verdict))});
        table.marks.push_back(verdictMark(building.verdict));
    }
    const std::size_t more = source.study.buildings.size() - table.rows.size();
    const QString note =
        more > 0
            ? QStringLiteral("The windows of %1 more buildings are in windows.csv").arg(describeCount(more))
            : QString();
    return {sheetText("Buildings"), note, std::move(table)};
}

std::vector<QString> glazingRow(const GlazingStudy& study, const GlazingReview& review) {
    const ReviewedGlazing& window = review.window;
    std::vector<QString> row{plainText(window.id), QString::number(window.floor),
                             window.azimuthDeg ? describeAmount(*window.azimuthDeg, 0) : QStringLiteral("-")};
    for (std::size_t i = 0; i < review.results.size(); ++i) {
        const Criterion& criterion = study.rule.criteria[i];
        row.push_back(plainText(valueText(criterion, review.results[i].former)));
        row.push_back(plainText(valueText(criterion, review.results[i].value)));
    }
    const CivilDate day = review.day.value_or(CivilDate{});
    row.push_back(plainText(bandsText(study, day, review.formerBands)));
    row.push_back(plainText(bandsText(study, day, review.bands)));
    row.push_back(sheetText(nameOf(review.formerVerdict)));
    row.push_back(sheetText(nameOf(review.verdict)));
    return row;
}

NamedTable glazingTable(const GlazingBookSource& source, double points, std::size_t maxRows) {
    const GlazingStudy& study = source.study;
    PageTable table{{sheetText("Window"), sheetText("Floor"), sheetText("Faces, deg")}, {}, {}, {}, points};
    for (const Criterion& criterion : study.rule.criteria) {
        table.titles.push_back(sheetText("%1, before").arg(plainText(criterion.key)));
        table.titles.push_back(sheetText("%1, after").arg(plainText(criterion.key)));
    }
    for (const auto* title :
         {NM_TEXT("Sun before"), NM_TEXT("Sun after"), NM_TEXT("Verdict before"), NM_TEXT("Verdict after")})
        table.titles.push_back(sheetText(title));
    for (const GlazingReview* review : sortWorstFirst(study.windows)) {
        if (table.rows.size() == maxRows) break;
        table.rows.push_back(glazingRow(study, *review));
        table.marks.push_back(verdictMark(review->verdict));
    }
    QString note = sheetText("%1, clock: %2. Minutes, or percent where stated")
                       .arg(sheetRuleText(study.rule.name), plainText(study.clock.text()));
    if (study.windows.size() > table.rows.size())
        note += QStringLiteral("; %1 more windows are in windows.csv")
                    .arg(describeCount(study.windows.size() - table.rows.size()));
    return {sheetText("Windows"), note, std::move(table)};
}

TextBlocks methodOf(const GlazingBookSource& source) {
    const GlazingStudy& study = source.study;
    TextBlocks blocks{heading(sheetText("Method"))};
    blocks.push_back(body(sheetText("Engine: %1. Clock: %2, year %3; %4 steps of %5 min with the sun in "
                                    "the rule's hours.")
                              .arg(plainText(localText(study.engine)), plainText(study.clock.text()))
                              .arg(study.year)
                              .arg(describeCount(study.steps), describeAmount(study.stepMinutes, 4))));
    blocks.push_back(
        body(sheetText("Each run of minutes is uncertain by a step, a sky component by %1 %. A value "
                       "within its error of a limit is borderline, never pass.")
                 .arg(describeAmount(skyComponentErrorPct, 2))));
    blocks.push_back(heading(sheetText("The rule, as it was read")));
    for (const QString& line : QString::fromStdString(describeRule(study.rule)).split(u'\n'))
        if (!line.trimmed().isEmpty()) blocks.push_back(body(plainText(line)));
    Study sources;
    sources.city = source.scenario;
    sources.warnings = study.warnings;
    sources.provenance = source.labels.provenance;
    sources.heights = source.heights;
    const TextBlocks repeat = repeatBlocks(makeRepeatCommand(study, source.labels, bookCharacters), false);
    for (const TextBlock& block : sourceBlocks(sources, repeat)) blocks.push_back(block);
    return blocks;
}

}  // namespace

Result<Book> makeGlazingBook(const GlazingBookSource& source, const BookSettings& settings,
                             Progress& progress, const std::stop_token& stop) {
    const SheetScope words(settings.language);
    const QString title = sheetText("Review of windows: ") + sheetRuleText(source.study.rule.name);
    Book book = beginBook(settings, title, source.labels.provenance.attribution);
    book.record = {QStringLiteral("review.json"),
                   inEnglish([&] { return toJsonText(glazingReviewJson(source.study, source.labels)); })};
    const auto append = [&](std::vector<BookPage> pages) {
        for (BookPage& page : pages) book.pages.push_back(std::move(page));
    };
    const double points = glazingTablePt * textScale(settings.setup);
    const std::size_t maxRows = settings.allPages ? maxGlazingRows : defaultGlazingRows;
    append(makeTextPages(settings.setup, {title, {}, sheetText("Summary")}, summaryOf(source)));
    append(makeGlazingElevations(source, settings));
    if (settings.heightMap)
        book.pages.push_back(makeHeightMapPage(source.scenario, bounds(source.scenario), settings.setup));
    auto views = makeGlazingSunViews(source, settings, progress, stop);
    if (!views) return tl::make_unexpected(views.error());
    append(*std::move(views));
    append(makeTablePages(settings.setup, {sheetText("Tables"), {}, sheetText("Tables")},
                          {buildingTable(source, points, maxRows), glazingTable(source, points, maxRows)}));
    append(makeTextPages(settings.setup,
                         {sheetText("Method and sources"), {}, sheetText("Method and sources")},
                         methodOf(source)));
    return book;
}

}  // namespace noonmark
