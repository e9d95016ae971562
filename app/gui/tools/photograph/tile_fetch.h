#pragma once

#include <QByteArray>
#include <QImage>
#include <QList>
#include <QNetworkAccessManager>
#include <QObject>
#include <deque>

#include "app/gui/tools/photograph/tile_range.h"

class QNetworkReply;

namespace noonmark {

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
