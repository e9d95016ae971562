#pragma once

// The folder app/report/maps/ paints maps for reports, pictures and the window. This file makes the picture
// of the cells and paints a map from a MapScene: that picture with the buildings (city_painter.h) in the
// projection to the page (map_view.h, which has scale bar and north arrow, too). legend_painter.h paints
// legends; those of comparisons and scores come from answer_legends.h.

#include <QColor>
#include <QImage>
#include <functional>
#include <memory>
#include <optional>

#include "app/report/maps/legend_painter.h"
#include "app/report/maps/map_view.h"
#include "app/report/maps/shadow_measure.h"
#include "app/report/maps/style.h"
#include "core/base/units.h"
#include "core/measures/colour_scale.h"
#include "core/receivers/receivers.h"
#include "core/study/study.h"

namespace noonmark {

/// A field as a picture of its grid, north up: the top left pixel lies at the grid's north-western corner.
struct FieldImage {
    QImage image;
    int cellsPerPixel = 1;  ///< per side; the last column and row of pixels may extend beyond the grid
};

/// One pixel per cell, or per k x k cells their mean over the receivers where at least `wantedPixels` remain
/// on the longer side. Cells that are not receivers and those that the scale leaves free are
/// white, except that at one pixel per cell a cell under a building takes the mean colour of adjacent
/// receivers, so that no white steps appear along its walls. O(cells).
FieldImage makeFieldImage(const ShadowField& field, const Receivers& receivers, ShadowMeasure measure,
                          const ColourScale& scale, int wantedPixels);

/// The same for arbitrary colours of the grid's cells; empty is white. Where k x k cells share a pixel it has
/// their mean colour. O(cells).
using CellColour = std::function<std::optional<QColor>(std::size_t cell)>;
FieldImage makeColourImage(const Grid& grid, const CellColour& colour, int wantedPixels);

/// A number or a letter at a place, in local metres.
struct MapMark {
    glm::dvec2 at;
    QString text;
};

/// The contents of a map of any measure: the colours of a grid with a city's buildings over them, proposed
/// ones (isProposal()) in a colour of their own. Owns nothing but `removed`: city, region, proposal and the
/// data used by `image` and `ground` must outlive it.
struct MapScene {
    const City& city;
    const Region& region;
    Grid grid;
    std::function<FieldImage(int wantedPixels)> image;  ///< as makeFieldImage(); empty: no field
    std::vector<MapMark> marks{};                       ///< one that would cover an earlier one is left out
    const City* proposal = nullptr;  ///< new buildings, drawn over the city, each with its height
    std::optional<Box2> shown{};     ///< none: grid and region
    /// The colour of each building; empty: grey, and pale outside the region.
    std::function<QColor(const Building&)> fillOf{};
    /// Buildings of the baseline alone, drawn as outlines (findAbsent()). Null: none.
    std::shared_ptr<const City> removed{};
    /// Painted below the buildings, over the field; empty: nothing.
    std::function<void(const Canvas&, const MapView&)> ground{};
};
/// Of the buildings that only the baseline has those whose id `after` has no more: the others were changed.
/// Null: none.
std::shared_ptr<const City> findAbsent(City onlyBefore, const City& after);
/// The ground that a map of the scene shows.
Box2 shownGround(const MapScene& scene);
/// The part of a map that is worth showing alone: `changed` with some ground around it. None: it is empty, or
/// most of the map.
std::optional<Box2> zoomOn(const Box2& changed, const MapScene& scene);
MapScene makeMapScene(const Study& study, ShadowMeasure measure, const LegendChoice& choice = {});
/// Gross shadow alone in given colours: for maps that share a scale.
MapScene makeGrossScene(const City& city, const Region& region, const ShadowField& field,
                        const ColourScale& scale);

/// The view of a scene's map in a frame: shownGround() with a margin, north up.
MapView makeMapView(const MapScene& scene, const QRectF& frame);
/// The same for the map of a study.
MapView makeMapView(const Study& study, const QRectF& frame);

/// Paints only the map, inside the view's target: the field as a picture, the buildings as outlines over it
/// (pale outside the region), the outline of the region, the marks, a thin frame. Nothing is painted outside
/// the target.
void paintMap(const Canvas& canvas, const MapView& view, const MapScene& scene,
              UnitSystem units = UnitSystem::metric);
void paintMap(const Canvas& canvas, const MapView& view, const Study& study, ShadowMeasure measure);

/// Paints the foot of a map, legendHeightPt high: legend at the left, scale bar and north arrow at the right,
/// and what tints and outlines of buildings mean where the map has them.
void paintMapFoot(const Canvas& canvas, const QRectF& area, const MapView& view, const Legend& legend,
                  const MapScene& scene, UnitSystem units = UnitSystem::metric);

}  // namespace noonmark
