#include <QObject>

#include "app/gui/base/widgets/number_words.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/report/sheets/study_words.h"
#include "scenarios/impact/impact_runs.h"

namespace noonmark {

namespace {

QString describeSigned(double value, int decimals, const QString& unit) {
    return (value > 0 ? QStringLiteral("+") : QString()) + formatAmount(value, decimals) + unit;
}

QString describeSignedArea(double areaM2) {
    return (areaM2 > 0 ? QStringLiteral("+") : QString()) + describeSmallArea(areaM2);
}

// Rows of one measure, one per threshold.
void addThresholds(std::vector<ResultRow>& rows, const ComparisonFigures& figures, const QString& name,
                   ChangeFigures ImpactFigures::*measure, const QString& meaning) {
    for (const ImpactFigures& one : figures.all)
        rows.push_back({QObject::tr("%1 > %2 min").arg(name).arg(one.thresholdMin),
                        describeChangedArea(one.*measure), meaning});
}

void addBuildings(std::vector<ResultRow>& rows, const ComparisonFigures& figures) {
    for (const auto& building : figures.byBuilding)
        rows.push_back(
            {QString::fromStdString(building.name), describeChangedArea(building.figures.gross),
             QObject::tr("Contribution of this new building alone: ground with over %1 min a day more "
                         "gross shadow than without it")
                 .arg(building.figures.thresholdMin)});
}

AnswerLayer layerOfComparison(const std::shared_ptr<const Answer>& answer) {
    return makeGroundAnswer(contentOf<ImpactAnswer>(answer));
}

std::vector<ResultRow> rowsOfComparison(const Answer& answer) {
    return makeRows(computeFigures(*answer.as<ImpactAnswer>()));
}

QString titleOfComparison(const Answer& answer) {
    const MeasuredPart part = answer.part();
    return QObject::tr("%1 compared with %2")
        .arg(QString::fromStdString(part.scenario), QString::fromStdString(part.baseline));
}

}  // namespace

const AnswerViewer& comparisonViewer() {
    static const AnswerViewer viewer{comparisonQuestion().key, layerOfComparison, rowsOfComparison,
                                     titleOfComparison};
    return viewer;
}

QString describeChangedArea(const ChangeFigures& figures) {
    if (figures.gainedM2 == 0 && figures.lostM2 == 0) return QObject::tr("no change");
    QStringList words;
    if (figures.gainedM2 > 0) words << QObject::tr("%1 more").arg(describeArea(figures.gainedM2));
    if (figures.lostM2 > 0) words << QObject::tr("%1 less").arg(describeArea(figures.lostM2));
    return words.join(QLatin1Char('\n'));
}

std::vector<ResultRow> makeRows(const ComparisonFigures& figures) {
    const ImpactFigures& all = figures.all.front();
    std::vector<ResultRow> rows{
        {QObject::tr("Compared"),
         QObject::tr("%1\nwith %2")
             .arg(QString::fromStdString(figures.to), QString::fromStdString(figures.from)),
         QObject::tr(
             "Minutes of the first minus minutes of the second, with the same engine, steps and cells")}};
    addThresholds(rows, figures, QObject::tr("Gross"), &ImpactFigures::gross,
                  QObject::tr("Ground whose gross shadow increases or decreases by more than this"));
    if (hasRuns(all))
        addThresholds(rows, figures, QObject::tr("Continuous"), &ImpactFigures::continuous,
                      QObject::tr("Ground whose continuous shadow increases or decreases by more than this"));
    else
        rows.push_back({QObject::tr("Continuous"), QObject::tr("not counted"),
                        QObject::tr("The engine computed gross shadow only")});
    rows.push_back({QObject::tr("Any change"),
                    QObject::tr("%1 more\n%2 less")
                        .arg(describeArea(all.gross.touchedM2), describeArea(all.gross.easedM2)),
                    QObject::tr("Ground with any change of gross shadow")});
    rows.push_back({QObject::tr("Largest increase"),
                    describeSigned(all.gross.mostGainedMin, 1, QObject::tr(" min a day")),
                    QObject::tr("The cell with the largest increase of gross shadow")});
    rows.push_back({QObject::tr("Largest decrease"),
                    describeSigned(-all.gross.mostLostMin, 1, QObject::tr(" min a day")),
                    QObject::tr("The cell with the largest decrease of gross shadow")});
    rows.push_back({QObject::tr("Mean change"),
                    describeSigned(all.gross.meanMin, 2, QObject::tr(" min a day")),
                    QObject::tr("Mean change of gross shadow over all cells that are open ground in both")});
    rows.push_back(
        {QObject::tr("Shadow area"), describeSignedArea(all.shadowAreaChangeM2),
         QObject::tr(
             "Change of the sum over the cells of (share of the sunlit time in shadow × cell area)")});
    rows.push_back({QObject::tr("Built over"), describeArea(all.becameBuildingM2),
                    QObject::tr("Formerly ground, now building; not included above")});
    rows.push_back({QObject::tr("Became ground"), describeArea(all.becameGroundM2),
                    QObject::tr("Formerly building, now ground; not included above")});
    addBuildings(rows, figures);
    rows.push_back({QObject::tr("Ground compared"), describeArea(all.receiverAreaM2),
                    QObject::tr("Open ground in both")});
    addWaterRow(rows, figures.waterM2);
    rows.push_back({QObject::tr("Period"), QString::fromStdString(figures.period), {}});
    rows.push_back(
        {QObject::tr("Engine"), QString::fromStdString(figures.engine), QObject::tr("Used for both")});
    return rows;
}

}  // namespace noonmark
