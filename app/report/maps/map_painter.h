#pragma once

#include <functional>

#include "app/report/maps/field_image.h"
#include "app/report/maps/legend_painter.h"
#include "app/report/maps/map_view.h"
#include "app/report/sheets/style.h"
#include "core/study/study.h"

namespace noonmark {

/// What a map shows, whatever it measures: the colours of a grid, with a city's buildings over them. Holds
/// nothing: city and region outlive it, and so does what `image` looks at.
struct MapScene {
    const City& city;
    const Region& region;
    Grid grid;
    std::function<FieldImage(int wantedPixels)> image;  ///< as makeFieldImage()
};
MapScene makeMapScene(const Study& study, ShadowMeasure measure);

/// The view of a scene's map in a frame: its grid and region with a margin, north up.
MapView makeMapView(const MapScene& scene, const QRectF& frame);
/// The view of a study's map in a frame: its grid and region with a margin, north up.
MapView makeMapView(const Study& study, const QRectF& frame);

/// The map alone, in the view's target: the field as a picture, the buildings as crisp outlines over it (pale
/// outside the region), the outline of the region, a thin frame. Nothing is painted outside the target.
void paintMap(const Canvas& canvas, const MapView& view, const MapScene& scene);
void paintMap(const Canvas& canvas, const MapView& view, const Study& study, ShadowMeasure measure);

/// What belongs under a map, legendHeightPt high: legend at the left, scale bar and north arrow at the right.
void paintMapFoot(const Canvas& canvas, const QRectF& area, const MapView& view, const Legend& legend);

}  // namespace noonmark
