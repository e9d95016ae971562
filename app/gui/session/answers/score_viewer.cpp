#include <QLocale>
#include <QObject>
#include <algorithm>
#include <cmath>

#include "app/gui/base/widgets/number_words.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/report/sheets/study_words.h"
#include "scenarios/weights/score_figures.h"

namespace noonmark {

namespace {

QString signedArea(double areaM2) {
    return (areaM2 > 0 ? QStringLiteral("+") : QString()) + formatAmount(areaM2, 0) + QStringLiteral(" m²");
}

QString signedShade(double shadeM2h) {
    if (std::isnan(shadeM2h)) return QObject::tr("not counted");
    return (shadeM2h > 0 ? QStringLiteral("+") : QString()) + formatAmount(shadeM2h, 0) +
           QStringLiteral(" m² h");
}

// Of a month or an interval.
template <class Figures>
QString listFigures(const Figures& figures) {
    return QObject::tr("%1 weighted, %2 m² shadow, score %3")
        .arg(signedShade(figures.weightedShadeM2h), formatAmount(figures.shadowAreaM2, 0),
             signedArea(figures.scoreM2));
}

void addMonths(std::vector<ResultRow>& rows, const Score& score) {
    for (const MonthFigures& month : score.months)
        rows.push_back({describeMonth(month.month), listFigures(month),
                        QObject::tr("Weighted shade, shadow area over %1 sunlit minute(s), and the month's "
                                    "contribution to the score",
                                    "", pluralNumber(quint64(std::round(month.sunlitMinutes))))
                            .arg(formatAmount(month.sunlitMinutes, 0))});
}

// Intervals without steps of the sun have neither shadow area nor score.
void addIntervals(std::vector<ResultRow>& rows, const Score& score) {
    for (const IntervalFigures& interval : score.intervals)
        if (interval.shadowAreaM2 > 0)
            rows.push_back(
                {QObject::tr("%1 × %2").arg(QString::fromStdString(interval.name)).arg(interval.weight),
                 listFigures(interval),
                 QObject::tr(
                     "Interval of the table and its weight: weighted shade, shadow area in its sunlit time, "
                     "and weight times shadow area")});
}

AnswerLayer layerOfScore(const std::shared_ptr<const Answer>& answer) {
    return makeGroundAnswer(contentOf<ScoreAnswer>(answer));
}

std::vector<ResultRow> rowsOfScore(const Answer& answer) {
    const auto& score = *answer.as<ScoreAnswer>();
    return makeScoreRows(score.score, score.scenario, score.weights.name, formatText(score.settings.period));
}

QString titleOfScore(const Answer& answer) {
    const auto& score = *answer.as<ScoreAnswer>();
    return QObject::tr("Score of %1 with %2")
        .arg(QString::fromStdString(score.scenario), QString::fromStdString(score.weights.name));
}

std::vector<MonthFigures> monthsOfScore(const Answer& answer) {
    return answer.as<ScoreAnswer>()->score.months;
}

}  // namespace

const AnswerViewer& scoreViewer() {
    static const AnswerViewer viewer{scoreQuestion().key, layerOfScore, rowsOfScore,
                                     titleOfScore,        nullptr,      monthsOfScore};
    return viewer;
}

QString describeMonth(std::chrono::year_month month) {
    const QString name = QLocale().standaloneMonthName(int(unsigned(month.month())), QLocale::ShortFormat);
    return QStringLiteral("%1 %2").arg(name).arg(int(month.year()));
}

std::vector<ResultRow> makeScoreRows(const Score& score, const std::string& scenario,
                                     const std::string& weights, const std::string& period) {
    const double perArea = score.scoreM2 / std::max(1.0, score.receiverAreaM2);
    std::vector<ResultRow> rows{
        figureRow(scoreFigures().rows(), "weighted_shade_m2h", signedShade(score.weightedShadeM2h)),
        figureRow(scoreFigures().rows(), "score_m2", signedArea(score.scoreM2)),
        {QObject::tr("per m² of ground"), groupDigits(perArea, 3),
         QObject::tr("Score divided by the area of all receivers")},
        {QObject::tr("Scored"),
         QObject::tr("%1\nwith the weights %2")
             .arg(QString::fromStdString(scenario), QString::fromStdString(weights)),
         {}}};
    addMonths(rows, score);
    addIntervals(rows, score);
    rows.push_back({QObject::tr("Receivers"), formatAmount(score.receiverAreaM2, 0) + QStringLiteral(" m²"),
                    QObject::tr("Open ground of the region")});
    addWaterRow(rows, score.waterM2);
    rows.push_back({QObject::tr("Period"), QString::fromStdString(period), {}});
    rows.push_back({QObject::tr("Engine"), QString::fromStdString(score.engine), {}});
    return rows;
}

}  // namespace noonmark
