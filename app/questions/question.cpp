#include "app/questions/question.h"

#include <array>

namespace noonmark {

std::span<const Question* const> listQuestions() {
    static const std::array all{&studyQuestion(), &comparisonQuestion(), &scoreQuestion(), &pointsQuestion()};
    return all;
}

}  // namespace noonmark
