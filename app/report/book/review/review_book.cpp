#include "app/report/book/review/review_book.h"

#include <QDate>
#include <algorithm>

#include "app/report/book/review/review_pages.h"
#include "app/report/sheets/period_words.h"
#include "app/report/sheets/study_words.h"
#include "core/base/progress_share.h"

namespace noonmark {

namespace {

QString today() {
    const QDate date = QDate::currentDate();
    return describeDates(CivilDate{std::chrono::year{date.year()}, std::chrono::month{unsigned(date.month())},
                                   std::chrono::day{unsigned(date.day())}});
}

using MakePages = Result<std::vector<BookPage>> (*)(const ReviewScene&, Progress&, const std::stop_token&);

}  // namespace

Result<Book> makeReviewBook(const ReviewBookSource& source, const BookSettings& settings, Progress& progress,
                            const std::stop_token& stop) {
    const auto scene = makeReviewScene(source, settings, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    Book book{settings.setup,
              settings.titleBlock,
              QStringLiteral("Shadow review: ") + plainText(source.study.rule.name),
              settings.titleBlock.date.empty() ? today() : plainText(settings.titleBlock.date),
              describeData(source.labels.provenance.attribution),
              {}};
    for (const MakePages make : {makeSummaryPages, makeDiagramPages, makeFanPages, makeSunViewPages}) {
        auto pages = make(*scene, progress, stop);
        if (!pages) return tl::make_unexpected(pages.error());
        appendPages(book.pages, *std::move(pages));
    }
    appendPages(book.pages, makeChartPages(*scene));
    appendPages(book.pages, makeReviewTablePages(*scene));
    appendPages(book.pages, makeMethodPages(*scene));
    return book;
}

}  // namespace noonmark
