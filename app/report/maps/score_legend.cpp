#include "app/report/maps/score_legend.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "app/report/maps/change_scale.h"

namespace noonmark {

namespace {

constexpr float noScore = 1e-6F;

}  // namespace

Legend makeLegend(const Score& score) {
    Legend legend{
        QStringLiteral("Shadow score"), QStringLiteral("weight × share of time"), {}, false, true, {}};
    legend.wanted = true;
    legend.isScore = true;
    const ChangeSpread found = changeSpreadOf(score.score, noScore);
    legend.scale = legendScale(std::max(found.usual, 0.01));
    if (found.most > legend.scale.top)
        legend.unit += QStringLiteral(", largest ±%1").arg(found.most, 0, 'g', 3);
    return legend;
}

std::optional<QColor> pickColour(const Score& score, std::size_t cell, double top) {
    const float value = score.score[cell];
    if (std::isnan(value)) return std::nullopt;
    return impactColour(-double(value) / top);
}

}  // namespace noonmark
