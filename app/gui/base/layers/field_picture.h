#pragma once

#include <QColor>
#include <QString>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "app/report/maps/legend_painter.h"
#include "app/report/maps/shadow_measure.h"
#include "core/measures/colour_scale.h"
#include "core/receivers/place.h"
#include "core/receivers/receivers.h"
#include "render/scene/ground_picture.h"

namespace noonmark {

/// An opaque pixel.
GroundPicture::Pixel pixelOf(const QColor& colour);

/// The colours of 0 to `topMin` minutes, in steps fine enough for a lookup table.
std::vector<GroundPicture::Pixel> paletteOf(const ColourScale& scale, double topMin);

/// A field in the colours of its legend, for the ground of the view. Cells that are not receivers and those
/// that the scale leaves free are transparent.
/// However, a cell under a building gets the mean colour of the adjacent ground receivers, so that no pale
/// steps show along the walls; without `receivers` (null: of a running study) it stays transparent.
/// O(cells).
GroundPicture fieldPicture(const ShadowField& field, const Receivers* receivers, ShadowMeasure measure,
                           const ColourScale& scale);

/// The same for receivers on roofs. Cells beside a roof get its colour, so that the colour reaches the roof's
/// edges. Nothing if no receiver is on a roof.
std::optional<GroundPicture> roofPicture(const ShadowField& field, const Receivers& receivers,
                                         ShadowMeasure measure, const ColourScale& scale);

/// The places on the ground as a raster of their numbers, which is coloured anew in milliseconds. Where
/// places overlap, the smaller one is on top.
class PlacePicture {
public:
    PlacePicture() = default;
    explicit PlacePicture(const std::vector<Place>& places);  ///< some 50 ms for 5,000 places

    [[nodiscard]] std::optional<std::size_t> placeAt(glm::dvec2 point) const;
    /// `colours`: one for each place.
    [[nodiscard]] GroundPicture coloured(std::span<const GroundPicture::Pixel> colours) const;

private:
    Grid grid_;
    std::vector<std::uint32_t> numbers_;  ///< of each pixel: 0 without a place, else its index + 1
};

/// Coloured places that the view shows instead of a result, with their legend and what is told of a point.
struct PlaceView {
    GroundPicture picture;
    Legend legend;
    QString note;
    bool marked = false;        ///< the note is a warning
    double thresholdHours = 0;  ///< of the colours
    std::function<QString(glm::dvec2 point)> describe;
};

}  // namespace noonmark
