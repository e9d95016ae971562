#include "app/window/results/comparison_rows.h"

#include <QObject>

#include "app/report/sheets/study_words.h"
#include "app/window/study/region_words.h"
#include "scenarios/impact/impact_runs.h"

namespace noonmark {

namespace {

QString tr(const char* text) { return QObject::tr(text); }

QString describeSigned(double value, int decimals, const QString& unit) {
    return (value > 0 ? QStringLiteral("+") : QString()) + describeAmount(value, decimals) + unit;
}

// Rows of one measure, one per threshold.
void addThresholds(std::vector<ResultRow>& rows, const ComparisonFigures& figures, const QString& name,
                   ChangeFigures ImpactFigures::*measure, const QString& meaning) {
    for (const ImpactFigures& one : figures.all)
        rows.push_back(
            {tr("%1 > %2 min").arg(name).arg(one.thresholdMin), describeChangedArea(one.*measure), meaning});
}

void addBuildings(std::vector<ResultRow>& rows, const ComparisonFigures& figures) {
    for (const auto& building : figures.byBuilding)
        rows.push_back({QString::fromStdString(building.name), describeChangedArea(building.figures.gross),
                        tr("Contribution of this new building alone: ground with over %1 min a day more "
                           "gross shadow than without it")
                            .arg(building.figures.thresholdMin)});
}

}  // namespace

QString describeChangedArea(const ChangeFigures& figures) {
    if (figures.gainedM2 == 0 && figures.lostM2 == 0) return tr("no change");
    QStringList words;
    if (figures.gainedM2 > 0) words << tr("%1 more").arg(describeArea(figures.gainedM2));
    if (figures.lostM2 > 0) words << tr("%1 less").arg(describeArea(figures.lostM2));
    return words.join(QLatin1Char('\n'));
}

std::vector<ResultRow> makeComparisonRows(const ComparisonFigures& figures) {
    const ImpactFigures& all = figures.all.front();
    std::vector<ResultRow> rows{
        {tr("Compared"),
         tr("%1\nwith %2").arg(QString::fromStdString(figures.to), QString::fromStdString(figures.from)),
         tr("Minutes of the first minus minutes of the second, with the same engine, steps and cells")}};
    addThresholds(rows, figures, tr("Gross"), &ImpactFigures::gross,
                  tr("Ground whose gross shadow increases or decreases by more than this"));
    if (hasRuns(all))
        addThresholds(rows, figures, tr("Continuous"), &ImpactFigures::continuous,
                      tr("Ground whose continuous shadow increases or decreases by more than this"));
    else
        rows.push_back({tr("Continuous"), tr("not counted"), tr("The engine computed gross shadow only")});
    rows.push_back(
        {tr("Any change"),
         tr("%1 more\n%2 less").arg(describeArea(all.gross.touchedM2), describeArea(all.gross.easedM2)),
         tr("Ground with any change of gross shadow")});
    rows.push_back({tr("Largest increase"), describeSigned(all.gross.mostGainedMin, 1, tr(" min a day")),
                    tr("The cell with the largest increase of gross shadow")});
    rows.push_back({tr("Largest decrease"), describeSigned(-all.gross.mostLostMin, 1, tr(" min a day")),
                    tr("The cell with the largest decrease of gross shadow")});
    rows.push_back({tr("Mean change"), describeSigned(all.gross.meanMin, 2, tr(" min a day")),
                    tr("Mean change of gross shadow over all cells that are open ground in both")});
    rows.push_back(
        {tr("Shadow area"), describeSigned(all.shadowAreaChangeM2, 0, QStringLiteral(" m²")),
         tr("Change of the sum over the cells of (share of the sunlit time in shadow × cell area)")});
    rows.push_back({tr("Built over"), describeArea(all.becameBuildingM2),
                    tr("Formerly ground, now building; not included above")});
    rows.push_back({tr("Became ground"), describeArea(all.becameGroundM2),
                    tr("Formerly building, now ground; not included above")});
    addBuildings(rows, figures);
    rows.push_back({tr("Ground compared"), describeArea(all.receiverAreaM2), tr("Open ground in both")});
    rows.push_back({tr("Period"), QString::fromStdString(figures.period), {}});
    rows.push_back({tr("Engine"), QString::fromStdString(figures.engine), tr("Used for both")});
    return rows;
}

}  // namespace noonmark
