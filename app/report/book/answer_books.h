#pragma once

#include <QImage>

#include "app/report/book/book.h"
#include "app/report/maps/change_scale.h"
#include "app/report/sheets/answer_reports.h"
#include "app/report/sheets/study_report.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/elements/element_map.h"
#include "core/study/study.h"
#include "scenarios/impact/impact_text.h"
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

/// The pages of a saved result of any question: its figures, what they mean, and where they are from.
Book makeSavedBook(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source,
                   const std::vector<FigureLine>& lines, const BookSettings& settings);

/// The book of a study at points: figures, method and sources; and each side of each building that has
/// points, coloured by hours of sun a day on one scale, those with least sun first. Points of a level plane
/// and roof windows have no elevation. At most 40 pages of elevations, at `settings.scale` where they fit.
Book makeElementBook(const ElementStudy& study, const ElementMap& map, const BookSettings& settings);

/// The book of the contributions of a study: a map that numbers the buildings that make most shadow, bars of
/// the largest, and a table of all that make at least a thousandth of it, with the sum of the others. The
/// study's breakdown must exist; the study must outlive the book.
Book makeContributionBook(const Study& study, const BookSettings& settings);

/// Sheets of sun by place: the finding in a sentence, error and method; a map of the places coloured by hours
/// of sun; a table of the places, those with the largest loss first or, without scenarios, those with least
/// sun. Tables list so many rows at most; the heading names the file with the others.
Book makeSunByPlaceBook(const SunOfCities& sun, const BookSettings& settings,
                        const PlaceColours& colours = {});
/// Its map alone, with legend, scale bar and north: of the smallest box that holds the places. `city`: the
/// buildings around them.
QImage paintPlacesMap(const SunByPlace& sun, const City& city, const PlaceColours& colours, int widthPx);
/// The options of a command that draw it in these colours; of sun by place, which shows sun if nothing is
/// said.
std::vector<CommandOption> listColourOptions(const PlaceColours& colours);
inline constexpr std::size_t maxRowsOfPlaces = 150;

}  // namespace noonmark
