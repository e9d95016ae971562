#pragma once

#include <QTransform>

#include "core/city/map_context.h"

class QPainter;

namespace noonmark {

/// Paints the map's context quietly: parks, water, paths, rails and streets in pale colours, trees as dots,
/// and over them its picture, with its opacity; of the picture at most 4,096 pixels a side.
/// `toPainter` maps local metres (x east, y north) to the painter's units; lines keep their widths on the
/// ground, but are at least `minLine` units wide. Features outside the painter's clip are left
/// out.
void paintContext(QPainter& painter, const MapContext& context, const QTransform& toPainter, double minLine);

}  // namespace noonmark
