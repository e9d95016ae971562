#include "app/gui/tools/photograph/tile_range.h"

#include <QUrl>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace noonmark {

namespace {

constexpr double mercatorRadiusM = 6378137;  // EPSG:3857
constexpr double farthestLatDeg = 85.0511;   // where the scheme's square ends

// Position in the scheme's square, 0 to 1 from the north-west.
glm::dvec2 squareFromLonLat(LonLat place) {
    const double lat = std::clamp(place.latDeg, -farthestLatDeg, farthestLatDeg) * std::numbers::pi / 180;
    return {place.lonDeg / 360 + 0.5, 0.5 - std::asinh(std::tan(lat)) / (2 * std::numbers::pi)};
}

TileRange rangeAt(int zoom, glm::dvec2 low, glm::dvec2 high) {
    const double tiles = std::exp2(zoom);
    const auto tileAt = [tiles](double share) { return std::clamp(int(share * tiles), 0, int(tiles) - 1); };
    const int west = tileAt(low.x), north = tileAt(low.y);
    return {zoom, west, north, tileAt(high.x) - west + 1, tileAt(high.y) - north + 1};
}

}  // namespace

TileRange chooseTiles(const Frame& frame, const Box2& box, int most) {
    glm::dvec2 low(1), high(0);
    for (const glm::vec2 corner :
         {box.low, box.high, glm::vec2(box.low.x, box.high.y), glm::vec2(box.high.x, box.low.y)}) {
        const glm::dvec2 at = squareFromLonLat(frame.lonLatFromLocal(glm::dvec2(corner)));
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    TileRange best = rangeAt(0, low, high);
    for (int zoom = 1; zoom <= finestZoom; ++zoom)
        if (const TileRange range = rangeAt(zoom, low, high); range.count() <= most) best = range;
    return best;
}

std::array<double, 6> computeTransform(const TileRange& range, int tilePixels) {
    const double halfM = std::numbers::pi * mercatorRadiusM;
    const double tileM = 2 * halfM / std::exp2(range.zoom);
    return {range.west * tileM - halfM, tileM / tilePixels, 0, halfM - range.north * tileM, 0,
            -tileM / tilePixels};
}

Result<void> checkTemplate(const QString& address) {
    const QUrl url(addressOf(address, 0, 0, 0));
    const bool web = url.scheme() == QStringLiteral("http") || url.scheme() == QStringLiteral("https");
    if (!url.isValid() || !web || url.host().isEmpty())
        return failure("The address is none of a web server", address.toStdString(),
                       "Type an address such as https://tiles.example.org/{z}/{x}/{y}.png");
    for (const char* part : {"{x}", "{y}", "{z}"})
        if (!address.contains(QLatin1String(part)))
            return failure(std::string("The address lacks ") + part, address.toStdString(),
                           "Type {z} for the zoom, {x} and {y} for the tile");
    return {};
}

QString addressOf(const QString& address, int zoom, int x, int y) {
    QString made = address;
    made.replace(QStringLiteral("{z}"), QString::number(zoom));
    made.replace(QStringLiteral("{x}"), QString::number(x));
    return made.replace(QStringLiteral("{y}"), QString::number(y));
}

}  // namespace noonmark
