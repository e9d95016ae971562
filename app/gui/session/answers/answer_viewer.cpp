#include "app/gui/session/answers/answer_viewer.h"

#include <algorithm>
#include <array>

namespace noonmark {

const AnswerViewer& viewerOf(const Answer& answer) {
    static const std::array all{&studyViewer(), &comparisonViewer(), &scoreViewer(), &pointsViewer(),
                                &savedViewer()};
    return **std::ranges::find(all, answer.question().key, &AnswerViewer::question);
}

}  // namespace noonmark
