#include "app/questions/answer.h"

#include "app/questions/saved_question.h"
#include "core/study/elements/place_elements.h"

namespace noonmark {

namespace {

template <class T>
bool isSame(const T* a, const T* b) {
    return a && b ? *a == *b : a == b;
}

}  // namespace

bool Answer::isSaved() const { return &question() == &savedQuestion(); }

const std::vector<ContributionTable>& Answer::ofPlaces() const {
    static const std::vector<ContributionTable> none;
    return none;
}

Result<std::shared_ptr<const Book>> Answer::layOut(const std::shared_ptr<const City>&,
                                                   const AnswerFiles&) const {
    return nullptr;
}

bool Answer::asksSameAs(const Answer& other) const {
    const MeasuredPart mine = part(), theirs = other.part();
    return &question() == &other.question() && isSame(settings(), other.settings()) &&
           isSame(points(), other.points()) && mine.scenario == theirs.scenario &&
           mine.baseline == theirs.baseline && mine.weights == theirs.weights;
}

}  // namespace noonmark
