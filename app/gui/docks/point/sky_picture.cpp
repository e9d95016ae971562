#include "app/gui/docks/point/sky_picture.h"

#include <QPainter>
#include <algorithm>

#include "app/report/skyline/skyline_svg.h"

namespace noonmark {

namespace {

constexpr int minWidthPx = 420;

}  // namespace

SkyPicture::SkyPicture(QWidget* parent) : QWidget(parent) {}

void SkyPicture::setDrawing(const QByteArray& svg) {
    renderer_.load(svg);
    fitInto(room_);
    update();
}

void SkyPicture::fitInto(QSize room) {
    room_ = room;
    const int width = std::min(
        room.width(), std::max(minWidthPx, int(room.height() * skylineSvgWidthPx / skylineSvgUpperPx)));
    setFixedSize(width, heightFor(width));
}

int SkyPicture::heightFor(int widthPx) const {
    const QSize size = renderer_.defaultSize();
    return renderer_.isValid() && size.width() > 0 ? widthPx * size.height() / size.width() : 0;
}

QImage SkyPicture::image(int widthPx) {
    QImage image(widthPx, std::max(1, heightFor(widthPx)), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    renderer_.render(&painter);
    return image;
}

void SkyPicture::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    renderer_.render(&painter, QRectF(rect()));
}

}  // namespace noonmark
