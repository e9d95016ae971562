#include <QObject>

#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/questions/glazing_question.h"

namespace noonmark {

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
