#include "app/report/map_picture.h"

#include "app/report/headline.h"
#include "app/report/legend_painter.h"
#include "app/report/map_painter.h"

namespace noonmark {

namespace {

constexpr double widthPt = 640;
constexpr double point = pictureWidth / widthPt;
constexpr double marginPt = 22;
constexpr double gapPt = 10;
constexpr double smallPrintPt = 12;

/// The parts of the sheet from top to bottom, in pixels.
struct Sheet {
    QSize size;
    QRectF headline, map, foot, smallPrint;
};

Sheet sheetOf(const Study& study) {
    const double width = widthPt - 2 * marginPt;
    double y = marginPt;
    const auto next = [&](double height, double gap) {
        const QRectF area(marginPt * point, y * point, width * point, height * point);
        y += height + gap;
        return area;
    };
    Sheet sheet;
    sheet.headline = next(headlineHeightPt, 2);
    sheet.map = next(width / aspectOf(bounds(study.settings.region)), gapPt);
    sheet.foot = next(legendHeightPt, 4);
    sheet.smallPrint = next(smallPrintPt, marginPt * 0.6);
    sheet.size = {pictureWidth, int(y * point)};
    return sheet;
}

}  // namespace

QImage mapPicture(const Study& study, ShadowMeasure measure) {
    const Sheet sheet = sheetOf(study);
    QImage image(sheet.size, QImage::Format_RGB32);
    image.fill(ink::paper);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const Canvas canvas{painter, point};
    const MapView view = mapViewOf(study, sheet.map);
    const QString subject = isInstant(study.field) ? QStringLiteral("Shadow") : nameOf(measure);
    paintHeadline(canvas, sheet.headline, headlineOf(study, subject));
    paintMap(canvas, view, study, measure);
    paintMapFoot(canvas, sheet.foot, view, study, measure);
    paintSmallPrint(canvas, sheet.smallPrint, study);
    return image;
}

}  // namespace noonmark
