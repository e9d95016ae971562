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

QString noteOf(const SavedContent& result) {
    const QString saved =
        QObject::tr("Saved %1: %2").arg(keptAt(result.answer.origin), formatText(result.result->name));
    return result.upToDate() ? saved : QObject::tr("%1. Outdated").arg(saved);
}

// The note states when the result was saved and whether anything has changed since; if so, it is marked.
std::optional<AnswerLayer> layerOfSaved(const std::shared_ptr<const Answer>& answer) {
    const auto saved = contentOf<SavedContent>(answer);
    const auto find = viewerOf(saved->result->kind).savedLayer;
    auto layer = find ? find(saved) : std::nullopt;
    if (!layer) return layer;
    std::visit(
        [&](auto& shown) {
            shown.note = noteOf(*saved);
            shown.marked = !saved->upToDate();
        },
        *layer);
    return layer;
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
    const auto list = viewerOf(saved.result->kind).savedRows;
    for (ResultRow& row : list ? list(saved, show) : figureRows(answer.figures()))
        rows.push_back(std::move(row));
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
