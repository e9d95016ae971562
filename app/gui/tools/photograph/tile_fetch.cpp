#include "app/gui/tools/photograph/tile_fetch.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImageReader>
#include <QNetworkCookieJar>
#include <QNetworkReply>
#include <QPainter>
#include <utility>

namespace noonmark {

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
