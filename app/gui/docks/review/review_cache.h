#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/questions/review_question.h"
#include "core/base/progress_share.h"
#include "core/base/result.h"

namespace noonmark {

/// The latest answers of reviews: one for each rule, baseline and scenario. `Answer` has a `question` with
/// its rule and its cities, before and after. An answer whose city is gone stays until newer ones push it
/// out, since undo brings the city back.
template <class Answer, std::size_t most>
class ReviewCache {
public:
    using Shared = std::shared_ptr<const Answer>;

    Shared add(Answer answer) {
        std::erase_if(all_, [&](const Shared& old) { return isOfSameCase(old->question, answer.question); });
        all_.push_back(std::make_shared<const Answer>(std::move(answer)));
        if (all_.size() > most) all_.erase(all_.begin());
        return all_.back();
    }
    void clear() { all_.clear(); }
    [[nodiscard]] bool empty() const { return all_.empty(); }

    /// The newest for which `holds(answer)`; null: none.
    template <class Holds>
    [[nodiscard]] Shared find(const Holds& holds) const {
        for (auto one = all_.rbegin(); one != all_.rend(); ++one)
            if (holds(**one)) return *one;
        return nullptr;
    }

private:
    std::vector<Shared> all_;  // oldest first
};

/// Answers, and why there are no more; empty: these are all.
template <class Answer>
struct ComputedAnswers {
    std::vector<Answer> made;
    std::optional<Error> error;
};

/// Answers questions one after the other by `compute(question, progress, stop)`; the first error ends it, and
/// what was computed before stays.
template <class Answer, class Question, class Compute>
ComputedAnswers<Answer> computeEach(const std::vector<Question>& questions, const Compute& compute,
                                    Progress& progress, const std::stop_token& stop) {
    ComputedAnswers<Answer> answers;
    for (std::size_t i = 0; i < questions.size() && !answers.error; ++i) {
        ProgressShare share(progress, i, questions.size());
        Result<Answer> answer = compute(questions[i], share, stop);
        if (answer)
            answers.made.push_back(*std::move(answer));
        else
            answers.error = answer.error();
    }
    return answers;
}

}  // namespace noonmark
