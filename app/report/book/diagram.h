#pragma once

#include <QRectF>
#include <memory>
#include <optional>
#include <vector>

#include "app/report/book/page_text.h"
#include "app/report/maps/legend_painter.h"
#include "app/report/maps/map_view.h"
#include "app/report/maps/style.h"
#include "core/base/units.h"
#include "core/city/city.h"
#include "core/measures/shadow_outlines.h"
#include "core/receivers/place.h"

namespace noonmark {

/// Where the name of a street can be painted along it.
struct StreetNameSpot {
    QPointF middle;       ///< of the text, painter units
    double angleDeg = 0;  ///< clockwise in the picture, from -90 to 90, so that the text is not upside down
    double room = 0;      ///< along the street, painter units
};

/// The middle of the longest straight side of a street that is seen in the view, moved to the middle of the
/// street, whose width is taken as that of the whole. Nothing where no side is seen.
std::optional<StreetNameSpot> findStreetNameSpot(const Place& street, const MapView& view);

/// What all diagrams of a book show.
struct DiagramScene {
    City city;      ///< the scenario's buildings that the baseline has, too
    City proposal;  ///< the buildings that only the scenario has
    City removed;   ///< the buildings that only the baseline has
    std::vector<Place> places;
    std::vector<int> numbers{};          ///< by place: painted instead of its name, 0: neither; empty: names
    std::vector<QColor> placeColours{};  ///< of outlines, by place: of their verdicts; empty: all the same
    std::vector<Place> streets{};        ///< for orientation: lines and names
    UnitSystem units = UnitSystem::metric;  ///< of the heights
};

/// One shadow of a fan.
struct FanShadow {
    QString time;  ///< painted at its tip
    std::vector<Footprint> polygons;
};

/// A line on which a value is the same, or at a distance from a parcel.
struct ValueLine {
    QString label;
    bool isDistance = false;                     ///< dashed
    std::vector<std::vector<glm::dvec2>> lines;  ///< local metres
    bool isLimit = false;                        ///< of a rule; drawn thicker
};

/// A plan view at a scale, north up, as vectors, with its caption below. Ground that does not fit is cut off
/// at the frame of the view.
struct Diagram {
    std::shared_ptr<const DiagramScene> scene;  ///< not null
    ShadowOutlines shadows;
    std::vector<FanShadow> fan{};
    std::vector<ValueLine> valueLines{};
    glm::dvec2 centre{};  ///< local metres, in the middle of the view
    double scale = 2000;  ///< 1:scale on paper
    Caption caption;
    double textScale = 1;
};

/// Legend, scale, scale bar and north arrow of the diagrams above it.
struct DiagramFoot {
    double scale = 2000;
    QString paper;  ///< "A3": the scale holds on it, and is printed; empty: only the scale bar
    QString note;   ///< the clock of the captions; may be empty
    double textScale = 1;
    enum class Subject { shadows, fan, valueLines };
    Subject subject = Subject::shadows;
    UnitSystem units = UnitSystem::metric;
    /// What the legend explains besides.
    std::vector<LegendPatch> places{};  ///< what colours of outlines mean; empty: all are the same
    bool hasRemoved = false, hasOverhangs = false, hasStreets = false, hasContext = false, hasNumbers = false;
};
constexpr double diagramFootPt(double scale) { return 40 * scale; }

/// The part of a diagram's area that the map fills.
QRectF mapAreaOf(const QRectF& area, double textScale);

/// The ground that a map shows around `centre`; `scale`: of 1:scale.
Box2 groundOf(glm::dvec2 centre, double scale, const QRectF& map);

void paintDiagram(const Canvas& canvas, const QRectF& area, const Diagram& diagram);
void paintDiagramFoot(const Canvas& canvas, const QRectF& area, const DiagramFoot& foot);

}  // namespace noonmark
