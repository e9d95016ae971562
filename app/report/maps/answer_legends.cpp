#include "app/report/maps/answer_legends.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "core/describe/text.h"

namespace noonmark {

namespace {

double minutesOf(const MeasuredElement& element, ShadowMeasure measure) {
    return measure == ShadowMeasure::gross ? element.grossMin : element.continuousMin;
}

}  // namespace

Legend makeLegend(const ElementMap& map, ShadowMeasure measure, const LegendChoice& choice) {
    double top = map.possibleMin;
    std::vector<float> minutes;
    for (const MeasuredElement& element : map.elements) {
        minutes.push_back(float(minutesOf(element, measure)));
        top = std::max(top, minutesOf(element, measure));
    }
    return makeLegend(measure, choice, map.possibleMin, top, minutes);
}

Legend makeSunLegend(const ElementMap& map, const LegendChoice& choice) {
    const bool isSun = choice.show != ShownAs::shadow;
    return makeLegend(map, ShadowMeasure::gross,
                      isSun ? choice : showAs(choice, ShownAs::sun, map.possibleMin));
}

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

namespace {

constexpr float noScore = 1e-6F;

}  // namespace

Legend makeLegend(const Score& score, const LegendChoice& choice) {
    Legend legend{QStringLiteral(NM_TEXT("Shadow score")),
                  QStringLiteral(NM_TEXT("weight × share of time")),
                  {},
                  false,
                  true,
                  {}};
    const ChangeSpread found = changeSpreadOf(score.score, noScore);
    legend.scale = legendScale(std::max(found.usual, 0.01));
    legend.colours =
        makeSignedScale(choice, ColourScale::Of::wanted, {}, legend.scale, double(noScore), score.score);
    if (found.most > legend.scale.top)
        legend.notes.push_back(
            {QStringLiteral(NM_TEXT("largest %1")), QStringLiteral("±%1").arg(found.most, 0, 'g', 3)});
    return legend;
}

QColor verdictMark(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return {0x2b, 0x83, 0xba};
        case Verdict::borderline:
            return {0xf7, 0xdc, 0x3c};
        case Verdict::fail:
            return {0xa8, 0x2a, 0x0a};
        case Verdict::notApplicable:
        case Verdict::notChecked:
            break;
    }
    return {0xd5, 0xd7, 0xda};
}

}  // namespace noonmark
