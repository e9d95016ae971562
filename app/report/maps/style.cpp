#include "app/report/maps/style.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace noonmark {

namespace {
QFont sizeFont(const Canvas& canvas, QFont font, double points) {
    font.setPixelSize(std::max(1, int(std::lround(points * canvas.point))));
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}
}  // namespace

QColor readableOn(const QColor& paper, const QColor& colour) {
    constexpr int minDifference = 60;  // of lightness, of 255
    const int lightness = colour.lightness();
    if (std::abs(lightness - paper.lightness()) >= minDifference) return colour;
    return QColor::fromHsl(colour.hslHue(), colour.hslSaturation(), 255 - lightness, colour.alpha());
}

QFont textFont(const Canvas& canvas, double points, QFont::Weight weight) {
    QFont font;
    font.setFamilies({QStringLiteral("Roboto"), QStringLiteral("DejaVu Sans"), QStringLiteral("Noto Sans")});
    font.setStyleHint(QFont::SansSerif);
    font.setWeight(weight);
    return sizeFont(canvas, font, points);
}

QFont codeFont(const Canvas& canvas, double points) {
    QFont font;
    font.setFamilies(
        {QStringLiteral("DejaVu Sans Mono"), QStringLiteral("Noto Sans Mono"), QStringLiteral("monospace")});
    font.setStyleHint(QFont::Monospace);
    return sizeFont(canvas, font, points);
}

QPen linePen(const Canvas& canvas, const QColor& colour, double points) {
    QPen pen(colour, points * canvas.point);
    pen.setJoinStyle(Qt::MiterJoin);
    pen.setCapStyle(Qt::FlatCap);
    return pen;
}

}  // namespace noonmark
