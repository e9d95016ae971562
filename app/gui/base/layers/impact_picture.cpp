#include "app/gui/base/layers/impact_picture.h"

#include <QObject>
#include <cmath>

#include "app/gui/base/layers/field_picture.h"
#include "app/gui/base/layers/hover_text.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/report/maps/impact_legend.h"

namespace noonmark {

namespace {

QString signedMinutes(float minutes) {
    return QStringLiteral("%1%2")
        .arg(minutes > 0 ? QStringLiteral("+") : QString())
        .arg(groupDigits(double(minutes), 1));
}

}  // namespace

GroundPicture impactPicture(const Impact& impact, ShadowMeasure measure, const ColourScale& scale) {
    GroundPicture picture;
    picture.grid = impact.grid;
    picture.pixels.reserve(impact.change.size());
    for (std::size_t cell = 0; cell < impact.change.size(); ++cell) {
        const auto colour = pickColour(impact, measure, cell, scale);
        picture.pixels.push_back(colour ? pixelOf(*colour) : GroundPicture::Pixel{});
    }
    return picture;
}

QString formatChange(const Impact& impact, glm::dvec2 point, ShownAs show) {
    const auto cell = cellAt(impact.grid, point);
    if (!cell) return {};
    if (impact.change[*cell] == CellChange::becameBuilding)
        return QObject::tr("formerly ground, now built over");
    if (impact.change[*cell] == CellChange::becameGround) return QObject::tr("formerly building, now ground");
    const float gross = impact.grossMin[*cell], continuous = impact.continuousMin[*cell];
    if (std::isnan(gross)) return QObject::tr("not measured");
    if (isInstant(impact))
        return gross > 0   ? QObject::tr("now in shadow")
               : gross < 0 ? QObject::tr("now in the sun")
                           : QObject::tr("no change");
    const ShownQuantity quantity{show, impact.sunlitMinutesPerDay};
    const QString words = quantity.isSun() ? QObject::tr("change: sun %1 min a day")
                                           : QObject::tr("change: gross %1 min a day");
    const QString text = words.arg(signedMinutes(float(quantity.ofChange(double(gross)))));
    if (std::isnan(continuous)) return text;
    if (quantity.isSun())
        return text + QObject::tr(", continuous shadow %1 min").arg(signedMinutes(continuous));
    return text + QObject::tr(", continuous %1 min").arg(signedMinutes(continuous));
}

}  // namespace noonmark
