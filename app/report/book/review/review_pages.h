#pragma once

#include "app/report/book/flow.h"
#include "app/report/book/review/review_book.h"
#include "core/review/rule/rule_days.h"

namespace noonmark {

/// A row of a review's sheets: one place, or several that are listed together.
struct PlaceRow {
    std::vector<std::size_t> reviews;  ///< indices into ReviewStudy::places; the first speaks for the others
    QString name;
    int number = 0;  ///< on diagrams, in their key and in tables
};

/// How the sheets of a review list its places.
struct ListedPlaces {
    /// What the proposal changes, fails or is borderline; the worst first. Without a proposal: every place.
    std::vector<PlaceRow> rows;
    std::vector<PlaceRow> others;      ///< places with a name of their own that are in no row
    std::vector<std::size_t> unnamed;  ///< all further reviews
    std::vector<int> numbers;          ///< by place as drawn (ReviewBookSource::places); 0: it has none
};

/// Lists the places as BookSettings says: all of them one by one, or at most `maxPlaceRows` places one by
/// one, with those that are smaller than `minPlaceM2` and have no name listed together. A place that lies
/// in a larger one goes under its name. `hasProposal`: the scenario differs from the baseline.
ListedPlaces listPlaces(const ReviewBookSource& source, const BookSettings& settings, bool hasProposal);
inline constexpr std::size_t maxPlaceRows = 60;

/// "12 Elm Park": a place of the sheets in a table.
QString numberedName(const PlaceRow& row);
/// "Elm Park"; of a place that its file does not name "plaza without a name".
QString shortName(const Place& place);
/// A place is `perPlace(rule)` reviews, one after the other: a parcel has two belts.
std::size_t placeOf(const ReviewStudy& study, std::size_t review);

// The pages of a review's book. review_book.cpp puts them together.

/// A moment that diagrams show.
struct DiagramMoment {
    CivilDate day;
    double minute = 0;  ///< of the rule's clock
    QString time;       ///< "09:00"
    SunStep sun;
};

/// What several pages need.
struct ReviewScene {
    const ReviewBookSource& source;
    const BookSettings& settings;
    std::shared_ptr<const DiagramScene> diagrams;
    City before, after;  ///< the cities that cast
    Observer observer;
    RuleSun sun;                           ///< all days of the rule
    std::vector<DiagramMoment> moments{};  ///< in time order
    ListedPlaces list{};
    double keyPt = 0;  ///< height of the key below the diagrams of a page; 0: no place has a number
};

/// Errors of computeRuleSun().
Result<ReviewScene> makeReviewScene(const ReviewBookSource& source, const BookSettings& settings,
                                    const std::stop_token& stop);

/// How the diagrams of a book are placed on their pages.
struct DiagramLayout {
    int columns = 1, rows = 1;
    double scale = 2000;
    glm::dvec2 centre{};
};

/// The areas of the diagrams of a page, row by row, in points; key and foot are below them.
std::vector<QRectF> diagramAreas(const ReviewScene& scene, int columns, int rows);
/// The same without room for a foot.
std::vector<QRectF> gridAreas(const PageSetup& setup, int columns, int rows);

inline constexpr double keyTextPt = 6.8;  ///< on A4
/// The numbers of the places seen in any of these views, with their names, as far as they fit into keyPt.
QString describeKey(const ReviewScene& scene, const std::vector<Box2>& seen);

/// Where the shadows of what changes reach at the moments, cut at 1.5 km.
Box2 reachOf(const ReviewScene& scene, const std::vector<DiagramMoment>& moments);
/// What changes, and the places in the rows of the sheets that its shadows reach: each whole, but for those
/// much larger than the shadows.
Box2 focusOf(const ReviewScene& scene, const std::vector<DiagramMoment>& moments);
/// Both.
Box2 frameOf(const ReviewScene& scene, const std::vector<DiagramMoment>& moments);
/// The round scale and the views a page that show all of frameOf(), at the smallest at 1:7500: of several the
/// one with a large scale on few pages. Where all of it takes a smaller scale, focusOf() and the shadows that
/// reach its places, if need be at 1:10000. With a given scale: the most views that show that, or focusOf();
/// if none does, one view of what is nearest to what changes. Unless all pages are asked for, a page has so
/// many views that there are at most `maxDiagramPages`.
DiagramLayout layoutOf(const ReviewScene& scene);
inline constexpr std::size_t maxDiagramPages = 8;
/// One view in an area, at the largest round scale at which it shows a box; else at 1:10000.
DiagramLayout fitInto(const QRectF& area, double textScale, const Box2& shown);

/// What the first page shows.
struct WorstMoment {
    DiagramMoment moment;
    std::optional<std::size_t> place;  ///< index of its review; none: no place is in incremental shadow
};

/// The moment at which most of a place is in incremental shadow, of those places whose verdict is worst; else
/// the moment nearest to noon. Nothing without any sun.
std::optional<WorstMoment> worstMoment(const ReviewScene& scene);

/// Legend and scale of diagrams, without a note.
DiagramFoot makeFoot(const ReviewScene& scene, double scale, DiagramFoot::Subject subject);
/// The diagram of a moment in an area of the page. Errors of outlineShadows().
Result<Diagram> makeDiagram(const ReviewScene& scene, const DiagramMoment& moment,
                            const DiagramLayout& layout, const QRectF& area, Progress& progress,
                            const std::stop_token& stop);

/// What the summary's page has room for is taken from the tables.
Result<std::vector<BookPage>> makeSummaryPages(const ReviewScene& scene, std::vector<NamedTable>& tables,
                                               Progress& progress, const std::stop_token& stop);
Result<std::vector<BookPage>> makeDiagramPages(const ReviewScene& scene, Progress& progress,
                                               const std::stop_token& stop);
/// Lines of equal hours of shadow on a day (index in RuleSun::sun.days), around what changes.
Result<Diagram> makeIsochrones(const ReviewScene& scene, std::size_t day, const QRectF& area,
                               const std::stop_token& stop);
/// The pages of isochrones, for rules whose diagrams have them.
Result<std::vector<BookPage>> makeIsochronePages(const ReviewScene& scene, Progress& progress,
                                                 const std::stop_token& stop);
Result<std::vector<BookPage>> makeFanPages(const ReviewScene& scene, Progress& progress,
                                           const std::stop_token& stop);
Result<std::vector<BookPage>> makeSunViewPages(const ReviewScene& scene, Progress& progress,
                                               const std::stop_token& stop);
/// The charts of each place, or of those that fail or are borderline.
std::vector<BookPage> makeChartPages(const ReviewScene& scene);
/// The tables of the places, for the summary's page and those of makeReviewTablePages().
std::vector<NamedTable> listReviewTables(const ReviewScene& scene);
std::vector<BookPage> makeReviewTablePages(const ReviewScene& scene, std::vector<NamedTable> tables);
std::vector<BookPage> makeMethodPages(const ReviewScene& scene);

void appendPages(std::vector<BookPage>& to, std::vector<BookPage> pages);

/// The clock of the rule, and which trees it counts, in the language of the sheets.
QString clockText(const ReviewScene& scene);
QString treesText(const ReviewScene& scene);

/// "21 March 2026": a day in captions.
QString dayText(CivilDate day);

}  // namespace noonmark
