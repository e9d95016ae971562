#pragma once

#include <QTransform>
#include <functional>

#include "app/report/maps/map_view.h"
#include "app/report/maps/style.h"
#include "core/city/city.h"
#include "core/city/map_context.h"

class QPainter;

namespace noonmark {

/// Colours and line width of footprints.
struct FootprintStyle {
    QColor fill;
    QColor line;
    double linePt = 0.25;
    std::function<QColor(const Building&)> fillOf{};  ///< instead of `fill`; empty: all are alike
};

/// The same with proposed buildings (isProposal()) in the colour of proposals.
FootprintStyle withProposals(FootprintStyle style);
/// Of buildings that were demolished: outlines alone.
inline const FootprintStyle demolishedStyle{Qt::transparent, shade::incremental, 0.9};

/// Paints the footprints of all buildings in `view` as vectors. Parts that stand on the ground are filled;
/// overhangs have a dashed outline, because the ground below them is shown. The caller clips. O(points).
void paintBuildings(const Canvas& canvas, const MapView& view, const City& city, const FootprintStyle& style);

/// Whether paintBuildings() draws a dashed outline: of parts that leave the ground below them open.
bool showsOverhangs(const MapView& view, const City& city);

/// Paints the map's context quietly: parks, water, paths, rails and streets in pale colours, trees as dots,
/// and over them its picture, with its opacity; of the picture at most 4,096 pixels a side.
/// `toPainter` maps local metres (x east, y north) to the painter's units; lines keep their widths on the
/// ground, but are at least `minLine` units wide. Features outside the painter's clip are left
/// out, and trees unless `withTrees`.
void paintContext(QPainter& painter, const MapContext& context, const QTransform& toPainter, double minLine,
                  bool withTrees = true);

}  // namespace noonmark
