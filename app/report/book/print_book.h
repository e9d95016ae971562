#pragma once

#include <QByteArray>
#include <QString>
#include <vector>

#include "app/report/book/book.h"
#include "core/base/result.h"

namespace noonmark {

/// Paints page `index` of a book with its top left corner at the painter's origin, for print or as a picture:
/// the same lines break at the same words at every size. `canvas.point`: painter units per point of paper.
void paintPage(const Book& book, std::size_t index, const Canvas& canvas);

/// A page as a picture, at so many dots per inch of paper: for previews.
QImage makePagePicture(const Book& book, std::size_t index, double dotsPerInch);

/// An entry of a PDF's outline.
struct PdfBookmark {
    QString title;
    int page = 0;   ///< from 0
    int level = 0;  ///< at most one more than that of the entry before
    bool operator==(const PdfBookmark&) const = default;
};

/// What a PDF by Qt lacks for navigation and accessibility.
struct PdfStructure {
    std::vector<PdfBookmark> bookmarks;
    QString language;             ///< BCP 47: "en", "de"
    std::vector<QString> labels;  ///< of the pages, as viewers show them: "A-1"
};

/// The PDF with outline, language and page labels, which opens with its outline and shows its title. Error:
/// the bytes are no PDF, or a bookmark names a page that it does not have.
Result<QByteArray> addPdfStructure(const QByteArray& pdf, const PdfStructure& structure);

/// The bytes of a book as a PDF: text that can be selected, fonts embedded, title, language, bookmarks and
/// page labels. Needs a QGuiApplication (the `offscreen` platform suffices). Error: the book has no pages.
Result<QByteArray> printBook(const Book& book);

}  // namespace noonmark
