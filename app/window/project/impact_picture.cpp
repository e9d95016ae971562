#include "app/window/project/impact_picture.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "app/window/change_scale.h"
#include "app/window/field_picture.h"
#include "app/window/hover_text.h"

namespace noonmark {

namespace {

using Pixel = GroundPicture::Pixel;
constexpr float noChangeMin = 1e-3F;  // float32 rounding

bool isInstant(const Impact& impact) { return impact.sunlitMinutesPerDay <= 1; }

void addPatch(Legend& legend, const Impact& impact, CellChange change, const QColor& colour,
              const QString& label) {
    const auto cells = std::ranges::count(impact.change, change);
    if (cells > 0) legend.patches.push_back({colour, label});
}

Pixel cellPixel(const Impact& impact, std::size_t cell, float value, double top) {
    if (impact.change[cell] == CellChange::becameBuilding) return pixelOf(ground::becameBuilding);
    if (impact.change[cell] == CellChange::becameGround) return pixelOf(ground::becameGround);
    return std::abs(value) > noChangeMin ? pixelOf(impactColour(double(value) / top)) : Pixel{};
}

QString signedMinutes(float minutes) {
    return QStringLiteral("%1%2")
        .arg(minutes > 0 ? QStringLiteral("+") : QString())
        .arg(double(minutes), 0, 'f', 1);
}

}  // namespace

const std::vector<float>& valuesOf(const Impact& impact, ShadowMeasure measure) {
    return measure == ShadowMeasure::gross ? impact.grossMin : impact.continuousMin;
}

Legend legendOf(const Impact& impact, ShadowMeasure measure) {
    Legend legend{
        QObject::tr("Change of %1").arg(nameOf(measure).toLower()), {}, {}, isInstant(impact), true};
    const ChangeScale found = changeScaleOf(valuesOf(impact, measure), noChangeMin);
    legend.scale = legendScale(std::max(found.usual, 1.0));
    legend.unit = measure == ShadowMeasure::gross ? QObject::tr("min a day") : QObject::tr("min");
    if (found.most > legend.scale.top) legend.unit += QObject::tr(", most %1").arg(found.most, 0, 'f', 0);
    addPatch(legend, impact, CellChange::becameBuilding, ground::becameBuilding, QObject::tr("built over"));
    addPatch(legend, impact, CellChange::becameGround, ground::becameGround, QObject::tr("now ground"));
    return legend;
}

GroundPicture impactPicture(const Impact& impact, ShadowMeasure measure, double top) {
    const std::vector<float>& values = valuesOf(impact, measure);
    GroundPicture picture;
    picture.grid = impact.grid;
    picture.pixels.reserve(values.size());
    for (std::size_t cell = 0; cell < values.size(); ++cell)
        picture.pixels.push_back(cellPixel(impact, cell, values[cell], top));
    return picture;
}

QString changeText(const Impact& impact, glm::dvec2 point) {
    const auto cell = cellAt(impact.grid, point);
    if (!cell) return {};
    if (impact.change[*cell] == CellChange::becameBuilding)
        return QObject::tr("ground before, built over now");
    if (impact.change[*cell] == CellChange::becameGround) return QObject::tr("built over before, ground now");
    const float gross = impact.grossMin[*cell], continuous = impact.continuousMin[*cell];
    if (std::isnan(gross)) return QObject::tr("not measured here");
    if (isInstant(impact))
        return gross > 0   ? QObject::tr("now in shadow")
               : gross < 0 ? QObject::tr("now in the sun")
                           : QObject::tr("no change");
    const QString text = QObject::tr("change: gross %1 min a day").arg(signedMinutes(gross));
    if (std::isnan(continuous)) return text;
    return text + QObject::tr(", continuous %1 min").arg(signedMinutes(continuous));
}

}  // namespace noonmark
