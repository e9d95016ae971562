#include "app/report/book/print_book.h"

#include <QBuffer>
#include <QPdfWriter>

#include "app/report/book/flow.h"
#include "app/report/book/page_painter.h"
#include "app/report/sheets/pdf_page.h"
#include "app/report/sheets/study_words.h"

namespace noonmark {

namespace {

bool paintPages(const Book& book, QIODevice& device) {
    QPdfWriter writer(&device);
    writer.setResolution(int(MeasuringCanvas::unitsPerPoint * 72));
    writer.setPageSize(pageSizeOf(book.setup.paper));
    writer.setPageOrientation(book.setup.landscape ? QPageLayout::Landscape : QPageLayout::Portrait);
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setTitle(book.title);
    writer.setCreator(describeProgram());
    attachRecord(book.record, writer);
    QPainter painter;
    if (!painter.begin(&writer)) return false;
    for (std::size_t i = 0; i < book.pages.size(); ++i) {
        if (i > 0 && !writer.newPage()) return false;
        paintPage(book, i, {painter, MeasuringCanvas::unitsPerPoint});
    }
    return painter.end();
}

PdfStructure structureOf(const Book& book) {
    PdfStructure structure{{}, QStringLiteral("en"), {}};
    for (std::size_t i = 0; i < book.pages.size(); ++i) {
        const BookPage& page = book.pages[i];
        structure.labels.push_back(sheetNumber(book, i));
        if (!page.bookmark.isEmpty()) structure.bookmarks.push_back({page.bookmark, int(i), page.level});
    }
    return structure;
}

}  // namespace

Result<QByteArray> printBook(const Book& book) {
    if (book.pages.empty()) return failure("The book has no pages");
    QBuffer pages;
    pages.open(QIODevice::WriteOnly);
    if (!paintPages(book, pages)) return failure("The pages could not be written as PDF");
    return addPdfStructure(pages.data(), structureOf(book));
}

}  // namespace noonmark
