#pragma once

// The folder app/report/sheets/ lays out one-page reports. A Sheet is the content of a page; study_report.h,
// impact_report.h and score_report.h make one from a result, and sheet_page.cpp and sheet_picture.cpp paint
// it as PDF or picture. report_sections.h, study_words.h and period_words.h write the text; text_column.h,
// figure_table.h, headline.h and style.h set it.

#include <QIODevice>
#include <QImage>
#include <optional>
#include <vector>

#include "app/report/maps/map_painter.h"
#include "app/report/sheets/headline.h"
#include "app/report/sheets/picture_width.h"
#include "app/report/sheets/study_words.h"
#include "app/report/sheets/text_column.h"

namespace noonmark {

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
/// grows with its width (pixels, in the range of picture_width.h); its height follows from the region's
/// shape.
QImage makePicture(const Sheet& sheet, int width = pictureWidth);

}  // namespace noonmark
