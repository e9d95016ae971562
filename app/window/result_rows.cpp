#include "app/window/result_rows.h"

#include <QObject>

#include "app/report/shadow_measure.h"
#include "app/report/study_words.h"
#include "core/study/error_words.h"

namespace noonmark {

namespace {

QString tr(const char* text) { return QObject::tr(text); }

double accumulateSeconds(const Study& study) {
    const auto found = study.seconds.find("accumulate");
    return found == study.seconds.end() ? 0 : found->second;
}

ResultRow minutes(const QString& name, double value, const QString& meaning) {
    return {name, amountWords(value) + QStringLiteral(" min"), meaning};
}

std::vector<ResultRow> shadowRows(const Study& study) {
    const ShadowStatistics& s = study.statistics;
    const double share = s.receiverAreaM2 > 0 ? 100 * s.shadowAreaM2 / s.receiverAreaM2 : 0;
    std::vector<ResultRow> rows{
        {tr("Shadow area"), amountWords(s.shadowAreaM2, 0) + QStringLiteral(" m²"),
         tr("Sum over the receivers of (share of the sunlit time in shadow × cell area)")},
        {tr("of the ground"), amountWords(share) + QStringLiteral(" %"),
         tr("Shadow area over the area of all receivers")}};
    if (isInstant(study.field)) return rows;
    rows.push_back(minutes(tr("Mean gross"), s.meanGrossMin,
                           tr("Minutes in shadow a day, mean over days and receivers")));
    rows.push_back(minutes(tr("Mean continuous"), s.meanContinuousMin,
                           tr("Longest unbroken run in shadow on any day, mean over the receivers")));
    rows.push_back(minutes(tr("Max continuous"), s.maxContinuousMin,
                           tr("Longest unbroken run in shadow of any receiver on any day")));
    return rows;
}

void addErrorRows(std::vector<ResultRow>& rows, const Study& study) {
    for (const ErrorLine& line : errorLines(study))
        rows.push_back({QString::fromStdString(line.name).replace(0, 1, QChar(line.name[0]).toUpper()),
                        QString::fromStdString(line.value),
                        tr("Against the ray reference, on a sample of the receivers over the same steps")});
}

ResultRow speedRow(const Study& study) {
    const double seconds = accumulateSeconds(study);
    const double megaRays = seconds > 0 ? double(study.field.cost.rays) / seconds * 1e-6 : 0;
    return {
        tr("Speed"), amountWords(megaRays) + tr(" M rays/s"),
        tr("%1 occlusion rays over the seconds that the engine took").arg(countWords(study.field.cost.rays))};
}

}  // namespace

std::vector<ResultRow> resultRowsOf(const Study& study) {
    std::vector<ResultRow> rows = shadowRows(study);
    rows.push_back(
        {tr("Receivers"), countWords(study.statistics.receivers), tr("Cells of open ground in the region")});
    rows.push_back({tr("Steps of the sun"), countWords(study.sun.steps.size()),
                    tr("Positions of the sun above the horizon; %1 below it were left out")
                        .arg(countWords(study.sun.belowHorizon))});
    rows.push_back({tr("Sunlit time"), amountWords(study.field.sunlitMinutesPerDay) + tr(" min/day"),
                    tr("Mean minutes a day with the sun above the horizon: 100 % of the time")});
    if (study.field.cost.rays > 0) rows.push_back(speedRow(study));
    rows.push_back({tr("Time"), amountWords(accumulateSeconds(study), 2) + QStringLiteral(" s"),
                    tr("Seconds that the engine took")});
    rows.push_back({tr("Period"), QString::fromStdString(textOf(study.settings.period)), {}});
    addErrorRows(rows, study);
    rows.push_back({tr("Engine"), QString::fromStdString(study.field.engine), {}});
    return rows;
}

}  // namespace noonmark
