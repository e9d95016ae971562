#include "app/gui/base/layers/error_notes.h"

#include <QObject>

#include "app/gui/base/widgets/number_words.h"
#include "core/measures/has_runs.h"

namespace noonmark {

namespace {

QString describeRunError(double meanPct, double p99Pct, double largestPct) {
    return QObject::tr(
               "Measured error of the longest shadow against rays, of the longest day: %1 % in the "
               "mean, %2 % at the 99th percentile, %3 % at most")
        .arg(groupDigits(meanPct, 2), groupDigits(p99Pct, 2), groupDigits(largestPct, 2));
}

}  // namespace

QString describeError(const std::optional<SampledError>& error, ShadowMeasure measure) {
    if (!error) return {};
    const CellError &gross = error->gross, &runs = error->continuous;
    if (measure == ShadowMeasure::continuous && hasRuns(*error))
        return describeRunError(runs.percent(runs.meanMin), runs.percent(runs.p99Min),
                                runs.percent(runs.maxMin));
    return QObject::tr("Measured error against rays: %1 % of the area, %2 % of the minutes of a cell")
        .arg(groupDigits(error->areaPct, 2), groupDigits(gross.percent(gross.meanMin), 2));
}

QString describeCellError(const SampledError& error, double sunlitMin, ShownAs show) {
    const ShownQuantity quantity{show, sunlitMin};
    const std::string_view unit = quantity.shortUnit();
    return QObject::tr("A cell: %1 %3 in the mean, 99 of 100 within %2 %3")
        .arg(groupDigits(quantity.ofError(error.gross.meanMin), 3),
             groupDigits(quantity.ofError(error.gross.p99Min), 2),
             QString::fromUtf8(unit.data(), qsizetype(unit.size())));
}

QString describeError(const ElementStudy& study, ShadowMeasure measure) {
    if (!study.error) return {};
    const QuantityError& runs = study.error->continuous;
    if (measure == ShadowMeasure::continuous)
        return describeRunError(runs.meanPct, runs.p99Pct, runs.largestPct);
    return QObject::tr("Measured error against rays: %1 % of the time in the sun")
        .arg(groupDigits(study.error->gross.meanPct, 3));
}

}  // namespace noonmark
