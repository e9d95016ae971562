#pragma once

#include <algorithm>
#include <memory>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/gui/base/widgets/error_text.h"
#include "app/questions/review_question.h"
#include "core/base/progress.h"
#include "core/base/result.h"

namespace noonmark {

/// The latest answers of reviews: one for each rule, baseline and scenario. `Answer` has a `question` with
/// its rule and its cities, before and after. An answer stays after its city was removed, until newer
/// ones displace it, since undo restores the city.
template <class Answer, std::size_t maximum>
class ReviewCache {
public:
    using Shared = std::shared_ptr<const Answer>;

    void add(const Shared& answer) {
        std::erase_if(all_, [&](const Shared& old) { return isOfSameCase(old->question, answer->question); });
        all_.push_back(answer);
        if (all_.size() > maximum) all_.erase(all_.begin());
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

/// Answers questions one after the other by `compute(question, progress, stop)`: what each of them gave, in
/// their order. Fewer than questions: it was cancelled, and what was computed before stays.
template <class Answer, class Question, class Compute>
std::vector<Result<Answer>> computeEach(const std::vector<Question>& questions, const Compute& compute,
                                        Progress& progress, const std::stop_token& stop) {
    std::vector<Result<Answer>> answers;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        ProgressShare share(progress, i, questions.size());
        Result<Answer> answer = compute(questions[i], share, stop);
        if (!answer && isCancelled(answer.error())) break;
        answers.push_back(std::move(answer));
    }
    return answers;
}

/// Hands each answer of computeEach() to `adopt(answer, i)`, and returns the errors of the other scenarios.
template <class Answer, class Adopt>
ScenarioErrors adoptEach(std::vector<Result<Answer>> answers, const std::vector<std::string>& scenarios,
                         const Adopt& adopt) {
    ScenarioErrors errors;
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (answers[i])
            adopt(*std::move(answers[i]), i);
        else
            errors.emplace_back(scenarios[i], answers[i].error());
    return errors;
}

/// The same question about several scenarios.
template <class Question>
struct ScenarioQuestions {
    std::vector<Question> questions;
    std::vector<std::string> scenarios;  ///< of each question
    ScenarioErrors refused;              ///< of the scenarios about which it cannot be asked
    [[nodiscard]] std::size_t count() const { return scenarios.size() + refused.size(); }
};

/// `ask(scenario)` returns the question, or why it cannot be asked.
template <class Question, class Ask>
ScenarioQuestions<Question> askAbout(const std::vector<std::string>& scenarios, const Ask& ask) {
    ScenarioQuestions<Question> asked;
    for (const std::string& scenario : scenarios) {
        Result<Question> question = ask(scenario);
        if (!question) {
            asked.refused.emplace_back(scenario, question.error());
            continue;
        }
        asked.questions.push_back(*std::move(question));
        asked.scenarios.push_back(scenario);
    }
    return asked;
}

/// Hands the answers over as above, and returns all errors, those of refused questions first.
template <class Question, class Answer, class Adopt>
ScenarioErrors adoptEach(std::vector<Result<Answer>> answers, const ScenarioQuestions<Question>& asked,
                         const Adopt& adopt) {
    ScenarioErrors errors = adoptEach(std::move(answers), asked.scenarios, adopt);
    errors.insert(errors.begin(), asked.refused.begin(), asked.refused.end());
    return errors;
}

/// Rules of a few days are computed again by themselves; those of a range of days on request.
bool hasFewDays(const Rule& rule);

/// The timeline behind one review on one day of any year that the rule's clock covers, with the rule's hours
/// and step.
struct ReviewDay {
    DayTimeline day;
    DayClock clock;
    double stepMinutes = 1;
};
Result<ReviewDay> computeReviewDay(const ReviewAnswer& answer, std::size_t review, CivilDate day,
                                   Progress& progress, std::stop_token stop);

/// The timelines behind one review on the days of the rule's range (at most every second day of a long one),
/// in steps of ten minutes or the rule's if they are longer.
struct ReviewRange {
    std::vector<DayTimeline> days;
    DayClock clock;
    double stepMinutes = 10;
};
Result<ReviewRange> computeReviewRange(const ReviewAnswer& answer, std::size_t review, Progress& progress,
                                       std::stop_token stop);

}  // namespace noonmark
