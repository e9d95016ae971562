#include <QLocale>
#include <QObject>

#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/report/sheets/study_text.h"
#include "core/describe/text.h"
#include "scenarios/weights/score_text.h"

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
        rows.push_back({QObject::tr("%1 against its empty lot").arg(QString::fromStdString(building.name)),
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

Sentence titleOfComparison(const MeasuredPart& part) {
    return {NM_TEXT("%1 compared with %2"), {part.scenario, part.baseline}};
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
    if (figures.moreShadowM2 == 0 && figures.lessShadowM2 == 0) return QObject::tr("no change");
    QStringList words;
    const double moreM2 = show == ShownAs::shadow ? figures.moreShadowM2 : figures.lessShadowM2;
    const double lessM2 = show == ShownAs::shadow ? figures.lessShadowM2 : figures.moreShadowM2;
    if (moreM2 > 0) words << QObject::tr("%1 more").arg(describeArea(moreM2));
    if (lessM2 > 0) words << QObject::tr("%1 less").arg(describeArea(lessM2));
    return words.join(QLatin1Char('\n'));
}

std::vector<ResultRow> makeRows(const ComparisonFigures& figures, ShownAs show) {
    std::vector<ResultRow> rows{
        {QObject::tr("Compared"),
         QObject::tr("%1\nwith %2").arg(scenarioName(figures.to), scenarioName(figures.from)),
         QObject::tr(
             "Minutes of the first minus minutes of the second, with the same engine, steps and cells")}};
    for (ResultRow& row : figureRows(listLines(figures, show))) rows.push_back(std::move(row));
    addBuildings(rows, figures, show);
    rows.push_back(methodRow(QObject::tr("Period"), periodText(figures.period)));
    rows.push_back(methodRow(QObject::tr("Engine"), QString::fromStdString(figures.engine),
                             QObject::tr("Used for both")));
    addErrors(rows, figures.errors);
    return rows;
}

namespace {

// Of a month or an interval.
template <class R>
QString joined(const Figures<R>& figures, const R& of, ShownAs show) {
    return joinFigures(listLines(figures.of(of), FigureUse::result, {.show = show}));
}

void addMonths(std::vector<ResultRow>& rows, const Score& score, ShownAs show) {
    for (const MonthFigures& month : score.months)
        rows.push_back({describeMonth(month.month), joined(scoreMonthFigures(), month, show),
                        QObject::tr("The month's contribution to the score")});
}

// Intervals without steps of the sun have neither shadow area nor score.
void addIntervals(std::vector<ResultRow>& rows, const Score& score, ShownAs show) {
    for (const IntervalFigures& interval : score.intervals)
        if (interval.shadowAreaM2 > 0)
            rows.push_back(
                {weightName(interval.name), joined(scoreIntervalFigures(), interval, show),
                 QObject::tr("Interval of the table: its weight, and its contribution to the score")});
}

std::optional<AnswerLayer> layerOfScore(const std::shared_ptr<const Answer>& answer) {
    return makeGroundAnswer(contentOf<ScoreAnswer>(answer));
}

std::vector<ResultRow> rowsOfScore(const Answer& answer, ShownAs show) {
    const auto& score = *answer.as<ScoreAnswer>();
    return makeScoreRows(score.score, score.scenario, score.weights.name, statePeriod(score.settings.period),
                         show);
}

std::optional<AnswerLayer> layerOfSavedScore(const std::shared_ptr<const SavedContent>& saved) {
    return markMissingRuns({.map = std::shared_ptr<const Score>(saved, &saved->as<SavedScore>()->score)});
}

std::vector<ResultRow> rowsOfSavedScore(const SavedContent& saved, ShownAs show) {
    const auto& score = *saved.as<SavedScore>();
    return makeScoreRows(score.score, saved.result->scenario, score.weights, saved.answer.origin.period,
                         show);
}

Sentence titleOfScore(const MeasuredPart& part) {
    const std::string weights = part.weights ? part.weights->name : std::string();
    return {NM_TEXT("Score of %1 with %2"), {part.scenario, weights}};
}

}  // namespace

const AnswerViewer& scoreViewer() {
    static const AnswerViewer viewer{.question = scoreQuestion().key,
                                     .layer = layerOfScore,
                                     .rows = rowsOfScore,
                                     .title = titleOfScore,
                                     .savedLayer = layerOfSavedScore,
                                     .savedRows = rowsOfSavedScore};
    return viewer;
}

QString describeMonth(std::chrono::year_month month) {
    const QString name = QLocale().standaloneMonthName(int(unsigned(month.month())), QLocale::ShortFormat);
    return QStringLiteral("%1 %2").arg(name).arg(int(month.year()));
}

std::vector<ResultRow> makeScoreRows(const Score& score, const std::string& scenario,
                                     const std::string& weights, const StatedPeriod& period, ShownAs show) {
    std::vector<ResultRow> rows = figureRows(listScoreLines(score));
    rows.push_back({QObject::tr("Scored"),
                    QObject::tr("%1\nwith the weights %2").arg(scenarioName(scenario), weightName(weights)),
                    {}});
    addMonths(rows, score, show);
    addIntervals(rows, score, show);
    rows.push_back(methodRow(QObject::tr("Period"), periodText(period)));
    rows.push_back(methodRow(QObject::tr("Engine"), QString::fromStdString(score.engine)));
    addErrors(rows, score.errors);
    return rows;
}

}  // namespace noonmark
