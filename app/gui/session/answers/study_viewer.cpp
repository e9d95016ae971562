#include <QObject>

#include "app/gui/base/layers/ground_answer.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/answers/result_rows.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"

namespace noonmark {

namespace {

double accumulateSeconds(const Study& study) {
    const auto found = study.seconds.find("accumulate");
    return found == study.seconds.end() ? 0 : found->second;
}

void addErrorRows(std::vector<ResultRow>& rows, const std::vector<ErrorLine>& errors) {
    for (const ErrorLine& line : errors)
        rows.push_back(methodRow(
            QString::fromStdString(line.name).replace(0, 1, QChar(line.name[0]).toUpper()),
            localiseNumbers(QString::fromStdString(line.value)),
            QObject::tr("Against the ray reference, on a sample of the receivers over the same steps")));
}

void addTimeRows(std::vector<ResultRow>& rows, const StudyFigures& figures) {
    constexpr double minMegaRays = 0.1;  // fewer are shown as 0: an engine that casts rays for its error only
    const double megaRays = figures.seconds > 0 ? double(figures.rays) / figures.seconds * 1e-6 : 0;
    if (megaRays >= minMegaRays)
        rows.push_back(methodRow(
            QObject::tr("Speed"), QObject::tr("%1 million rays a second").arg(formatAmount(megaRays)),
            QObject::tr("%1 occlusion ray(s) divided by the engine's time", "", pluralNumber(figures.rays))
                .arg(formatCount(figures.rays))));
    rows.push_back(methodRow(QObject::tr("Time"), formatAmount(figures.seconds, 2) + QStringLiteral(" s"),
                             QObject::tr("Time taken by the engine")));
}

std::vector<std::pair<TreeColumns, ShadowStatistics>> statisticsWithTrees(const ShadowField& field) {
    std::vector<std::pair<TreeColumns, ShadowStatistics>> all;
    for (const ShadeColumn& shade : listShadeColumns(field))
        all.emplace_back(shade.column, computeStatistics(*shade.field));
    return all;
}

StudyFigures figuresOfStudy(const Study& study) {
    return {study.statistics,
            isInstant(study.field),
            study.sun.steps.size(),
            study.sun.belowHorizon,
            study.field.sunlitMinutesPerDay,
            study.field.cost.rays,
            accumulateSeconds(study),
            statePeriod(study.settings.period),
            makeErrorLines(study),
            study.field.engine,
            study.monthError ? std::vector{*study.monthError} : std::vector<ShownError>(),
            statisticsWithTrees(study.field)};
}

std::optional<AnswerLayer> layerOfStudy(const std::shared_ptr<const Answer>& answer) {
    return makeGroundAnswer(contentOf<Study>(answer));
}

std::vector<ResultRow> rowsOfStudy(const Answer& answer, ShownAs show) {
    return makeRows(figuresOfStudy(*answer.as<Study>()), show);
}

std::optional<AnswerLayer> layerOfSavedStudy(const std::shared_ptr<const SavedContent>& saved) {
    return makeGroundAnswer(saved, saved->as<SavedStudy>()->field);
}

// The text of the error states the others.
std::vector<ShownError> onlyMonths(std::vector<ShownError> errors) {
    std::erase_if(errors, [](const ShownError& error) { return error.facts.key != "cell_month"; });
    return errors;
}

std::vector<ResultRow> rowsOfSavedStudy(const SavedContent& saved, ShownAs show) {
    const auto& study = *saved.as<SavedStudy>();
    const ShadowField& field = study.field;
    return makeRows(StudyFigures{study.statistics,
                                 isInstant(field),
                                 study.steps,
                                 study.belowHorizon,
                                 field.sunlitMinutesPerDay,
                                 0,
                                 study.seconds,
                                 saved.answer.origin.period,
                                 {{"error", study.error}},
                                 field.engine,
                                 onlyMonths(study.errors),
                                 statisticsWithTrees(field)},
                    show);
}

Sentence nameOfStudy(const MeasuredPart& part) { return {"%1", {part.scenario}}; }

Sentence titleOfStudy(const MeasuredPart& part) { return {NM_TEXT("Study of %1"), {part.scenario}}; }

}  // namespace

const AnswerViewer& studyViewer() {
    static const AnswerViewer viewer{.question = studyQuestion().key,
                                     .layer = layerOfStudy,
                                     .rows = rowsOfStudy,
                                     .title = titleOfStudy,
                                     .name = nameOfStudy,
                                     .savedLayer = layerOfSavedStudy,
                                     .savedRows = rowsOfSavedStudy};
    return viewer;
}

QString describeSteps(std::uint64_t belowHorizon) {
    return QObject::tr("Positions of the sun above the horizon; %1 below it was/were left out", "",
                       pluralNumber(belowHorizon))
        .arg(formatCount(belowHorizon));
}

std::vector<ResultRow> makeRows(const StudyFigures& figures, ShownAs show) {
    const FigureContext context{figures.statistics.receiverAreaM2, figures.sunlitMinutesPerDay,
                                figures.instant, show};
    std::vector<ResultRow> rows = figureRows(listLines(shadowFigures().of(figures.statistics), context));
    for (const auto& [column, statistics] : figures.withTrees)
        for (ResultRow& row : figureRows(listLines({treeFigures(column), &statistics}, context)))
            rows.push_back(std::move(row));
    rows.push_back({QObject::tr("Sunlit time"),
                    formatAmount(figures.sunlitMinutesPerDay) + QObject::tr(" min/day"),
                    QObject::tr("Mean minutes a day with the sun above the horizon: 100 % of the time")});
    rows.push_back(methodRow(QObject::tr("Period"), periodText(figures.period)));
    rows.push_back(methodRow(QObject::tr("Steps of the sun"), formatCount(figures.steps),
                             describeSteps(figures.belowHorizon)));
    rows.push_back(methodRow(QObject::tr("Engine"), QString::fromStdString(figures.engine)));
    addErrorRows(rows, figures.errors);
    addErrors(rows, figures.monthErrors);
    addTimeRows(rows, figures);
    return rows;
}

namespace {

std::vector<ResultRow> rowsOfPoints(const Answer& answer, ShownAs show) {
    const ElementStudy& study = answer.as<ElementAnswer>()->study;
    PointFigures shown{.figures = computeFigures(study),
                       .steps = study.sun.steps.size(),
                       .belowHorizon = study.sun.belowHorizon,
                       .seconds = study.seconds.at("accumulate"),
                       .period = statePeriod(study.settings.period),
                       .byRays = study.engineKey == referenceEngine,
                       .engine = describeEngine(study),
                       .withTrees = listFiguresWithTrees(study)};
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

Sentence titleOfPoints(const MeasuredPart& part) { return {NM_TEXT("Points of %1"), {part.scenario}}; }

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
    std::vector<ResultRow> rows =
        figureRows(listElementLines(shown.figures, shown.withTrees, {.show = show}));
    rows.push_back(methodRow(QObject::tr("Period"), periodText(shown.period)));
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
