#include <QObject>

#include "app/gui/base/widgets/number_words.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/answers/result_rows.h"

namespace noonmark {

namespace {

void addBuildings(std::vector<ResultRow>& rows, const ComparisonFigures& figures, ShownAs show) {
    const QString meaning = show == ShownAs::shadow
                                ? QObject::tr(
                                      "Contribution of this new building alone: ground with over %1 "
                                      "min a day more gross shadow than without it")
                                : QObject::tr(
                                      "Contribution of this new building alone: ground that loses "
                                      "over %1 min of sun a day by it");
    for (const auto& building : figures.byBuilding)
        rows.push_back({QString::fromStdString(building.name),
                        describeChangedArea(building.figures.gross, show),
                        meaning.arg(building.figures.thresholdMin)});
}

std::optional<AnswerLayer> layerOfComparison(const std::shared_ptr<const Answer>& answer) {
    return makeGroundAnswer(contentOf<ImpactAnswer>(answer));
}

std::vector<ResultRow> rowsOfComparison(const Answer& answer, ShownAs show) {
    return makeRows(computeFigures(*answer.as<ImpactAnswer>()), show);
}

std::optional<AnswerLayer> layerOfSavedImpact(const std::shared_ptr<const SavedContent>& saved) {
    return markMissingRuns({.map = std::shared_ptr<const Impact>(saved, &saved->as<SavedImpact>()->impact)});
}

std::vector<ResultRow> rowsOfSavedImpact(const SavedContent& saved, ShownAs show) {
    return makeRows(saved.as<SavedImpact>()->figures, show);
}

QString titleOfComparison(const Answer& answer) {
    const MeasuredPart part = answer.part();
    return QObject::tr("%1 compared with %2")
        .arg(QString::fromStdString(part.scenario), QString::fromStdString(part.baseline));
}

}  // namespace

const AnswerViewer& comparisonViewer() {
    static const AnswerViewer viewer{.question = comparisonQuestion().key,
                                     .layer = layerOfComparison,
                                     .rows = rowsOfComparison,
                                     .title = titleOfComparison,
                                     .savedLayer = layerOfSavedImpact,
                                     .savedRows = rowsOfSavedImpact};
    return viewer;
}

QString describeChangedArea(const ChangeFigures& figures, ShownAs show) {
    if (figures.gainedM2 == 0 && figures.lostM2 == 0) return QObject::tr("no change");
    QStringList words;
    const double moreM2 = show == ShownAs::shadow ? figures.gainedM2 : figures.lostM2;
    const double lessM2 = show == ShownAs::shadow ? figures.lostM2 : figures.gainedM2;
    if (moreM2 > 0) words << QObject::tr("%1 more").arg(describeArea(moreM2));
    if (lessM2 > 0) words << QObject::tr("%1 less").arg(describeArea(lessM2));
    return words.join(QLatin1Char('\n'));
}

std::vector<ResultRow> makeRows(const ComparisonFigures& figures, ShownAs show) {
    std::vector<ResultRow> rows{
        {QObject::tr("Compared"),
         QObject::tr("%1\nwith %2")
             .arg(QString::fromStdString(figures.to), QString::fromStdString(figures.from)),
         QObject::tr(
             "Minutes of the first minus minutes of the second, with the same engine, steps and cells")}};
    for (ResultRow& row : figureRows(listLines(figures, show))) rows.push_back(std::move(row));
    addBuildings(rows, figures, show);
    rows.push_back(methodRow(QObject::tr("Period"), QString::fromStdString(figures.period)));
    rows.push_back(methodRow(QObject::tr("Engine"), QString::fromStdString(figures.engine),
                             QObject::tr("Used for both")));
    addErrors(rows, figures.errors);
    return rows;
}

}  // namespace noonmark
