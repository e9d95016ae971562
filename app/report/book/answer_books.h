#pragma once

#include <QImage>

#include "app/report/book/book.h"
#include "app/report/maps/change_scale.h"
#include "app/report/sheets/answer_reports.h"
#include "app/report/sheets/study_report.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/elements/element_map.h"
#include "core/study/study.h"
#include "core/study/text/breakdown_text.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/project/results/saved_answer.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

// Books of results with maps. The arguments must outlive the book, whose maps refer to them.

/// The book of a study of cells: its maps, sun by month where it was measured, method and sources.
Book makeStudyBook(const Study& study, const BookSettings& settings);

/// The book of a comparison: maps of the change, both scenarios side by side on one scale, sole contributions
/// of new buildings where they were measured, method and sources.
Book makeImpactBook(const ImpactAnswer& answer, const AnswerSource& source, const ChangeScale& scale,
                    const BookSettings& settings, const LegendChoice& legend = {});

/// The book of a score: its map, bars of shadow area and score by month, the intervals of the weight table,
/// method and sources.
Book makeScoreBook(const ScoreAnswer& answer, const AnswerSource& source, const BookSettings& settings,
                   const LegendChoice& legend = {});

/// What the book of a saved result with maps holds. The sheet's maps refer to what was saved.
struct SavedMapBook {
    Sheet sheet;
    std::string attribution{};
    Bars months{};                            ///< of a study; no groups: not measured
    const SavedImpact* comparison = nullptr;  ///< of a comparison
    const Score* score = nullptr;
    std::string weights{};  ///< of the score: the name of its weight table
    TextBlocks note{};      ///< what was not saved and so is not shown; may be empty
};
/// The same pages as of a new result, but for what was not saved, which the text states.
Book makeSavedBook(const SavedMapBook& saved, const BookSettings& settings);

/// The pages of a saved result of any question: its figures, more pages, what the figures mean, and where
/// they are from.
Book makeSavedBook(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source,
                   const std::vector<FigureLine>& lines, const BookSettings& settings,
                   std::vector<BookPage> more = {});

/// The same with the sides of the buildings that have points, drawn with those that stand now.
Book makeSavedBook(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source,
                   const SavedElements& points, const std::vector<FigureLine>& lines,
                   const BookSettings& settings);

/// The book of a study at points: figures, method and sources; and each side of each building that has
/// points, coloured by hours of sun a day on one scale, those with least sun first. Points of a level plane
/// and roof windows have no elevation. At most maxSidePages() of them, at `settings.scale` where they fit.
Book makeElementBook(const ElementStudy& study, const ElementMap& map, const BookSettings& settings);

/// The book of the contributions of a study: a map that numbers the buildings that make most shadow, bars of
/// the largest, and a table of all that make at least a thousandth of it, with the sum of the others. The
/// study's breakdown must exist; the study must outlive the book.
Book makeContributionBook(const Study& study, const BookSettings& settings);

/// Sheets of sun by place: the finding in a sentence, error and method; a map of the places coloured by hours
/// of sun; a table of the places, those with the largest loss first or, without scenarios, those with least
/// sun. Tables list so many rows at most; the heading names the file with the others.
/// `mapped`: the same in the column that maps show (showColumn()); null: `sun`. Both must outlive the book.
Book makeSunByPlaceBook(const SunOfCities& sun, const BookSettings& settings,
                        const PlaceColours& colours = {}, const SunOfCities* mapped = nullptr);
/// The same of a saved result, whose cities must be set.
Book makeSavedBook(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source,
                   const SunOfCities& sun, const BookSettings& settings, const PlaceColours& colours,
                   const SunOfCities* mapped = nullptr);
/// Its map alone, with legend, scale bar and north: of the smallest box that holds the places. `city`: the
/// buildings around them.
QImage paintPlacesMap(const SunByPlace& sun, const City& city, const PlaceColours& colours, int widthPx);
/// The options of a command that draw it in these colours; of sun by place, which shows sun if nothing is
/// said.
std::vector<CommandOption> listColourOptions(const PlaceColours& colours);
inline constexpr std::size_t maxRowsOfPlaces = 150;

/// A map of the city's buildings in the colours of where their heights come from, and a legend that counts
/// them. `shown`: the part of the ground, local metres; empty: all buildings. The page owns what it shows.
BookPage makeHeightMapPage(const City& city, const Box2& shown, const PageSetup& setup);

}  // namespace noonmark
