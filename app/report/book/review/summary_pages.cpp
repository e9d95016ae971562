#include <QStringList>
#include <algorithm>
#include <map>
#include <utility>

#include "app/report/book/flow.h"
#include "app/report/book/review/review_pages.h"
#include "app/report/maps/answer_legends.h"
#include "app/report/maps/map_painter.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/study_text.h"
#include "core/review/library/rule_text.h"
#include "core/review/places/verdict_text.h"
#include "core/review/rule/rule_names.h"
#include "core/study/text/height_facts_text.h"

namespace noonmark {

namespace {

constexpr std::size_t maxOthersNamed = 150;

PageTable verdictTable(const ReviewScene& scene, double points) {
    const ReviewStudy& study = scene.source.study;
    PageTable table{
        {sheetText("Place"), sheetText("Kind"), sheetText("Area"), sheetText("Verdict"), sheetText("Reason")},
        {},
        {},
        {},
        points};
    for (const PlaceRow& row : scene.list.rows) {
        const PlaceReview& first = study.places[row.reviews.front()];
        double areaM2 = 0;
        for (const std::size_t i : row.reviews) areaM2 += study.places[i].areaM2;
        const auto writeDate = [](CivilDate date) { return dayText(date).toStdString(); };
        QString reason = plainText(describeReason(first, scene.settings.units, writeDate));
        if (row.reviews.size() > 1) reason = plainText(first.name) + QStringLiteral(": ") + reason;
        table.rows.push_back({numberedName(row), sheetText(nameOf(first.kind)),
                              QString::fromStdString(formatArea(areaM2, scene.settings.units)),
                              sheetText(nameVerdict(first)), reason});
        table.marks.push_back(verdictMark(first.verdict));
    }
    return table;
}

/// What the book leaves out of its tables and timelines.
QString extentText(const ReviewScene& scene) {
    std::size_t single = 0;
    for (const PlaceRow& row : scene.list.rows) single += row.reviews.size() == 1 ? 1 : 0;
    const std::size_t all = scene.source.study.places.size();
    if (scene.settings.allPages || single == all) return {};
    return sheetText(
               "Of %1 places %2 are listed one by one; the numbers are those of the diagrams. Places "
               "of less than %3 without a name are listed together. Timelines are of places that "
               "fail or are borderline. review.csv has all places; the option --all-pages prints them.")
        .arg(describeCount(all), describeCount(single),
             QString::fromStdString(formatArea(scene.settings.minPlaceM2, scene.settings.units)));
}

TextBlocks introduction(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    TextBlocks blocks;
    for (const GeometryHeadline& headline : listGeometryHeadlines(scene.source.scenario, {}))
        if (headline.of != "heights of trees" || study.rule.occluders.trees != RuleTrees::without)
            blocks.push_back(heading(QString::fromStdString(headline.text)));
    blocks.push_back(body(sheetRuleText(study.rule.summary)));
    blocks.push_back(
        body(sheetText("Proposal: %1. Baseline: %2.")
                 .arg(scenarioText(scene.source.labels.to), scenarioText(scene.source.labels.from))));
    blocks.push_back(body(sheetText("Clock: %1, year %2. Engine: %3, every %4 min, cells of %5 m. %6.")
                              .arg(clockText(scene))
                              .arg(study.year)
                              .arg(plainText(localText(study.engine)), describeAmount(study.stepMinutes, 2),
                                   describeAmount(study.settings.cellM, 2), treesText(scene))));
    blocks.push_back(body(plainText(describeLeastCertain(study.rule))));
    if (scene.moments.empty())
        blocks.push_back(
            body(sheetText("Figures only: the sun is not up at the rule's times, so no diagram is drawn.")));
    if (const QString extent = extentText(scene); !extent.isEmpty()) blocks.push_back(body(extent));
    return blocks;
}

/// The places that the proposal does not change, by verdict: those with names, and how many have none.
TextBlocks otherBlocks(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    std::map<QString, std::pair<std::vector<QString>, std::size_t>> byVerdict;
    for (const PlaceRow& row : scene.list.others)
        byVerdict[sheetText(nameVerdict(study.places[row.reviews.front()]))].first.push_back(
            QString::number(row.number) + QChar(0xa0) + row.name);
    for (const std::size_t i : scene.list.unnamed)
        ++byVerdict[sheetText(nameVerdict(study.places[i]))].second;
    if (byVerdict.empty()) return {};
    TextBlocks blocks{heading(sheetText("Places without new shadow"))};
    for (const auto& [verdict, places] : byVerdict) {
        const auto& [names, unnamed] = places;
        const std::size_t shown = std::min(names.size(), maxOthersNamed);
        QStringList texts(names.begin(), names.begin() + std::ptrdiff_t(shown));
        if (shown < names.size())
            texts << sheetText("%1 further places with names").arg(describeCount(names.size() - shown));
        if (unnamed > 0) texts << sheetText("%1 without a name").arg(describeCount(unnamed));
        blocks.push_back(body(verdict + QStringLiteral(": ") + texts.join(QStringLiteral(", "))));
    }
    return blocks;
}

TextBlocks notCheckedBlocks(const ReviewStudy& study) {
    TextBlocks blocks{heading(sheetText("Not checked"))};
    for (const std::string& text : study.notChecked) blocks.push_back(body(sheetText(localRuleText(text))));
    if (study.notChecked.empty()) blocks.push_back(body(sheetText("Nothing is stated as unchecked.")));
    return blocks;
}

/// Of rules about many days: what the sums say about each place.
TextBlocks sumBlocks(const ReviewScene& scene) {
    constexpr std::size_t fewDays = 31;
    if (scene.sun.sun.days.size() <= fewDays) return {};
    TextBlocks blocks{heading(sheetText("Sums over the days of the rule"))};
    for (const PlaceRow& row : scene.list.rows) {
        const PlaceReview& place = scene.source.study.places[row.reviews.front()];
        const ReviewTotals& sum = place.totals;
        if (sum.theoreticalM2h <= 0 || row.reviews.size() > 1) continue;
        const auto text = [&](double m2h) {
            return QStringLiteral("%1, %2 %")
                .arg(QString::fromStdString(formatAreaHours(m2h, scene.settings.units)),
                     describeAmount(100 * m2h / sum.theoreticalM2h, 3));
        };
        blocks.push_back(body(sheetText("%1: existing shadow %2 of the theoretical sun; incremental %3; "
                                        "most on %4.")
                                  .arg(plainText(place.name), text(sum.baselineM2h), text(sum.incrementalM2h),
                                       sum.largestDay ? dayText(*sum.largestDay) : sheetText("no day"))));
    }
    return blocks;
}

/// The picture's half of the first page, and that of the text.
std::pair<QRectF, QRectF> halvesOf(const PageSetup& setup) {
    const QRectF all = contentArea(setup);
    const double gap = 14 * textScale(setup);
    if (setup.landscape) {
        const double width = all.width() * 0.56;
        return {{all.left(), all.top(), width, all.height()},
                {all.left() + width + gap, all.top(), all.width() - width - gap, all.height()}};
    }
    const double height = all.height() * 0.5;
    return {{all.left(), all.top(), all.width(), height},
            {all.left(), all.top() + height + gap, all.width(), all.height() - height - gap}};
}

/// The view of the summary shows what changes, its shadow at the moment, and the places in reach of it.
DiagramLayout summaryLayout(const ReviewScene& scene, const DiagramMoment& moment, const QRectF& area) {
    return fitInto(area, textScale(scene.settings.setup), frameOf(scene, {moment}));
}

/// "the most incremental shadow on Elm Park (fail)", by the number of the table.
QString momentText(const ReviewScene& scene, std::size_t review) {
    const PlaceReview& place = scene.source.study.places[review];
    const auto row = std::ranges::find_if(scene.list.rows, [&](const PlaceRow& one) {
        return std::ranges::find(one.reviews, review) != one.reviews.end();
    });
    const QString name = row == scene.list.rows.end() ? plainText(place.name) : numberedName(*row);
    return sheetText("the most incremental shadow on %1 (%2) at one moment")
        .arg(name, sheetText(nameVerdict(place)));
}

Result<void> addPicture(const ReviewScene& scene, BookPage& page, const QRectF& area, Progress& progress,
                        const std::stop_token& stop) {
    const auto worst = worstMoment(scene);
    if (!worst) return {};
    const DiagramMoment& moment = worst->moment;
    const PageSetup& setup = scene.settings.setup;
    const double foot = diagramFootPt(textScale(setup));
    const QRectF picture = area.adjusted(0, 0, 0, -foot);
    const DiagramLayout layout = summaryLayout(scene, moment, picture);
    auto diagram = makeDiagram(scene, moment, layout, picture, progress, stop);
    if (!diagram) return tl::make_unexpected(diagram.error());
    if (worst->place) diagram->caption.first += QStringLiteral(": ") + momentText(scene, *worst->place);
    page.items.push_back({picture, *std::move(diagram)});
    DiagramFoot legend = makeFoot(scene, layout.scale, DiagramFoot::Subject::shadows);
    if (scene.keyPt > 0) legend.note = sheetText("Numbers in a white field: places of the table.");
    page.items.push_back({{area.left(), area.bottom() - foot, area.width(), foot}, std::move(legend)});
    return {};
}

/// Text, then as much of the verdicts as fits, then what is not checked where there is room, then the first
/// of the other tables. Returns what was left over as pages.
std::vector<BookPage> fillText(const ReviewScene& scene, BookPage& page, const QRectF& area,
                               std::vector<NamedTable>& tables) {
    MeasuringCanvas measure;
    const PageSetup& setup = scene.settings.setup;
    const double scale = textScale(setup), points = 7.6 * scale, gap = 8 * scale;
    const auto heightPt = [&](const TextBlocks& blocks) {
        return heightOf(measure.canvas(), blocks, area.width() * MeasuringCanvas::unitsPerPoint, points) /
               MeasuringCanvas::unitsPerPoint;
    };
    const TextBlocks intro = introduction(scene);
    TextBlocks rest = sumBlocks(scene);
    for (TextBlock& block : notCheckedBlocks(scene.source.study)) rest.push_back(std::move(block));
    for (TextBlock& block : otherBlocks(scene)) rest.push_back(std::move(block));
    const double introPt = std::min(heightPt(intro) + 1, area.height() * 0.6);
    page.items.push_back({{area.left(), area.top(), area.width(), introPt}, PageText{intro, points}});
    QRectF left = area.adjusted(0, introPt + gap, 0, 0);
    PageTable table = verdictTable(scene, points);
    table.widthsPt = fitColumns(table, area.width());
    const double restPt = heightPt(rest) + 1;
    const bool isRestFirst =
        tableHeightPt(table) + gap + restPt > left.height() && restPt < left.height() / 2;
    if (isRestFirst) {
        page.items.push_back({{left.left(), left.top(), left.width(), restPt}, PageText{rest, points}});
        left = left.adjusted(0, restPt + gap, 0, 0);
    }
    std::vector<BookPage> pages;
    auto parts = flowTable(table, left.height(), left.height());
    const double used = tableHeightPt(parts.front());
    if (!parts.front().rows.empty())
        page.items.push_back({{left.left(), left.top(), left.width(), used}, parts.front()});
    if (const std::size_t shown = parts.front().rows.size(); shown < table.rows.size()) {
        PageTable more = verdictTable(scene, points);
        more.rows.erase(more.rows.begin(), more.rows.begin() + std::ptrdiff_t(shown));
        more.marks.erase(more.marks.begin(), more.marks.begin() + std::ptrdiff_t(shown));
        pages = makeTablePages(setup, {sheetText("Verdicts"), {}, {}, 0, {}},
                               {{sheetText("Verdicts, continued"), {}, std::move(more)}});
    }
    left = left.adjusted(0, used + gap, 0, 0);
    if (isRestFirst) return pages;
    if (pages.empty() && restPt <= left.height()) {
        page.items.push_back({{left.left(), left.top(), left.width(), restPt}, PageText{rest, points}});
        left = left.adjusted(0, restPt + gap, 0, 0);
        for (PageItem& item : takeTables(tables, left, scale)) page.items.push_back(std::move(item));
        return pages;
    }
    for (BookPage& more : makeTextPages(setup, {sheetText("Summary"), {}, {}, 0, {}}, rest))
        pages.push_back(std::move(more));
    return pages;
}

/// On upright paper the text goes down as far as the page ends, and the picture gets the room, up to a part.
void lowerText(const PageSetup& setup, std::vector<PageItem>& texts, const QRectF& text, QRectF& picture) {
    constexpr double maxPicture = 0.68;  // of the page
    if (setup.landscape) return;
    double bottom = text.top();
    for (const PageItem& item : texts) bottom = std::max(bottom, item.area.bottom());
    const double spare = maxPicture * contentArea(setup).height() - picture.height();
    const double by = std::clamp(text.bottom() - bottom, 0.0, std::max(0.0, spare));
    for (PageItem& item : texts) item.area.translate(0, by);
    picture.setHeight(picture.height() + by);
}

/// The city of the rule alone would read as that of the site.
QString subtitleOf(const ReviewScene& scene) {
    return sheetText("Rule used in: %1. Site: %2.")
        .arg(sheetRuleText(scene.source.study.rule.where), describeLatLon(scene.observer.place));
}

}  // namespace

Result<std::vector<BookPage>> makeSummaryPages(const ReviewScene& scene, std::vector<NamedTable>& tables,
                                               Progress& progress, const std::stop_token& stop) {
    const PageSetup& setup = scene.settings.setup;
    BookPage page{
        sheetRuleText(scene.source.study.rule.name), subtitleOf(scene), sheetText("Summary"), 0, {}};
    auto [picture, text] = halvesOf(setup);
    const bool hasPicture = worstMoment(scene).has_value();
    if (!hasPicture) text = contentArea(setup);
    std::vector<BookPage> more = fillText(scene, page, text, tables);
    if (hasPicture) {
        std::vector<PageItem> texts = std::exchange(page.items, {});
        lowerText(setup, texts, text, picture);
        if (const auto done = addPicture(scene, page, picture, progress, stop); !done)
            return tl::make_unexpected(done.error());
        std::ranges::move(texts, std::back_inserter(page.items));
    }
    more.insert(more.begin(), std::move(page));
    return more;
}

}  // namespace noonmark
