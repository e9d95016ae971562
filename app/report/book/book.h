#pragma once

// The folder app/report/book/ makes books of sheets that a board can file. A Book (this file) is a list of
// pages, and a page is a list of items with their places on the paper: text and tables (page_text.h, flow.h),
// plan diagrams (diagram.h), sides of buildings (elevation.h, elevation_pages.h), charts (app/report/charts)
// and pictures. print_book.h paints a page on any canvas with its frame and title block, makes the PDF and
// adds what Qt's PDF lacks. sun_view.h draws the view from the sun. review/ makes the book of a review.

#include <QImage>
#include <QRectF>
#include <QString>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "app/language/language.h"
#include "app/report/book/diagram.h"
#include "app/report/book/elevation.h"
#include "app/report/book/page_text.h"
#include "app/report/book/paper.h"
#include "app/report/charts/bar_chart.h"
#include "app/report/charts/carpet_chart.h"
#include "app/report/charts/timeline_chart.h"
#include "app/report/sheets/sheet.h"
#include "core/base/units.h"
#include "core/measures/legend_choice.h"
#include "scenarios/project/title_block.h"

namespace noonmark {

/// A picture with a caption below it; fills its area as far as its shape allows.
struct PagePicture {
    QImage image;
    Caption caption;
};

/// A chart with a caption above it.
struct PageChart {
    std::variant<TimelineChart, CarpetChart, BarChart> chart;
    Caption caption;
};

/// A map of cells with its legend, as large as its area allows. The map must not be null, and the data that
/// it refers to must outlive the book.
struct PageMap {
    std::shared_ptr<const SheetMap> map;
    Caption caption{};  ///< empty: none
};

using PageContent = std::variant<PageText, PageTable, Diagram, DiagramFoot, ElevationDrawing, ElevationFoot,
                                 PageChart, PagePicture, PageMap>;

/// `area`: in points from the top left corner of the page, inside contentArea().
struct PageItem {
    QRectF area;
    PageContent content;
};

/// A page as a value. Its heading is painted above contentArea().
struct BookPage {
    QString title;
    QString subtitle;  ///< a quiet line below the title; may be empty
    /// Bookmarks name the page by this; empty: the page has none. Level 0 is the outermost.
    QString bookmark;
    int level = 0;
    std::vector<PageItem> items{};
};

struct BookSettings {
    static constexpr double minScale = 100, maxScale = 50000;
    PageSetup setup;
    std::optional<double> scale;  ///< of diagrams, 1:scale; none: a round one that shows all shadows
    TitleBlock titleBlock;
    UnitSystem units = UnitSystem::metric;
    /// Everything is in all tables, maps and timelines, on as many pages as that takes; else a book has at
    /// most `defaultPages`.
    bool allPages = false;
    static constexpr std::size_t defaultPages = 30;
    double minPlaceM2 = 100;  ///< in the book of a review: smaller places without a name are listed together
    bool heightMap = false;   ///< a page with the buildings by source of height
    LegendChoice legend{};    ///< of maps, places, points and windows
    Language language = Language::system;  ///< of all texts; system: that of the window
    bool operator==(const BookSettings&) const = default;
};

/// The scale alone; page and title block have fields of their own.
const Fields<BookSettings>& scaleFields();
/// What any book holds.
const Fields<BookSettings>& bookFields();
/// What the book of a review of places holds besides.
const Fields<BookSettings>& extentFields();

struct Book {
    PageSetup setup;
    TitleBlock titleBlock;
    QString title;   ///< of the PDF and in the title block: "Shadow review: New York, CEQR chapter 8"
    QString date;    ///< as printed in the title block
    QString credit;  ///< credit of the data, at the foot of each page
    UnitSystem units = UnitSystem::metric;  ///< of scale bars and heights on maps
    SheetRecord record{};                   ///< attached to the PDF
    Language language = Language::system;   ///< of what is painted; that of the texts
    std::vector<BookPage> pages;
};

/// The language that a command states, so that it prints the same where the window's is another: that of the
/// window for Language::system; English is the default of commands.
Language statedLanguage(Language language);

/// A book without pages.
Book beginBook(const BookSettings& settings, const QString& title, const std::string& attribution);

/// "23 November 2026": the date of a book whose title block states none.
QString describeToday();

/// "A-3": of page `index` (from 0).
QString sheetNumber(const Book& book, std::size_t index);

}  // namespace noonmark
