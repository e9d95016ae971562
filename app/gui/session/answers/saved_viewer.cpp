#include <QDateTime>
#include <QObject>

#include "app/gui/session/answers/answer_viewer.h"
#include "app/questions/saved_question.h"

namespace noonmark {

namespace {

QString formatText(const std::string& text) { return QString::fromStdString(text); }

// In local time, since the reader usually saved it on the same machine.
QString keptAt(const SavedOrigin& origin) {
    const QDateTime at = QDateTime::fromString(formatText(origin.at), Qt::ISODate).toLocalTime();
    return at.isValid() ? at.toString(QStringLiteral("yyyy-MM-dd HH:mm")) : QObject::tr("at an unknown date");
}

std::vector<ResultRow> figureRows(const SavedStudy& study, const SavedContent& result, ShownAs show) {
    const ShadowField& field = study.field;
    return makeRows(StudyFigures{study.statistics,
                                 isInstant(field),
                                 study.steps,
                                 study.belowHorizon,
                                 field.sunlitMinutesPerDay,
                                 0,
                                 study.seconds,
                                 result.answer.origin.period,
                                 {{"error", study.error}},
                                 field.engine},
                    show);
}

std::vector<ResultRow> figureRows(const SavedImpact& impact, const SavedContent&, ShownAs show) {
    return makeRows(impact.figures, show);
}

std::vector<ResultRow> figureRows(const SavedScore& score, const SavedContent& result, ShownAs show) {
    return makeScoreRows(score.score, result.result->scenario, score.weights, result.answer.origin.period,
                         show);
}

std::vector<ResultRow> figureRows(const SavedElements& saved, const SavedContent& result, ShownAs show) {
    return makeRows(
        PointFigures{saved.figures, saved.steps, saved.belowHorizon, saved.seconds,
                     result.answer.origin.period, saved.error, saved.byRays, result.answer.origin.engine},
        show);
}

std::vector<ResultRow> figureRows(const SavedSunByPlace& saved, const SavedContent& result, ShownAs) {
    return makeRows(PlaceFigures{saved.sun, saved.steps, saved.belowHorizon, saved.seconds,
                                 result.answer.origin.period, saved.error, result.answer.origin.engine});
}

QString noteOf(const SavedContent& result) {
    const QString saved =
        QObject::tr("Saved %1: %2").arg(keptAt(result.answer.origin), formatText(result.result->name));
    return result.upToDate() ? saved : QObject::tr("%1. Outdated").arg(saved);
}

GroundAnswer::Map mapOf(const std::shared_ptr<const SavedContent>& saved) {
    const auto& answer = saved->answer.answer;
    if (const auto* study = std::get_if<SavedStudy>(&answer))
        return std::shared_ptr<const ShadowField>(saved, &study->field);
    if (const auto* impact = std::get_if<SavedImpact>(&answer))
        return std::shared_ptr<const Impact>(saved, &impact->impact);
    return std::shared_ptr<const Score>(saved, &std::get<SavedScore>(answer).score);
}

// Places have a table of their own that paints the view (app/gui/docks/places).
// The note states when the result was saved and whether anything has changed since; if so, it is marked.
std::optional<AnswerLayer> layerOfSaved(const std::shared_ptr<const Answer>& answer) {
    const auto saved = contentOf<SavedContent>(answer);
    if (std::holds_alternative<SavedSunByPlace>(saved->answer.answer)) return std::nullopt;
    const QString note = noteOf(*saved);
    if (const auto* points = std::get_if<SavedElements>(&saved->answer.answer))
        return ElementView{std::shared_ptr<const ElementMap>(saved, &points->map), note, !saved->upToDate()};
    return markMissingRuns({mapOf(saved), nullptr, note, !saved->upToDate()});
}

// Its figures, preceded by what it is, where, when and by which version it was computed.
std::vector<ResultRow> rowsOfSaved(const Answer& answer, ShownAs show) {
    const auto& saved = *answer.as<SavedContent>();
    const SavedOrigin& origin = saved.answer.origin;
    std::vector<ResultRow> rows{
        {QObject::tr("Saved result"), formatText(saved.result->name),
         QObject::tr("As saved in the project, not recomputed")},
        {QObject::tr("Scenario"), formatText(saved.result->scenario), {}},
        {QObject::tr("Region"),
         QObject::tr("%1\ncells of %2 m")
             .arg(origin.region.empty() ? QObject::tr("unnamed") : formatText(origin.region))
             .arg(saved.result->grid.cellM),
         {}},
        {QObject::tr("Computed by"),
         QObject::tr("%1, saved %2").arg(formatText(origin.program), keptAt(origin)),
         {}}};
    std::visit(
        [&](const auto& content) {
            for (ResultRow& row : figureRows(content, saved, show)) rows.push_back(std::move(row));
        },
        saved.answer.answer);
    return rows;
}

QString titleOfSaved(const Answer& answer) {
    return QObject::tr("Saved result %1").arg(formatText(answer.as<SavedContent>()->result->name));
}

// When the result was saved, and each change since.
AnswerNote describeSaved(const Answer& answer) {
    const auto& saved = *answer.as<SavedContent>();
    QStringList words{QObject::tr("A result saved %1.").arg(keptAt(saved.answer.origin))};
    for (const auto* changes : {&saved.changes, &saved.weightChanges})
        for (const std::string& change : *changes) words << formatText(change);
    if (saved.upToDate()) words << QObject::tr("Its inputs have not changed since.");
    return {words.join(QLatin1Char('\n')), !saved.upToDate()};
}

}  // namespace

const AnswerViewer& savedViewer() {
    static const AnswerViewer viewer{savedQuestion().key, layerOfSaved, rowsOfSaved,
                                     titleOfSaved,        nullptr,      describeSaved};
    return viewer;
}

}  // namespace noonmark
