#pragma once

#include <QPainterPath>
#include <QRectF>
#include <QTransform>

#include "app/report/maps/style.h"
#include "core/base/units.h"
#include "core/city/footprints/footprint.h"
#include "core/geo/grid.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Maps local metres to positions in a picture: true north up, the same scale in both directions. Local y
/// points up, picture y points down.
class MapView {
public:
    /// Centres `world` with a margin of 4 % in `target` (painter units). `world` must not be empty.
    MapView(const Box2& world, const QRectF& target);
    /// Shows `centre` in the middle of `target` at a scale, in painter units per metre.
    MapView(glm::dvec2 centre, double unitsPerM, const QRectF& target)
        : target_(target), centre_(centre), unitsPerM_(unitsPerM) {}

    [[nodiscard]] const QRectF& target() const { return target_; }
    [[nodiscard]] double unitsPerM() const { return unitsPerM_; }
    [[nodiscard]] QPointF at(glm::dvec2 local) const;
    [[nodiscard]] QTransform transform() const;           ///< at() of all points
    [[nodiscard]] QRectF rectOf(const Grid& grid) const;  ///< the cells, from edge to edge
    [[nodiscard]] bool sees(const Box2& box) const;

    /// Adds the rings of the footprint as closed rings in their own direction. With Qt::WindingFill holes
    /// remain holes where no other footprint of the path covers them.
    void addTo(QPainterPath& path, const Footprint& footprint) const;

private:
    QRectF target_;
    glm::dvec2 centre_;
    double unitsPerM_;
};

/// Width / height of a frame for the region: the region's own aspect, limited to 1 : 2 and 2 : 1.
double aspectOf(const Box2& world);

/// A scale bar of `parts` fields of `partM` metres each.
struct ScaleBar {
    double partM = 1;
    int parts = 2;
    bool inFeet = false;  ///< labelled in feet or miles, not in metres or kilometres
    [[nodiscard]] double lengthM() const { return partM * parts; }
};

/// The longest bar of a round length (1, 2 or 5 times a power of ten) of at most `longestM` metres (> 0): in
/// feet for imperial units, or in miles from one on; in metres for the others.
ScaleBar scaleBarWithin(double longestM, UnitSystem units = UnitSystem::metric);

/// Height of a labelled scale bar or a north arrow, points.
constexpr double scaleBarHeightPt = 30;

/// Paints the bar with its labels at a scale of `unitsPerM`; its right end touches
/// the right edge of `area`.
void paintScaleBar(const Canvas& canvas, const QRectF& area, const ScaleBar& bar, double unitsPerM);

/// Paints an arrow with its letter in the centre of `area`; true north is up.
void paintNorthArrow(const Canvas& canvas, const QRectF& area);

}  // namespace noonmark
