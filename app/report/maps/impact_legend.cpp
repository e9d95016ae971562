#include "app/report/maps/impact_legend.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "core/describe/text.h"

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
    const bool isGross = measure == ShadowMeasure::gross;
    Legend legend{isGross ? QStringLiteral(NM_TEXT("Change of gross shadow"))
                          : QStringLiteral(NM_TEXT("Change of continuous shadow")),
                  isGross ? QStringLiteral(NM_TEXT("min a day")) : QStringLiteral(NM_TEXT("min")),
                  {},
                  isInstant(impact),
                  true};
    const ShownQuantity quantity =
        legend.instant ? ShownQuantity{} : quantityOf(measure, choice.show, impact.sunlitMinutesPerDay);
    if (quantity.isSun()) legend.title = QStringLiteral(NM_TEXT("Change of sun"));
    const std::vector<float>& values = getValues(impact, measure);
    const ChangeSpread spread = changeSpreadOf(values, float(noChangeMin));
    legend.scale = legendScaleOf(scale, spread);
    legend.colours =
        makeSignedScale(choice, ColourScale::Of::change, quantity, legend.scale, noChangeMin, values);
    if (legend.instant) legend.colours->breaks.clear();
    if (!legend.instant && scale.lockedMin)
        legend.notes.push_back({QStringLiteral(NM_TEXT("scale locked: %1")),
                                QStringLiteral("±%1 min").arg(QString::fromStdString(formatText(scale)))});
    else if (!legend.instant)
        legend.notes.push_back({QStringLiteral(NM_TEXT("scale fitted to this difference"))});
    if (spread.most > legend.scale.top)
        legend.notes.push_back({QStringLiteral(NM_TEXT("largest %1")), QString::number(spread.most, 'f', 0)});
    addPatch(legend, impact, CellChange::becameBuilding, ground::becameBuilding,
             QStringLiteral(NM_TEXT("built over")));
    addPatch(legend, impact, CellChange::becameGround, ground::becameGround,
             QStringLiteral(NM_TEXT("now ground")));
    return legend;
}

std::optional<QColor> pickColour(const Impact& impact, ShadowMeasure measure, std::size_t cell,
                                 const ColourScale& scale) {
    if (impact.change[cell] == CellChange::becameBuilding) return ground::becameBuilding;
    if (impact.change[cell] == CellChange::becameGround) return ground::becameGround;
    return pickColour(scale, double(getValues(impact, measure)[cell]));
}

}  // namespace noonmark
