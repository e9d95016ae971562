#include "app/window/project/shown_result.h"

#include <QDateTime>
#include <QObject>

#include "app/window/project/comparison_rows.h"
#include "app/window/project/score_rows.h"

namespace noonmark {

namespace {

QString tr(const char* text) { return QObject::tr(text); }
QString textOf(const std::string& text) { return QString::fromStdString(text); }

// In the time of this machine: whoever reads it kept it there, as a rule.
QString keptAt(const KeptOrigin& origin) {
    const QDateTime at = QDateTime::fromString(textOf(origin.at), Qt::ISODate).toLocalTime();
    return at.isValid() ? at.toString(QStringLiteral("yyyy-MM-dd HH:mm")) : tr("at an unknown date");
}

std::vector<ResultRow> figureRows(const KeptStudy& study, const ShownResult& result) {
    const ShadowField& field = study.field;
    return rowsOf(StudyFigures{study.statistics,
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

std::vector<ResultRow> figureRows(const KeptImpact& impact, const ShownResult&) {
    return comparisonRowsOf(impact.figures);
}

std::vector<ResultRow> figureRows(const KeptScore& score, const ShownResult& result) {
    return scoreRowsOf(score.score, result.scenario, score.weights, result.answer->origin.period);
}

GroundAnswer::Map mapOf(const std::shared_ptr<const KeptAnswer>& kept) {
    if (const auto* study = std::get_if<KeptStudy>(&kept->answer))
        return std::shared_ptr<const ShadowField>(kept, &study->field);
    if (const auto* impact = std::get_if<KeptImpact>(&kept->answer))
        return std::shared_ptr<const Impact>(kept, &impact->impact);
    return std::shared_ptr<const Score>(kept, &std::get<KeptScore>(kept->answer).score);
}

}  // namespace

Result<ShownResult> shownResult(const KeptResult& result, const Project& project) {
    return answerOf(result).map([&](KeptAnswer answer) {
        ShownResult shown{result.name, result.scenario, {}, result.grid.cellM, {}, {}};
        shown.changes = changesSince(result, answer.origin, project);
        shown.weightChanges = weightChangesSince(answer.origin, project);
        shown.answer = std::make_shared<const KeptAnswer>(std::move(answer));
        return shown;
    });
}

std::optional<ShownResult> reweighed(const ShownResult& result, const Project& project) {
    auto changes = weightChangesSince(result.answer->origin, project);
    if (changes == result.weightChanges) return std::nullopt;
    ShownResult now = result;
    now.weightChanges = std::move(changes);
    return now;
}

GroundAnswer groundAnswerOf(const ShownResult& result) {
    const QString kept = tr("Kept %1: %2").arg(keptAt(result.answer->origin), textOf(result.name));
    const QString note = result.upToDate() ? kept : tr("%1. Out of date").arg(kept);
    return runsLookedFor({mapOf(result.answer), nullptr, note, !result.upToDate()});
}

std::vector<ResultRow> rowsOf(const ShownResult& result) {
    const KeptOrigin& origin = result.answer->origin;
    std::vector<ResultRow> rows{
        {tr("Kept result"), textOf(result.name), tr("As it was kept in the project, not computed anew")},
        {tr("Of"), textOf(result.scenario), {}},
        {tr("Region"),
         tr("%1\ncells of %2 m")
             .arg(origin.region.empty() ? tr("without a name") : textOf(origin.region))
             .arg(result.cellM),
         {}},
        {tr("Made by"), tr("%1, kept %2").arg(textOf(origin.program), keptAt(origin)), {}}};
    std::visit(
        [&](const auto& answer) {
            for (ResultRow& row : figureRows(answer, result)) rows.push_back(std::move(row));
        },
        result.answer->answer);
    return rows;
}

QString keptWords(const ShownResult& result) {
    QStringList words{tr("A result kept %1.").arg(keptAt(result.answer->origin))};
    for (const auto* changes : {&result.changes, &result.weightChanges})
        for (const std::string& change : *changes) words << textOf(change);
    if (result.upToDate()) words << tr("Nothing it rests on has changed since.");
    return words.join(QLatin1Char('\n'));
}

std::vector<MonthFigures> monthsOf(const ShownResult& result) {
    const auto* score = std::get_if<KeptScore>(&result.answer->answer);
    return score ? score->score.months : std::vector<MonthFigures>();
}

}  // namespace noonmark
