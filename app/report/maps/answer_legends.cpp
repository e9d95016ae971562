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
    Legend legend = makeLegend(measure, choice, map.possibleMin, top, minutes);
    const bool areSeveral = !map.elements.empty() && !map.elements.front().withTrees.empty();
    if (map.column || areSeveral) nameTrees(legend, map.column.value_or(TreeColumns::without));
    return legend;
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
    if (spread.maximum > legend.scale.top)
        legend.notes.push_back(
            {QStringLiteral(NM_TEXT("largest %1")), QString::number(spread.maximum, 'f', 0)});
    addPatch(legend, impact, CellChange::becameBuilding, ground::becameBuilding,
             QStringLiteral(NM_TEXT("built over")));
    addPatch(legend, impact, CellChange::becameGround, ground::becameGround,
             QStringLiteral(NM_TEXT("building gone")));
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
    legend.scale = legendScale(std::max(found.percentile98, 0.01));
    legend.colours =
        makeSignedScale(choice, ColourScale::Of::wanted, {}, legend.scale, double(noScore), score.score);
    if (found.maximum > legend.scale.top)
        legend.notes.push_back(
            {QStringLiteral(NM_TEXT("largest %1")), QStringLiteral("±%1").arg(found.maximum, 0, 'g', 3)});
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

std::span<const HeightSourceColour, heightSources.size()> heightSourceColours() {
    static const std::array<HeightSourceColour, heightSources.size()> colours{{
        {HeightSource::measured, {0x00, 0x72, 0xb2}, NM_TEXT("measured")},
        {HeightSource::levels, {0xf0, 0xe4, 0x42}, NM_TEXT("from storeys")},
        {HeightSource::assumed, {0xd5, 0x5e, 0x00}, NM_TEXT("assumed")},
        {HeightSource::mesh, {0x56, 0xb4, 0xe9}, NM_TEXT("of a 3D model")},
        {HeightSource::designed, {0x4f, 0xc2, 0xa4}, NM_TEXT("designed")},
        {HeightSource::madeUp, {0x99, 0x99, 0x99}, NM_TEXT("made up")},
    }};
    return colours;
}

const HeightSourceColour& colourOf(HeightSource source) { return heightSourceColours()[std::size_t(source)]; }

HeightSource sourceOfHeight(const Building& building) {
    if (building.parts.empty()) return HeightSource::assumed;
    return std::ranges::max_element(building.parts, {}, &Part::topM)->heightSource;
}

SourceCounts countSources(const City& city) {
    SourceCounts counts{};
    for (const auto& building : city.buildings) ++counts[std::size_t(sourceOfHeight(*building))];
    return counts;
}

std::vector<LegendPatch> sourcePatches(const SourceCounts& counts) {
    std::vector<LegendPatch> patches;
    for (const HeightSourceColour& one : heightSourceColours())
        if (counts[std::size_t(one.source)] > 0)
            patches.push_back({one.colour, QString::fromUtf8(one.label.data(), qsizetype(one.label.size()))});
    return patches;
}

}  // namespace noonmark
