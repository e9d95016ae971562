#pragma once

#include <QColor>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/report/maps/answer_legends.h"
#include "app/report/maps/legend_painter.h"
#include "app/report/maps/shadow_measure.h"
#include "core/measures/colour_scale.h"
#include "core/measures/legend_choice.h"
#include "core/receivers/place.h"
#include "core/receivers/receivers.h"
#include "render/scene/element_tiles.h"
#include "render/scene/ground_picture.h"

namespace noonmark {

/// Coloured tiles that the view shows instead of a result, with their legend and the text about each.
struct TileView {
    std::vector<ElementTiles::Tile> tiles;
    Legend legend;  ///< in English, as files have it
    std::function<QString(std::size_t tile)> describe;
};

/// What the view shows of points, and the note beside the legend.
struct ElementView {
    std::shared_ptr<const ElementMap> map;  ///< not null
    QString note;
    bool marked = false;  ///< the note is a warning
    /// Instead of the note while continuous shadow is shown; empty: the note holds for both measures.
    QString runNote{};
};

/// A rectangle for each element, in their order. Those that the scale leaves free
/// have the colour of 0.
std::vector<ElementTiles::Tile> makeTiles(const ElementMap& map, ShadowMeasure measure,
                                          const ColourScale& scale);

/// "floor 3, 4.2 h of sun a day, at most 3.1 h without a break, gross 90.0 min a day, continuous 45.0 min".
QString describe(const MeasuredElement& element);

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

/// Coloured places that the view shows instead of a result, with their legend and the text about a point.
struct PlaceView {
    GroundPicture picture;
    Legend legend;
    QString note;
    bool marked = false;                       ///< the note is a warning
    double thresholdHours = 0;                 ///< of the colours
    ShownAs show = ShownAs::sun;               ///< likewise
    TreeColumns trees = TreeColumns::without;  ///< likewise
    std::function<QString(glm::dvec2 point)> describe;
    /// The same of a scenario that was measured with it, in the same colours; null: it was not.
    std::function<std::shared_ptr<const PlaceView>(const std::string& scenario)> in = [](const std::string&) {
        return nullptr;
    };
};

}  // namespace noonmark
