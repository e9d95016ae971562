#include "app/report/sheets/sheet.h"

#include <algorithm>

namespace noonmark {

namespace {

constexpr double widthPt = 640;
constexpr double marginPt = 22;
constexpr double gapPt = 10;
constexpr double smallPrintPt = 12;

/// The areas of the picture from top to bottom, in pixels.
struct Places {
    QSize size;
    QRectF headline, map, foot, smallPrint;
};

Places placesOf(const MapScene& scene, int widthPx) {
    const double point = widthPx / widthPt;
    const double width = widthPt - 2 * marginPt;
    double y = marginPt;
    const auto next = [&](double height, double gap) {
        const QRectF area(marginPt * point, y * point, width * point, height * point);
        y += height + gap;
        return area;
    };
    Places places;
    places.headline = next(headlineHeightPt, 2);
    places.map = next(width / aspectOf(shownGround(scene)), gapPt);
    places.foot = next(legendHeightPt, 4);
    places.smallPrint = next(smallPrintPt, marginPt * 0.6);
    places.size = {widthPx, int(y * point)};
    return places;
}

}  // namespace

QImage makePicture(const Sheet& sheet, int width) {
    width = std::clamp(width, minPictureWidth, maxPictureWidth);
    const Places places = placesOf(sheet.map.scene, width);
    QImage image(places.size, QImage::Format_RGB32);
    image.fill(ink::paper);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const Canvas canvas{painter, width / widthPt};
    const MapView view = makeMapView(sheet.map.scene, places.map);
    paintHeadline(canvas, places.headline, sheet.headline);
    paintMap(canvas, view, sheet.map.scene);
    paintMapFoot(canvas, places.foot, view, sheet.map.legend, sheet.map.scene.city);
    paintSmallPrint(canvas, places.smallPrint, sheet.credit);
    return image;
}

}  // namespace noonmark
