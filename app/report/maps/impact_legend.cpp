#include "app/report/maps/impact_legend.h"

#include <QObject>
#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

void addPatch(Legend& legend, const Impact& impact, CellChange change, const QColor& colour,
              const QString& label) {
    const auto cells = std::ranges::count(impact.change, change);
    if (cells > 0) legend.patches.push_back({colour, label});
}

}  // namespace

bool isInstant(const Impact& impact) { return impact.sunlitMinutesPerDay <= 1; }

const std::vector<float>& getValues(const Impact& impact, ShadowMeasure measure) {
    return measure == ShadowMeasure::gross ? impact.grossMin : impact.continuousMin;
}

Legend makeLegend(const Impact& impact, ShadowMeasure measure, const ChangeScale& scale,
                  const LegendChoice& choice) {
    Legend legend{
        QStringLiteral("Change of %1").arg(nameOf(measure).toLower()), {}, {}, isInstant(impact), true};
    const ShownQuantity quantity =
        legend.instant ? ShownQuantity{} : quantityOf(measure, choice.show, impact.sunlitMinutesPerDay);
    if (quantity.isSun()) legend.title = QStringLiteral("Change of sun");
    const std::vector<float>& values = getValues(impact, measure);
    const ChangeSpread spread = changeSpreadOf(values, float(noChangeMin));
    legend.scale = legendScaleOf(scale, spread);
    legend.colours =
        makeSignedScale(choice, ColourScale::Of::change, quantity, legend.scale, noChangeMin, values);
    if (legend.instant) legend.colours->breaks.clear();
    legend.unit = measure == ShadowMeasure::gross ? QStringLiteral("min a day") : QStringLiteral("min");
    if (!legend.instant)
        legend.unit +=
            scale.lockedMin
                ? QStringLiteral(", scale locked: ±%1 min").arg(QString::fromStdString(formatText(scale)))
                : QStringLiteral(", scale fitted to this difference");
    if (spread.most > legend.scale.top)
        legend.unit += QStringLiteral(", largest %1").arg(spread.most, 0, 'f', 0);
    addPatch(legend, impact, CellChange::becameBuilding, ground::becameBuilding,
             QStringLiteral("built over"));
    addPatch(legend, impact, CellChange::becameGround, ground::becameGround, QStringLiteral("now ground"));
    return legend;
}

std::optional<QColor> pickColour(const Impact& impact, ShadowMeasure measure, std::size_t cell,
                                 const ColourScale& scale) {
    if (impact.change[cell] == CellChange::becameBuilding) return ground::becameBuilding;
    if (impact.change[cell] == CellChange::becameGround) return ground::becameGround;
    return pickColour(scale, double(getValues(impact, measure)[cell]));
}

}  // namespace noonmark
