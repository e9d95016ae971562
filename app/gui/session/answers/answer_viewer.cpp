#include "app/gui/session/answers/answer_viewer.h"

#include <QDateTime>
#include <QObject>
#include <algorithm>
#include <array>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/questions/glazing_question.h"
#include "app/questions/saved_question.h"

namespace noonmark {

namespace {

std::optional<AnswerLayer> layerOfAny(const std::shared_ptr<const Answer>& answer) {
    const auto field = answer->field();
    if (!field) return std::nullopt;
    return markMissingRuns({.map = std::shared_ptr<const ShadowField>(answer, field.get())});
}

std::vector<ResultRow> rowsOfAny(const Answer& answer, ShownAs) { return figureRows(answer.figures()); }

QString titleOfAny(const Answer& answer) {
    return QObject::tr("%1 of %2")
        .arg(translated(answer.question().label), QString::fromStdString(answer.part().scenario));
}

const AnswerViewer anyViewer{{}, layerOfAny, rowsOfAny, titleOfAny};

}  // namespace

QString listedName(const Answer& answer) {
    const QString title = viewerOf(answer).title(answer);
    if (!answer.settings()) return title;
    return QObject::tr("%1, %2").arg(title,
                                     QString::fromStdString(formatText(answer.settings()->period.start)));
}

const AnswerViewer& viewerOf(const Answer& answer) { return viewerOf(answer.question().key); }

const AnswerViewer& viewerOf(std::string_view question) {
    static const std::array all{&studyViewer(),   &comparisonViewer(), &scoreViewer(),   &pointsViewer(),
                                &byPlaceViewer(), &reviewViewer(),     &glazingViewer(), &savedViewer()};
    const auto found = std::ranges::find(all, question, &AnswerViewer::question);
    return found == all.end() ? anyViewer : **found;
}

namespace {

QString qtText(const std::string& text) { return QString::fromStdString(text); }

// In local time, since the reader usually saved it on the same machine.
QString keptAt(const SavedOrigin& origin) {
    const QDateTime at = QDateTime::fromString(qtText(origin.at), Qt::ISODate).toLocalTime();
    return at.isValid() ? at.toString(QStringLiteral("yyyy-MM-dd HH:mm")) : QObject::tr("at an unknown date");
}

QString noteOf(const SavedContent& result) {
    const QString saved =
        QObject::tr("Saved %1: %2").arg(keptAt(result.answer.origin), qtText(result.result->name));
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
        {QObject::tr("Saved result"), qtText(saved.result->name),
         QObject::tr("As saved in the project, not recomputed")},
        {QObject::tr("Scenario"), qtText(saved.result->scenario), {}},
        {QObject::tr("Region"),
         QObject::tr("%1\ncells of %2 m")
             .arg(origin.region.empty() ? QObject::tr("unnamed") : qtText(origin.region))
             .arg(saved.result->grid.cellM),
         {}},
        {QObject::tr("Computed by"),
         QObject::tr("%1, saved %2").arg(qtText(origin.program), keptAt(origin)),
         {}}};
    const auto list = viewerOf(saved.result->kind).savedRows;
    for (ResultRow& row : list ? list(saved, show) : figureRows(answer.figures()))
        rows.push_back(std::move(row));
    return rows;
}

QString titleOfSaved(const Answer& answer) {
    return QObject::tr("Saved result %1").arg(qtText(answer.as<SavedContent>()->result->name));
}

// When the result was saved, and each change since.
AnswerNote describeSaved(const Answer& answer) {
    const auto& saved = *answer.as<SavedContent>();
    QStringList words{QObject::tr("A result saved %1.").arg(keptAt(saved.answer.origin))};
    for (const auto* changes : {&saved.changes, &saved.weightChanges})
        for (const std::string& change : *changes) words << qtText(change);
    if (saved.upToDate()) words << QObject::tr("Its inputs have not changed since.");
    return {words.join(QLatin1Char('\n')), !saved.upToDate()};
}

}  // namespace

const AnswerViewer& savedViewer() {
    static const AnswerViewer viewer{savedQuestion().key, layerOfSaved, rowsOfSaved,
                                     titleOfSaved,        nullptr,      describeSaved};
    return viewer;
}

namespace {

// The review dock lists the places, or paints the windows; here stand the counts.
std::vector<ResultRow> rowsOfReview(const Answer& answer, ShownAs) { return figureRows(answer.figures()); }

template <class Reviewed>
QString titleOfReview(const Answer& answer) {
    const auto& asked = answer.as<Reviewed>()->question;
    return QObject::tr("%1: %2 compared with %3")
        .arg(QString::fromStdString(asked.rule.name), QString::fromStdString(asked.to),
             QString::fromStdString(asked.from));
}

}  // namespace

const AnswerViewer& reviewViewer() {
    static const AnswerViewer viewer{.question = reviewQuestion().key,
                                     .layer = nullptr,
                                     .rows = rowsOfReview,
                                     .title = titleOfReview<ReviewAnswer>};
    return viewer;
}

const AnswerViewer& glazingViewer() {
    static const AnswerViewer viewer{.question = glazingQuestion().key,
                                     .layer = nullptr,
                                     .rows = rowsOfReview,
                                     .title = titleOfReview<GlazingAnswer>};
    return viewer;
}

}  // namespace noonmark
