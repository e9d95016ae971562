#include "app/gui/session/answers/answer_viewer.h"

#include <QObject>
#include <algorithm>
#include <array>

#include "app/gui/base/widgets/translated.h"
#include "app/gui/session/answers/result_rows.h"

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

}  // namespace noonmark
