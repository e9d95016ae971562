#include "app/report/book/review/review_book.h"

#include <fmt/format.h>
#include <algorithm>

#include "app/report/book/answer_books.h"
#include "app/report/book/flow.h"
#include "app/report/book/review/review_pages.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/report_sections.h"
#include "app/report/sheets/study_text.h"
#include "core/describe/command_options.h"
#include "core/review/library/rule_text.h"
#include "core/review/rule/rule_names.h"
#include "core/study/text/error_text.h"
#include "core/study/text/review_text.h"

namespace noonmark {

namespace {

constexpr std::size_t maxPages = 30, minTablePages = 4;

/// Keeps the first pages; the last of them says that there are more.
void trim(std::vector<BookPage>& pages, std::size_t maximum) {
    if (pages.size() <= maximum) return;
    const std::size_t left = pages.size() - maximum;
    pages.resize(maximum);
    if (pages.empty()) return;
    pages.back().subtitle = sheetText("%1 further pages are printed by the option --all-pages. ").arg(left) +
                            pages.back().subtitle;
}

/// Timelines and tables on the pages that the rest of the book leaves.
void fit(std::vector<BookPage>& charts, std::vector<BookPage>& tables, std::size_t used) {
    const std::size_t left = maxPages - std::min(used, maxPages);
    const std::size_t forTables = std::min({tables.size(), std::max(left / 2, minTablePages), left});
    trim(charts, left - forTables);
    trim(tables, left - charts.size());
}

using MakePages = Result<std::vector<BookPage>> (*)(const ReviewScene&, Progress&, const std::stop_token&);

/// The chapters with pictures, in their order: fans come before the diagrams where the rule lists them first.
std::vector<MakePages> pictureChapters(const Rule& rule) {
    std::vector<MakePages> chapters{makeDiagramPages, makeFanPages, makeIsochronePages, makeSunViewPages};
    const auto& diagrams = rule.deliverables.diagrams;
    if (diagrams && !diagrams->views.empty() && diagrams->views.front() == "fan")
        std::swap(chapters[0], chapters[1]);
    return chapters;
}

}  // namespace

std::vector<CommandOption> makeRepeatOptions(const BookSettings& settings) {
    BookSettings stated = settings;
    stated.language = statedLanguage(settings.language);
    std::vector<CommandOption> options = listOptions(pageFields().of(settings.setup));
    for (const auto* fields : {&scaleFields(), &bookFields(), &extentFields()})
        for (CommandOption& option : listOptions(fields->of(stated))) options.push_back(std::move(option));
    for (CommandOption& option : listOptions(legendFields().of(settings.legend)))
        options.push_back(std::move(option));
    // That of the day where none is stated: repeated later, the sheets print the same.
    const std::string& date = settings.titleBlock.date;
    const SheetScope words(settings.language);
    options.push_back({"--date", {date.empty() ? describeToday().toStdString() : date}});
    return options;
}

Result<Book> makeReviewBook(const ReviewBookSource& source, const BookSettings& settings, Progress& progress,
                            const std::stop_token& stop) {
    const SheetScope words(settings.language);
    const auto scene = makeReviewScene(source, settings, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    Book book = beginBook(settings, sheetText("Shadow review: ") + sheetRuleText(source.study.rule.name),
                          source.labels.provenance.attribution);
    book.record = {QStringLiteral("review.json"),
                   inEnglish([&] { return toJsonText(reviewJson(source.study, source.labels)); })};
    std::vector<NamedTable> named = listReviewTables(*scene);
    auto summary = makeSummaryPages(*scene, named, progress, stop);
    if (!summary) return tl::make_unexpected(summary.error());
    appendPages(book.pages, *std::move(summary));
    for (const MakePages make : pictureChapters(source.study.rule)) {
        auto pages = make(*scene, progress, stop);
        if (!pages) return tl::make_unexpected(pages.error());
        appendPages(book.pages, *std::move(pages));
    }
    std::vector<BookPage> charts = makeChartPages(*scene),
                          tables = makeReviewTablePages(*scene, std::move(named)),
                          method = makeMethodPages(*scene);
    if (settings.heightMap)
        method.insert(method.begin(),
                      makeHeightMapPage(source.scenario, focusOf(*scene, scene->moments), settings.setup));
    if (!settings.allPages) fit(charts, tables, book.pages.size() + method.size());
    for (auto* pages : {&charts, &tables, &method}) appendPages(book.pages, std::move(*pages));
    return book;
}

namespace {

TextBlocks methodOf(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    const Observer& observer = scene.observer;
    TextBlocks blocks{heading(sheetText("Method"))};
    const auto add = [&](const QString& text) { blocks.push_back(body(text)); };
    add(sheetText("Engine: %1. Receivers: centres of the square cells of %2 m that the places touch, each "
                  "weighed by its share of the place, not under a building of baseline or proposal.")
            .arg(plainText(localText(study.engine)), describeAmount(study.settings.cellM, 2)));
    const std::size_t days = scene.sun.sun.days.size();
    add(sheetText("Time: %1, %2 of %3 min with the sun in the rule's hours. Clock: %4.")
            .arg(describeCount(days, "day"), describeCount(scene.sun.sun.steps.size(), "step"),
                 describeAmount(study.stepMinutes, 4), clockText(scene)));
    add(sheetText("Sun: ERFA, topocentric, seen from %1; apparent altitude, with refraction.")
            .arg(describeLatLon(observer.place)));
    add(sheetText("Frame: metres to the east and true north of %1 (WGS84).")
            .arg(describeLatLon(scene.source.baseline.frame.origin())));
    add(sheetText("Incremental shadow lies on what is sunlit in the baseline; sun gained is the reverse."));
    blocks.push_back(heading(sheetText("Error")));
    add(QString::fromStdString(describeReviewErrors(study)));
    add(
        sheetText("The outlines in diagrams are exact unions of projected buildings where the ground is "
                  "level; the figures come from the cells."));
    blocks.push_back(heading(sheetText("Not modelled")));
    add(sheetText("Small structures and penumbra; the sun is a point at the centre of its disc."));
    add(treesText(scene) + sheetText(". Diagrams show the shadows of buildings and terrain."));
    for (const std::string& text : study.notChecked) add(sheetText(localRuleText(text)));
    return blocks;
}

// The title of a list is a heading, which stays with the list's first line.
TextBlocks ruleBlocks(const Rule& rule) {
    TextBlocks blocks{heading(sheetText("The rule, as it was read"))};
    const QStringList lines = QString::fromStdString(describeRule(rule)).split(u'\n', Qt::SkipEmptyParts);
    const QString item = QStringLiteral("  - ");
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const bool isTitle =
            !lines[i].startsWith(item) && i + 1 < lines.size() && lines[i + 1].startsWith(item);
        if (!lines[i].trimmed().isEmpty())
            blocks.push_back(isTitle ? heading(plainText(lines[i])) : body(plainText(lines[i])));
    }
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

std::vector<BookPage> makeMethodPages(const ReviewScene& scene) {
    TextBlocks blocks = methodOf(scene);
    addBlocks(blocks, sourcesOf(scene));
    addBlocks(blocks, repeatBlocks(makeRepeatCommand(scene.source.study, scene.source.labels, bookCharacters),
                                   false));
    addBlocks(blocks, ruleBlocks(scene.source.study.rule));
    return makeTextPages(scene.settings.setup,
                         {sheetText("Method and sources"), {}, sheetText("Method and sources"), 0, {}},
                         blocks);
}

}  // namespace noonmark
