#include <QObject>

#include "app/gui/base/layers/error_notes.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/answers/result_rows.h"

namespace noonmark {

namespace {

std::vector<ResultRow> rowsOfPoints(const Answer& answer, ShownAs show) {
    const ElementStudy& study = answer.as<ElementAnswer>()->study;
    PointFigures shown{.figures = computeFigures(study),
                       .steps = study.sun.steps.size(),
                       .belowHorizon = study.sun.belowHorizon,
                       .seconds = study.seconds.at("accumulate"),
                       .period = formatText(study.settings.period),
                       .byRays = study.engineKey == referenceEngine,
                       .engine = describeEngine(study)};
    if (study.error) shown.error = describe(*study.error);
    return makeRows(shown, show);
}

std::optional<AnswerLayer> layerOfPoints(const std::shared_ptr<const Answer>& answer) {
    const auto points = contentOf<ElementAnswer>(answer);
    const auto errorOf = [&](ShadowMeasure measure) { return describeError(points->study, measure); };
    return ElementView{.map = std::shared_ptr<const ElementMap>(points, &points->map),
                       .note = errorOf(ShadowMeasure::gross),
                       .runNote = errorOf(ShadowMeasure::continuous)};
}

std::optional<AnswerLayer> layerOfSavedPoints(const std::shared_ptr<const SavedContent>& saved) {
    return ElementView{.map = std::shared_ptr<const ElementMap>(saved, &saved->as<SavedElements>()->map)};
}

std::vector<ResultRow> rowsOfSavedPoints(const SavedContent& saved, ShownAs show) {
    const auto& points = *saved.as<SavedElements>();
    return makeRows(
        PointFigures{points.figures, points.steps, points.belowHorizon, points.seconds,
                     saved.answer.origin.period, points.error, points.byRays, saved.answer.origin.engine},
        show);
}

QString titleOfPoints(const Answer& answer) {
    return QObject::tr("Points of %1").arg(QString::fromStdString(answer.part().scenario));
}

}  // namespace

const AnswerViewer& pointsViewer() {
    static const AnswerViewer viewer{.question = pointsQuestion().key,
                                     .layer = layerOfPoints,
                                     .rows = rowsOfPoints,
                                     .title = titleOfPoints,
                                     .savedLayer = layerOfSavedPoints,
                                     .savedRows = rowsOfSavedPoints};
    return viewer;
}

std::vector<ResultRow> makeRows(const PointFigures& shown, ShownAs show) {
    const FigureContext context{.sunlitMin = shown.figures.possibleMin, .show = show};
    std::vector<ResultRow> rows = figureRows(listLines(elementFigures().of(shown.figures), context));
    rows.push_back(methodRow(QObject::tr("Period"), QString::fromStdString(shown.period)));
    rows.push_back(methodRow(QObject::tr("Steps of the sun"), formatCount(shown.steps),
                             describeSteps(shown.belowHorizon)));
    rows.push_back(
        methodRow(QObject::tr("Engine"),
                  shown.byRays ? QObject::tr("Ray reference") : QObject::tr("Horizons of the points"),
                  QString::fromStdString(shown.engine)));
    if (!shown.error.empty())
        rows.push_back(methodRow(QObject::tr("Error"), localiseNumbers(QString::fromStdString(shown.error)),
                                 QObject::tr("Against the ray reference, on a sample of the points over the "
                                             "same steps")));
    rows.push_back(methodRow(QObject::tr("Time"), formatAmount(shown.seconds, 2) + QStringLiteral(" s"),
                             QObject::tr("Time taken by the engine")));
    return rows;
}

}  // namespace noonmark
