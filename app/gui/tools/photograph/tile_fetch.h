#pragma once

#include <QByteArray>
#include <QImage>
#include <QList>
#include <QNetworkAccessManager>
#include <QObject>
#include <QString>
#include <array>
#include <deque>

#include "core/base/result.h"
#include "core/city/footprints/footprint.h"
#include "core/geo/frame.h"

class QNetworkReply;

namespace noonmark {

/// Tiles of the web's map scheme ("XYZ"): 2^zoom x 2^zoom squares of Web Mercator, x from the west, y from
/// the north.
struct TileRange {
    int zoom = 0;
    int west = 0, north = 0;    ///< the first x and y
    int columns = 0, rows = 0;  ///< 1 or more
    [[nodiscard]] int count() const { return columns * rows; }
    bool operator==(const TileRange&) const = default;
};

/// No more tiles are fetched for one picture.
inline constexpr int maxTiles = 256;
inline constexpr int finestZoom = 19;

/// The tiles over `box` (local metres) at the finest zoom, up to finestZoom, at which there are no more than
/// `maximum`.
TileRange chooseTiles(const Frame& frame, const Box2& box, int maximum = maxTiles);

/// The range's georeference in EPSG:3857 for tiles of this many pixels, as GDAL has it.
std::array<double, 6> computeTransform(const TileRange& range, int tilePixels);

/// Error: not http or https, or without {x}, {y} or {z}.
Result<void> checkTemplate(const QString& address);

/// The address of a tile: {x}, {y} and {z} are replaced.
QString addressOf(const QString& address, int zoom, int x, int y);

/// Fetches the tiles of a range and joins them into one picture. The only part of the program that reaches
/// the network, and only after start(). Tiles that the server does not have (404) stay transparent and are
/// counted; any other failure ends the fetch. No cookies, no cache, no redirects from https to http; a tile
/// has at most 4 MB and 30 s.
class TileFetch final : public QObject {
    Q_OBJECT
public:
    explicit TileFetch(QObject* parent = nullptr);
    ~TileFetch() override;

    /// `address`: checkTemplate() accepts it. `range`: at most maxTiles. Not while it is busy.
    void start(const QString& address, const TileRange& range);
    void cancel();  ///< ends without a signal
    [[nodiscard]] bool busy() const { return left_ > 0; }
    [[nodiscard]] const QImage& picture() const { return picture_; }  ///< RGBA, row 0 in the north
    [[nodiscard]] int missing() const { return missing_; }
    [[nodiscard]] const TileRange& range() const { return range_; }

Q_SIGNALS:
    void progressed(int done, int all);
    void finished();
    void failed(noonmark::Error error);

private:
    void fetchNext();
    void take(QNetworkReply& reply, int tile);
    bool paint(const QByteArray& bytes, int tile);
    void fail(const QString& what);

    QNetworkAccessManager network_;
    QString address_;
    TileRange range_;
    std::deque<int> waiting_;
    QList<QNetworkReply*> running_;
    int left_ = 0;
    int missing_ = 0;
    QImage picture_;
};

}  // namespace noonmark
