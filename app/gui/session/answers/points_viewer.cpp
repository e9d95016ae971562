#include <QObject>

#include "app/gui/base/layers/error_notes.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/gui/session/answers/answer_viewer.h"

namespace noonmark {

namespace {

ResultRow hoursRow(const QString& name, double minutes, const QString& meaning) {
    return {name, QObject::tr("%1 h a day").arg(formatAmount(minutes / 60, 2)), meaning};
}

ResultRow minutesRow(const QString& name, double minutes, const QString& meaning) {
    return {name, formatAmount(minutes) + QStringLiteral(" min"), meaning};
}

std::vector<ResultRow> rowsOfPoints(const Answer& answer) {
    const ElementStudy& study = answer.as<ElementAnswer>()->study;
    PointFigures shown{.figures = computeFigures(study),
                       .points = study.receivers.size(),
                       .possibleMin = study.minutes.possibleMin / double(study.sun.dayCount()),
                       .steps = study.sun.steps.size(),
                       .belowHorizon = study.sun.belowHorizon,
                       .seconds = study.seconds.at("accumulate"),
                       .period = formatText(study.settings.period),
                       .byRays = study.engineKey == referenceEngine,
                       .engine = describeEngine(study)};
    if (study.error) shown.error = describe(*study.error);
    return makeRows(shown);
}

AnswerLayer layerOfPoints(const std::shared_ptr<const Answer>& answer) {
    const auto points = contentOf<ElementAnswer>(answer);
    const auto errorOf = [&](ShadowMeasure measure) { return describeError(points->study, measure); };
    return ElementView{.map = std::shared_ptr<const ElementMap>(points, &points->map),
                       .note = errorOf(ShadowMeasure::gross),
                       .runNote = errorOf(ShadowMeasure::continuous)};
}

QString titleOfPoints(const Answer& answer) {
    return QObject::tr("Points of %1").arg(QString::fromStdString(answer.part().scenario));
}

}  // namespace

const AnswerViewer& pointsViewer() {
    static const AnswerViewer viewer{pointsQuestion().key, layerOfPoints, rowsOfPoints, titleOfPoints};
    return viewer;
}

std::vector<ResultRow> makeRows(const PointFigures& shown) {
    const ElementFigures& figures = shown.figures;
    std::vector<ResultRow> rows{
        hoursRow(QObject::tr("Mean sun"), figures.meanSunlitMin,
                 QObject::tr("Hours of sun a day, mean over days and points")),
        hoursRow(QObject::tr("Least sun"), figures.leastSunlitMin,
                 QObject::tr("Hours of sun a day at the darkest point")),
        hoursRow(QObject::tr("Most sun"), figures.mostSunlitMin,
                 QObject::tr("Hours of sun a day at the sunniest point")),
        minutesRow(QObject::tr("Mean gross"), shown.possibleMin - figures.meanSunlitMin,
                   QObject::tr("Minutes in shadow per day, mean over days and points; a point that faces "
                               "away from the sun is in shadow")),
        minutesRow(QObject::tr("Mean continuous"), figures.meanContinuousMin,
                   QObject::tr("Longest unbroken run in shadow on any day, mean over the points")),
        minutesRow(QObject::tr("Max continuous"), figures.mostContinuousMin,
                   QObject::tr("Longest unbroken run in shadow at any point on any day")),
        {QObject::tr("Points"), formatCount(shown.points), QObject::tr("Points where sun is measured")},
        {QObject::tr("Steps of the sun"), formatCount(shown.steps), describeSteps(shown.belowHorizon)},
        {QObject::tr("Sunlit time"), formatAmount(shown.possibleMin) + QObject::tr(" min/day"),
         QObject::tr("Mean minutes a day with the sun above the horizon: 100 % of the time")},
        {QObject::tr("Time"), formatAmount(shown.seconds, 2) + QStringLiteral(" s"),
         QObject::tr("Time taken by the engine")},
        {QObject::tr("Period"), QString::fromStdString(shown.period), {}}};
    if (!shown.error.empty())
        rows.push_back({QObject::tr("Error"), localiseNumbers(QString::fromStdString(shown.error)),
                        QObject::tr("Against the ray reference, on a sample of the points over the same "
                                    "steps")});
    rows.push_back({QObject::tr("Engine"),
                    shown.byRays ? QObject::tr("Ray reference") : QObject::tr("Horizons of the points"),
                    QString::fromStdString(shown.engine)});
    return rows;
}

}  // namespace noonmark
