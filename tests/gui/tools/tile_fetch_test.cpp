#include "app/gui/tools/photograph/tile_fetch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QBuffer>
#include <QLineEdit>
#include <QPushButton>
#include <QTcpServer>
#include <QTcpSocket>
#include <map>

#include "app/gui/tools/photograph/photograph_dialog.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;
using testing::HasSubstr;

QByteArray pngOf(const QColor& colour, int side = 256) {
    QImage image(side, side, QImage::Format_RGB32);
    image.fill(colour);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

/// A server of tiles on this machine.
struct TileFetchTest : ::testing::Test {
    QTcpServer server;
    std::map<QString, QByteArray> tiles;  ///< by path; others: 404
    QStringList asked;
    TileFetch fetch;
    std::string error;
    bool finished = false;

    void SetUp() override {
        ASSERT_TRUE(server.listen(QHostAddress::LocalHost));
        QObject::connect(&server, &QTcpServer::newConnection, &server, [this] {
            QTcpSocket* socket = server.nextPendingConnection();
            QObject::connect(socket, &QTcpSocket::readyRead, socket, [this, socket] { answer(*socket); });
        });
        QObject::connect(&fetch, &TileFetch::failed,
                         [this](const Error& failure) { error = failure.text(); });
        QObject::connect(&fetch, &TileFetch::finished, [this] { finished = true; });
    }

    void answer(QTcpSocket& socket) {
        const QString path = QString::fromLatin1(socket.readAll()).section(QLatin1Char(' '), 1, 1);
        asked << path;
        const auto tile = tiles.find(path);
        const QByteArray body = tile == tiles.end() ? QByteArray() : tile->second;
        socket.write(tile == tiles.end() ? "HTTP/1.1 404 Not Found\r\n" : "HTTP/1.1 200 OK\r\n");
        socket.write("Connection: close\r\nContent-Length: " + QByteArray::number(body.size()) + "\r\n\r\n");
        socket.write(body);
        socket.disconnectFromHost();
    }

    [[nodiscard]] QString address() const {
        return QStringLiteral("http://127.0.0.1:%1/{z}/{x}/{y}.png").arg(server.serverPort());
    }

    void fetchAll() {
        fetch.start(address(), {3, 4, 2, 2, 1});
        ASSERT_TRUE(waitFor([this] { return finished || !error.empty(); }));
    }
};

TEST_F(TileFetchTest, TilesAreJoined) {
    tiles = {{QStringLiteral("/3/4/2.png"), pngOf(Qt::red)}, {QStringLiteral("/3/5/2.png"), pngOf(Qt::blue)}};
    fetchAll();
    EXPECT_EQ(error, "");
    ASSERT_EQ(fetch.picture().size(), QSize(512, 256));
    EXPECT_EQ(fetch.picture().pixelColor(10, 200), QColor(Qt::red));
    EXPECT_EQ(fetch.picture().pixelColor(500, 20), QColor(Qt::blue));
    EXPECT_EQ(fetch.missing(), 0);
}

TEST_F(TileFetchTest, MissingTilesStayTransparentAndAreCounted) {
    tiles = {{QStringLiteral("/3/5/2.png"), pngOf(Qt::blue)}};
    fetchAll();
    EXPECT_EQ(fetch.missing(), 1);
    EXPECT_EQ(fetch.picture().pixelColor(10, 10).alpha(), 0);
}

TEST_F(TileFetchTest, WhatIsNoTileEndsTheFetch) {
    tiles = {{QStringLiteral("/3/4/2.png"), "<html>forbidden</html>"},
             {QStringLiteral("/3/5/2.png"), pngOf(Qt::blue)}};
    fetchAll();
    EXPECT_THAT(error, HasSubstr("no picture of a tile"));
    EXPECT_FALSE(fetch.busy());
}

TEST_F(TileFetchTest, AServerWithoutTilesOfThisPlaceIsReported) {
    fetchAll();
    EXPECT_THAT(error, HasSubstr("no tile of this place"));
}

TEST_F(TileFetchTest, TheDialogFetchesNothingBeforeItsButtonIsPressed) {
    tiles = {{QStringLiteral("/3/4/2.png"), pngOf(Qt::red)}};
    TileDialog dialog({3, 4, 2, 1, 1});
    auto* button = dialog.findChild<QPushButton*>(QStringLiteral("tileFetch"));
    dialog.findChild<QLineEdit*>(QStringLiteral("tileAddress"))->setText(address());
    EXPECT_FALSE(button->isEnabled()) << "without attribution";
    dialog.findChild<QLineEdit*>(QStringLiteral("tileAttribution"))->setText(QStringLiteral("(c) Test"));
    EXPECT_TRUE(button->isEnabled());
    EXPECT_TRUE(asked.isEmpty());
    button->click();
    EXPECT_TRUE(waitFor([&] { return dialog.result() == QDialog::Accepted; }));
    EXPECT_EQ(asked, QStringList{QStringLiteral("/3/4/2.png")});
    EXPECT_EQ(dialog.fetch().picture().pixelColor(1, 1), QColor(Qt::red));
}

TEST(TileRange, KnownTilesOfKnownPlaces) {
    // At zoom 10 the tile over 4.45 E, 51.9 N is x 524, y 338 (by the scheme's formulas).
    const Frame frame({4.45, 51.9});
    TileRange range = chooseTiles(frame, {{-1, -1}, {1, 1}}, 1);
    EXPECT_EQ(range.count(), 1);
    for (; range.zoom > 10; --range.zoom) range = {range.zoom, range.west / 2, range.north / 2, 1, 1};
    EXPECT_EQ(range.west, 524);
    EXPECT_EQ(range.north, 338);
    EXPECT_LE(chooseTiles(frame, {{-5000, -5000}, {5000, 5000}}).count(), maxTiles);
    // The whole world is one tile of 2 x 20,037,508.34 m.
    EXPECT_NEAR(computeTransform({0, 0, 0, 1, 1}, 256)[0], -20037508.34, 0.01);
    EXPECT_NEAR(computeTransform({0, 0, 0, 1, 1}, 256)[1], 156543.034, 0.001);
}

TEST(TileRange, AddressesWithoutPlaceholdersAreRefused) {
    EXPECT_TRUE(checkTemplate(QStringLiteral("https://a.org/{z}/{x}/{y}.png")));
    EXPECT_TRUE(checkTemplate(QStringLiteral("https://a.org/?z={z}&x={x}&y={y}")));
    for (const char* wrong :
         {"https://a.org/{z}/{x}.png", "ftp://a.org/{z}/{x}/{y}", "/{z}/{x}/{y}", "", "file:///{z}/{x}/{y}"})
        EXPECT_FALSE(checkTemplate(QString::fromLatin1(wrong))) << wrong;
    EXPECT_EQ(addressOf(QStringLiteral("http://a/{z}/{x}/{y}"), 1, 2, 3), QStringLiteral("http://a/1/2/3"));
}

}  // namespace
}  // namespace noonmark
