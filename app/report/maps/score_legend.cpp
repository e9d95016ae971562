#include "app/report/maps/score_legend.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "app/report/maps/change_scale.h"
#include "core/describe/text.h"

namespace noonmark {

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

}  // namespace noonmark
