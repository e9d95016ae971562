#pragma once

// The folder app/report/sheets/ lays out one-page reports. A Sheet (this file) is the content of a page,
// which is painted as PDF or picture; study_report.h and answer_reports.h make one from a result.
// report_sections.h and study_text.h write the text, text_column.h sets it in columns; pdf_page.h is the A4
// page.

#include <QIODevice>
#include <QImage>
#include <optional>
#include <vector>

#include "app/report/maps/map_painter.h"
#include "app/report/maps/style.h"
#include "app/report/sheets/study_text.h"
#include "app/report/sheets/text_column.h"
#include "core/study/study.h"

namespace noonmark {

/// The heading of a picture or page: title; dates and hours; place and sunlit time.
struct Headline {
    QString what;
    QString when;
    QString where;
};

/// `subject`: "Shadow study", "Gross shadow"; followed by the name of the region if it has one.
Headline makeHeadline(const Study& study, const QString& subject);
/// The same for any result with `settings` over a city in `frame`. `sunlit`: text on the sunlit time per day;
/// empty where unknown.
Headline makeHeadline(const StudySettings& settings, const Frame& frame, const QString& subject,
                      const QString& sunlit);

constexpr double headlineHeightPt = 50;

/// Paints from the top of `area`, headlineHeightPt high. A line that is too long is set smaller, then cut
/// with an ellipsis.
void paintHeadline(const Canvas& canvas, const QRectF& area, const Headline& headline);

/// Paints one line across `area`: the data credit at the left, the program at the right.
void paintSmallPrint(const Canvas& canvas, const QRectF& area, const QString& credit);

/// A map with its legend.
struct SheetMap {
    MapScene scene;
    Legend legend;
};

/// The result as JSON, attached to its PDF so that the report alone can be verified.
struct SheetRecord {
    QString fileName;  ///< "study.json"; empty: none
    std::string json;
};

/// One page about one result: a study, a comparison or a score. Owns no result: the data that its maps refer
/// to must outlive it.
struct Sheet {
    Headline headline;
    SheetMap map;
    TextBlocks definitions{};            ///< definitions of the figures, below the map
    std::optional<SheetMap> smallMap{};  ///< another measure, above the figures
    std::vector<FigureText> figures{};   ///< the first one is set in bold
    std::vector<TextBlocks> sections{};  ///< at least two; each begins with its heading and is not split
    TextBlocks repeat{};                 ///< across the bottom of the page; may be empty
    QString credit{};                    ///< credit of the data
    SheetRecord record{};                ///< attached to the PDF
    QString finding{};                   ///< the answer in a sentence, below the headline; may be empty
};

/// Writes an A4 page. False if the device did not accept it.
bool writePdf(const Sheet& sheet, QIODevice& device);

/// A picture for screens, slides and print: title, map, legend, scale bar, north arrow, data credit. All text
/// grows with its width (pixels, in the range of style.h); its height follows from the region's
/// shape.
QImage makePicture(const Sheet& sheet, int width = pictureWidth);

}  // namespace noonmark
