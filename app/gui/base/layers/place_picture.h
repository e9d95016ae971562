#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "app/report/maps/legend_painter.h"
#include "core/receivers/place.h"
#include "render/scene/ground_picture.h"

namespace noonmark {

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
