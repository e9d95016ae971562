#pragma once

#include "app/report/book/book.h"

namespace noonmark {

/// A canvas without a picture, on which texts of a book are measured as they will be painted.
class MeasuringCanvas {
public:
    MeasuringCanvas();
    ~MeasuringCanvas();
    MeasuringCanvas(const MeasuringCanvas&) = delete;
    MeasuringCanvas& operator=(const MeasuringCanvas&) = delete;
    [[nodiscard]] Canvas canvas() { return {painter_, unitsPerPoint}; }
    /// Units of a book's canvas per point: text is laid out in these, whatever it is painted on.
    static constexpr double unitsPerPoint = 1200.0 / 72;

private:
    QImage image_;
    QPainter painter_;
};

/// Splits paragraphs into columns that are at most so wide and high, in points. A heading stays with what
/// follows it; a paragraph that is higher than a column is split between words.
std::vector<TextBlocks> flowText(const TextBlocks& blocks, const QSizeF& sizePt, double points);

/// Widths of the columns of a table in `widthPt`: as wide as their texts where that fits; else texts break
/// between words, and columns with long texts in many rows get more of the width.
std::vector<double> fitColumns(const PageTable& table, double widthPt);

/// Splits a table, whose widths are set, into tables of at most these heights (points): the first, then all
/// others. The titles are repeated.
std::vector<PageTable> flowTable(const PageTable& table, double firstPt, double otherPt);
double tableHeightPt(const PageTable& table);

/// Pages of text in columns of a readable width. The first page has `page`'s title and bookmark, the others
/// its title alone.
std::vector<BookPage> makeTextPages(const PageSetup& setup, const BookPage& page, const TextBlocks& blocks);

/// A table with its heading, for makeTablePages().
struct NamedTable {
    QString title;
    QString note;     ///< below the title; may be empty
    PageTable table;  ///< its widths are set by makeTablePages()
};

/// The first of the tables, as many as fit whole into an area, one below the other; they are taken from the
/// list. `scale`: textScale() of the page.
std::vector<PageItem> takeTables(std::vector<NamedTable>& tables, const QRectF& area, double scale);

/// Pages of tables over the whole width, one below the other. A table begins on a new page where fewer than
/// some rows of it would fit.
std::vector<BookPage> makeTablePages(const PageSetup& setup, const BookPage& page,
                                     std::vector<NamedTable> tables);

}  // namespace noonmark
