#pragma once

#include <QPainterPath>
#include <QRectF>

#include "core/city/footprints/footprint.h"
#include "core/geo/grid.h"
#include "core/receivers/region.h"

namespace noonmark {

/// Where local metres lie on a picture: true north up, the same scale both ways. y of local metres goes up, y
/// of the picture down.
class MapView {
public:
    /// All of `world` and a margin of 4 % around it, in the middle of `target` (units of the painter).
    /// `world` not empty.
    MapView(const Box2& world, const QRectF& target);

    [[nodiscard]] const QRectF& target() const { return target_; }
    [[nodiscard]] double unitsPerM() const { return unitsPerM_; }
    [[nodiscard]] QPointF at(glm::dvec2 local) const;
    [[nodiscard]] QRectF rectOf(const Grid& grid) const;  ///< its cells, from edge to edge
    [[nodiscard]] bool sees(const Box2& box) const;

    /// Adds the rings of the footprint, as closed rings in their own direction: with Qt::WindingFill, holes
    /// stay holes where no other footprint of the path covers them.
    void addTo(QPainterPath& path, const Footprint& footprint) const;

private:
    QRectF target_;
    glm::dvec2 centre_;
    double unitsPerM_;
};

/// Width / height for a frame that suits the region: its own, but never slimmer or flatter than 1 : 2.
double aspectOf(const Box2& world);

}  // namespace noonmark
