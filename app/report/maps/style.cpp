#include "app/report/maps/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace noonmark {

QColor toColour(Rgb rgb) { return {rgb.red, rgb.green, rgb.blue}; }

QColor shadowColour(double share) { return toColour(shadowRgb(share)); }

QColor impactColour(double share) { return toColour(impactRgb(share)); }

QColor seriesColour(std::size_t series) {
    static constexpr std::array<QColor, maxSeries> colours{shade::baseline,          shade::sun,
                                                           QColor(0x00, 0x72, 0xb2), QColor(0x00, 0x9e, 0x73),
                                                           QColor(0xcc, 0x79, 0xa7), QColor(0x56, 0xb4, 0xe9),
                                                           shade::incremental,       shade::proposal};
    return colours[series % maxSeries];
}

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
