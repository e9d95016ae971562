#include "app/report/book/review/review_book.h"

#include "app/report/book/review/review_pages.h"
#include "core/describe/command_options.h"
#include "core/study/text/warnings_json.h"

namespace noonmark {

namespace {

constexpr std::size_t maxPages = 30, leastTablePages = 4;

/// Keeps the first pages; the last of them says that there are more.
void trim(std::vector<BookPage>& pages, std::size_t most) {
    if (pages.size() <= most) return;
    const std::size_t left = pages.size() - most;
    pages.resize(most);
    if (pages.empty()) return;
    pages.back().subtitle =
        QStringLiteral("%1 further pages are printed by the option --all-pages. ").arg(left) +
        pages.back().subtitle;
}

/// Timelines and tables on the pages that the rest of the book leaves.
void fit(std::vector<BookPage>& charts, std::vector<BookPage>& tables, std::size_t used) {
    const std::size_t left = maxPages - std::min(used, maxPages);
    const std::size_t forTables = std::min({tables.size(), std::max(left / 2, leastTablePages), left});
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
    std::vector<CommandOption> options = listOptions(pageFields().of(settings.setup));
    for (const auto* fields : {&scaleFields(), &extentFields()})
        for (CommandOption& option : listOptions(fields->of(settings))) options.push_back(std::move(option));
    for (CommandOption& option : listOptions(legendFields().of(settings.legend)))
        options.push_back(std::move(option));
    if (!settings.titleBlock.date.empty()) options.push_back({"--date", {settings.titleBlock.date}});
    return options;
}

Result<Book> makeReviewBook(const ReviewBookSource& source, const BookSettings& settings, Progress& progress,
                            const std::stop_token& stop) {
    const auto scene = makeReviewScene(source, settings, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    Book book = beginBook(settings, QStringLiteral("Shadow review: ") + plainText(source.study.rule.name),
                          source.labels.provenance.attribution);
    book.record = {QStringLiteral("review.json"), toJsonText(reviewJson(source.study, source.labels))};
    std::vector<MakePages> chapters = pictureChapters(source.study.rule);
    chapters.insert(chapters.begin(), makeSummaryPages);
    for (const MakePages make : chapters) {
        auto pages = make(*scene, progress, stop);
        if (!pages) return tl::make_unexpected(pages.error());
        appendPages(book.pages, *std::move(pages));
    }
    std::vector<BookPage> charts = makeChartPages(*scene), tables = makeReviewTablePages(*scene),
                          method = makeMethodPages(*scene);
    if (!settings.allPages) fit(charts, tables, book.pages.size() + method.size());
    for (auto* pages : {&charts, &tables, &method}) appendPages(book.pages, std::move(*pages));
    return book;
}

}  // namespace noonmark
