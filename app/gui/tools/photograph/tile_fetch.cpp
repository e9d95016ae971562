#include "app/gui/tools/photograph/tile_fetch.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImageReader>
#include <QNetworkCookieJar>
#include <QNetworkReply>
#include <QPainter>
#include <QUrl>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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

TileRange chooseTiles(const Frame& frame, const Box2& box, int maximum) {
    glm::dvec2 low(1), high(0);
    for (const glm::vec2 corner :
         {box.low, box.high, glm::vec2(box.low.x, box.high.y), glm::vec2(box.high.x, box.low.y)}) {
        const glm::dvec2 at = squareFromLonLat(frame.lonLatFromLocal(glm::dvec2(corner)));
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    TileRange best = rangeAt(0, low, high);
    for (int zoom = 1; zoom <= finestZoom; ++zoom)
        if (const TileRange range = rangeAt(zoom, low, high); range.count() <= maximum) best = range;
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
        return failure("The address is not that of a web server", address.toStdString(),
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

namespace {

constexpr int atOnce = 4;  // as a browser: more would burden the server
constexpr qint64 maxTileBytes = 4'000'000;
constexpr int maxTilePixels = 512;
constexpr int patienceMs = 30000;

/// Keeps nothing.
class NoCookies final : public QNetworkCookieJar {
public:
    bool setCookiesFromUrl(const QList<QNetworkCookie>&, const QUrl&) override { return false; }
};

QNetworkRequest requestOf(const QString& address) {
    QNetworkRequest request{QUrl(address)};
    request.setHeader(QNetworkRequest::UserAgentHeader,
                      QStringLiteral("Noonmark/") + QCoreApplication::applicationVersion());
    request.setTransferTimeout(patienceMs);
    request.setMaximumRedirectsAllowed(3);
    return request;
}

int statusOf(const QNetworkReply& reply) {
    return reply.attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
}

// A square picture of a usual format; null for anything else.
QImage decode(QByteArray bytes) {
    QBuffer buffer(&bytes);
    QImageReader reader(&buffer);
    reader.setDecideFormatFromContent(true);
    const QSize size = reader.size();
    if (size.width() != size.height() || size.width() < 1 || size.width() > maxTilePixels) return {};
    return reader.read().convertToFormat(QImage::Format_RGBA8888);
}

}  // namespace

TileFetch::TileFetch(QObject* parent) : QObject(parent) { network_.setCookieJar(new NoCookies); }

TileFetch::~TileFetch() { cancel(); }

void TileFetch::start(const QString& address, const TileRange& range) {
    address_ = address;
    range_ = range;
    picture_ = {};
    missing_ = 0;
    left_ = range.count();
    waiting_.clear();
    for (int tile = 0; tile < left_; ++tile) waiting_.push_back(tile);
    while (running_.size() < atOnce && !waiting_.empty()) fetchNext();
}

void TileFetch::cancel() {
    left_ = 0;
    waiting_.clear();
    for (QNetworkReply* reply : std::exchange(running_, {})) {
        reply->disconnect(this);
        reply->abort();
        reply->deleteLater();
    }
}

void TileFetch::fetchNext() {
    const int tile = waiting_.front();
    waiting_.pop_front();
    QNetworkReply* reply = network_.get(requestOf(addressOf(
        address_, range_.zoom, range_.west + tile % range_.columns, range_.north + tile / range_.columns)));
    running_ << reply;
    connect(reply, &QNetworkReply::downloadProgress, this, [reply](qint64 received, qint64) {
        if (received > maxTileBytes) reply->abort();
    });
    connect(reply, &QNetworkReply::finished, this, [this, reply, tile] { take(*reply, tile); });
}

void TileFetch::take(QNetworkReply& reply, int tile) {
    running_.removeOne(&reply);
    reply.deleteLater();
    const bool isMissing = statusOf(reply) == 404;
    if (isMissing)
        ++missing_;
    else if (reply.error() != QNetworkReply::NoError)
        return fail(reply.errorString());
    else if (!paint(reply.readAll(), tile))
        return fail(tr("%1 is no picture of a tile").arg(reply.url().toString()));
    --left_;
    Q_EMIT progressed(range_.count() - left_, range_.count());
    if (!waiting_.empty()) return fetchNext();
    if (left_ > 0) return;
    if (picture_.isNull()) return fail(tr("The server has no tile of this place"));
    Q_EMIT finished();
}

// The first tile says how many pixels a tile has.
bool TileFetch::paint(const QByteArray& bytes, int tile) {
    const QImage image = decode(bytes);
    if (image.isNull()) return false;
    if (picture_.isNull()) {
        picture_ =
            QImage(range_.columns * image.width(), range_.rows * image.width(), QImage::Format_RGBA8888);
        picture_.fill(Qt::transparent);
    }
    const int side = picture_.width() / range_.columns;
    if (image.width() != side) return false;
    QPainter painter(&picture_);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.drawImage(tile % range_.columns * side, tile / range_.columns * side, image);
    return true;
}

void TileFetch::fail(const QString& what) {
    cancel();
    Q_EMIT failed({what.toStdString(), address_.toStdString(),
                   "Check the address, the network and what the owner of the tiles allows"});
}

}  // namespace noonmark
