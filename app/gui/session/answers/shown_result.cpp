#include "app/gui/session/answers/shown_result.h"

#include <QDateTime>
#include <QObject>

#include "app/gui/session/answers/comparison_rows.h"
#include "app/gui/session/answers/element_rows.h"
#include "app/gui/session/answers/score_rows.h"

namespace noonmark {

namespace {

QString formatText(const std::string& text) { return QString::fromStdString(text); }

// In local time, since the reader usually saved it on the same machine.
QString keptAt(const SavedOrigin& origin) {
    const QDateTime at = QDateTime::fromString(formatText(origin.at), Qt::ISODate).toLocalTime();
    return at.isValid() ? at.toString(QStringLiteral("yyyy-MM-dd HH:mm")) : QObject::tr("at an unknown date");
}

std::vector<ResultRow> figureRows(const SavedStudy& study, const ShownResult& result) {
    const ShadowField& field = study.field;
    return makeRows(StudyFigures{study.statistics,
                                 isInstant(field),
                                 study.steps,
                                 study.belowHorizon,
                                 field.sunlitMinutesPerDay,
                                 0,
                                 study.seconds,
                                 result.answer->origin.period,
                                 {{"error", study.error}},
                                 field.engine});
}

std::vector<ResultRow> figureRows(const SavedImpact& impact, const ShownResult&) {
    return makeComparisonRows(impact.figures);
}

std::vector<ResultRow> figureRows(const SavedScore& score, const ShownResult& result) {
    return makeScoreRows(score.score, result.scenario, score.weights, result.answer->origin.period);
}

std::vector<ResultRow> figureRows(const SavedElements& saved, const ShownResult& result) {
    return makeRows(PointFigures{saved.figures, saved.map.elements.size(), saved.map.possibleMin, saved.steps,
                                 saved.belowHorizon, saved.seconds, result.answer->origin.period, saved.error,
                                 saved.byRays, result.answer->origin.engine});
}

QString noteOf(const ShownResult& result) {
    const QString saved =
        QObject::tr("Saved %1: %2").arg(keptAt(result.answer->origin), formatText(result.name));
    return result.upToDate() ? saved : QObject::tr("%1. Outdated").arg(saved);
}

GroundAnswer::Map mapOf(const std::shared_ptr<const SavedAnswer>& saved) {
    if (const auto* study = std::get_if<SavedStudy>(&saved->answer))
        return std::shared_ptr<const ShadowField>(saved, &study->field);
    if (const auto* impact = std::get_if<SavedImpact>(&saved->answer))
        return std::shared_ptr<const Impact>(saved, &impact->impact);
    return std::shared_ptr<const Score>(saved, &std::get<SavedScore>(saved->answer).score);
}

}  // namespace

Result<ShownResult> shownResult(const SavedResult& result, const Project& project) {
    return readSavedAnswer(result).map([&](SavedAnswer answer) {
        ShownResult shown{result.name, result.scenario, {}, result.grid.cellM, {}, {}};
        shown.changes = findChangesSince(result, answer.origin, project);
        shown.weightChanges = findWeightChangesSince(answer.origin, project);
        shown.answer = std::make_shared<const SavedAnswer>(std::move(answer));
        return shown;
    });
}

std::optional<ShownResult> reweigh(const ShownResult& result, const Project& project) {
    auto changes = findWeightChangesSince(result.answer->origin, project);
    if (changes == result.weightChanges) return std::nullopt;
    ShownResult now = result;
    now.weightChanges = std::move(changes);
    return now;
}

std::optional<ElementView> makeElementView(const ShownResult& result) {
    const auto* saved = std::get_if<SavedElements>(&result.answer->answer);
    if (!saved) return std::nullopt;
    return ElementView{std::shared_ptr<const ElementMap>(result.answer, &saved->map), noteOf(result),
                       !result.upToDate()};
}

GroundAnswer makeGroundAnswer(const ShownResult& result) {
    return runsLookedFor({mapOf(result.answer), nullptr, noteOf(result), !result.upToDate()});
}

std::vector<ResultRow> makeRows(const ShownResult& result) {
    const SavedOrigin& origin = result.answer->origin;
    std::vector<ResultRow> rows{
        {QObject::tr("Saved result"), formatText(result.name),
         QObject::tr("As saved in the project, not recomputed")},
        {QObject::tr("Scenario"), formatText(result.scenario), {}},
        {QObject::tr("Region"),
         QObject::tr("%1\ncells of %2 m")
             .arg(origin.region.empty() ? QObject::tr("unnamed") : formatText(origin.region))
             .arg(result.cellM),
         {}},
        {QObject::tr("Computed by"),
         QObject::tr("%1, saved %2").arg(formatText(origin.program), keptAt(origin)),
         {}}};
    std::visit(
        [&](const auto& answer) {
            for (ResultRow& row : figureRows(answer, result)) rows.push_back(std::move(row));
        },
        result.answer->answer);
    return rows;
}

QString describeSaved(const ShownResult& result) {
    QStringList words{QObject::tr("A result saved %1.").arg(keptAt(result.answer->origin))};
    for (const auto* changes : {&result.changes, &result.weightChanges})
        for (const std::string& change : *changes) words << formatText(change);
    if (result.upToDate()) words << QObject::tr("Its inputs have not changed since.");
    return words.join(QLatin1Char('\n'));
}

std::vector<MonthFigures> monthsOf(const ShownResult& result) {
    const auto* score = std::get_if<SavedScore>(&result.answer->answer);
    return score ? score->score.months : std::vector<MonthFigures>();
}

}  // namespace noonmark
