#pragma once

// The pages of a review's book. review_book.cpp puts them together.

#include "app/report/book/review/review_book.h"
#include "core/review/rule/rule_days.h"

namespace noonmark {

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

/// The areas of the diagrams of a page, row by row, in points; their foot is below them.
std::vector<QRectF> diagramAreas(const PageSetup& setup, int columns, int rows);
/// The same without room for a foot.
std::vector<QRectF> gridAreas(const PageSetup& setup, int columns, int rows);

/// The round scale and the most views a page that show all of `reach` (or, where that takes more than 1:5000,
/// all of `focus`). With a given scale: the most views that show `focus`; if none does, one view of what is
/// nearest to `proposal`.
DiagramLayout chooseLayout(const BookSettings& settings, const Box2& proposal, const Box2& focus,
                           const Box2& reach);

/// Where the shadows of what changes reach at the moments, cut at 1.5 km.
Box2 reachOf(const ReviewScene& scene, const std::vector<DiagramMoment>& moments);
/// What changes, and the places as far as its shadows reach.
Box2 focusOf(const ReviewScene& scene, const std::vector<DiagramMoment>& moments);
DiagramLayout layoutOf(const ReviewScene& scene);
/// One view in an area, at the largest round scale at which it shows a box; else at 1:maxScale.
DiagramLayout fitInto(const QRectF& area, double textScale, const Box2& shown, double maxScale = 5000);

/// The moment at which most of any place is in incremental shadow; else the moment nearest to noon. Nothing
/// without any sun.
std::optional<DiagramMoment> worstMoment(const ReviewScene& scene);

/// The diagram of a moment in an area of the page. Errors of outlineShadows().
Result<Diagram> makeDiagram(const ReviewScene& scene, const DiagramMoment& moment,
                            const DiagramLayout& layout, const QRectF& area, Progress& progress,
                            const std::stop_token& stop);

Result<std::vector<BookPage>> makeSummaryPages(const ReviewScene& scene, Progress& progress,
                                               const std::stop_token& stop);
Result<std::vector<BookPage>> makeDiagramPages(const ReviewScene& scene, Progress& progress,
                                               const std::stop_token& stop);
/// Lines of equal hours of shadow on a day (index in RuleSun::sun.days), around what changes.
Result<Diagram> makeIsochrones(const ReviewScene& scene, std::size_t day, const QRectF& area,
                               const std::stop_token& stop);
/// Of rules whose diagrams have them.
Result<std::vector<BookPage>> makeIsochronePages(const ReviewScene& scene, Progress& progress,
                                                 const std::stop_token& stop);
Result<std::vector<BookPage>> makeFanPages(const ReviewScene& scene, Progress& progress,
                                           const std::stop_token& stop);
Result<std::vector<BookPage>> makeSunViewPages(const ReviewScene& scene, Progress& progress,
                                               const std::stop_token& stop);
std::vector<BookPage> makeChartPages(const ReviewScene& scene);
std::vector<BookPage> makeReviewTablePages(const ReviewScene& scene);
std::vector<BookPage> makeMethodPages(const ReviewScene& scene);

void appendPages(std::vector<BookPage>& to, std::vector<BookPage> pages);

/// "21 March 2026": a day in captions.
QString dayText(CivilDate day);

}  // namespace noonmark
