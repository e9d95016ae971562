#pragma once

// The review of places by the rule of a board (app/questions/review_question.h). ReviewSession holds what is
// chosen, asks for it and hands the answer to the workbench, which shows, lists and saves it as all others;
// it keeps the latest one for the dock, and the answer for a building that is being shaped. review_choice is
// the choice as it is saved, ReviewRange and ReviewDay what charts show. ReviewDock shows it: RuleForm and
// PlaceList choose, VerdictTable lists verdicts and the numbers behind them, DayPanel and RangePanel draw
// charts on a ChartWidget. verdict_table has the words and colours of verdicts.

#include <QObject>

#include "app/gui/base/jobs/job.h"
#include "app/gui/docks/review/review_cache.h"
#include "app/gui/docks/review/review_choice.h"
#include "app/gui/session/workbench.h"
#include "app/questions/review_question.h"
#include "core/review/library/rule_library.h"
#include "scenarios/project/rule_parcels.h"

namespace noonmark {

enum class ProjectPart;

/// Whether only the places in reach are to be reviewed and still to be found: where the scenario proposes
/// something, of a rule about places.
inline bool isScreened(const ReviewChoice& choice, const ReviewQuestion& question) {
    return !question.inReach && question.before != question.after && !question.rule.receivers.hasLines() &&
           screensPlaces(choice.reviewed, question.places.size());
}

/// keepPlacesInReach(); where nobody asked for those in reach and there is none, all stay.
inline Result<void> keepReach(const ReviewChoice& choice, ReviewQuestion& question,
                              const PlacesInReach& found) {
    if (found.places.empty() && choice.reviewed == ReviewedPlaces::automatic) return {};
    return keepPlacesInReach(question, found);
}

/// The review of the open project: the choice, its answer, and the answer for the building that is being
/// shaped. Long work runs in jobs. Knows no widgets.
class ReviewSession final : public QObject {
    Q_OBJECT
public:
    explicit ReviewSession(Workbench& workbench, QObject* parent = nullptr);  ///< `workbench` must outlive it

    [[nodiscard]] const RuleLibrary& library() const { return library_; }
    [[nodiscard]] const ReviewChoice& choice() const { return choice_; }
    [[nodiscard]] const std::string& zone() const;  ///< of the study, IANA
    void choose(const ReviewChoice& choice);        ///< no undo step, like the camera
    /// Another project was opened: takes the choice saved in it, and drops the answers of the one before.
    void restore(const std::string& text);
    /// Takes the answers of another session of the same workbench.
    void takeOver(const ReviewSession& before);

    [[nodiscard]] Result<Rule> rule() const { return library_.find(choice_.rule, choice_.options); }
    /// The places that can be chosen; the lots, for a rule about parcels.
    [[nodiscard]] std::vector<Place> candidates() const;
    /// What run() would compute. Error: what is still missing, and what to do.
    [[nodiscard]] Result<ReviewQuestion> question();
    /// What the files of a review are made from.
    [[nodiscard]] ReviewSource source() const;
    /// The cities of baseline and scenario. Error: they are the same, or no longer exist.
    /// Baseline and scenario; the same twice for an inventory. Error: a scenario that changes
    /// nothing.
    [[nodiscard]] Result<ReviewedCities> comparedCities() const { return comparedCities(scenarioName()); }
    [[nodiscard]] Result<ReviewedCities> comparedCities(const std::string& to) const;
    /// The scenarios whose buildings differ from the baseline's.
    [[nodiscard]] std::vector<std::string> comparedScenarios();

    void run() { ask({.isWork = true, .isShown = true}); }
    /// Of a project that was opened: computes the review again that it holds of the present choice, if that
    /// was quick, so that its places and timelines are there. Whether it is the answer that was displayed.
    bool repeatMeasured();
    /// The review of the present choice that the project holds from an earlier session; null: none.
    [[nodiscard]] std::shared_ptr<const MeasuredAnswer> measuredBefore();
    /// Reviews every scenario that latest() lacks.
    void runAll();
    /// The latest answer of each scenario for the chosen rule, baseline and places, where none of them nor
    /// the buildings have changed since.
    [[nodiscard]] std::map<std::string, std::shared_ptr<const ReviewAnswer>> latest();
    void screen();  ///< chooses the places in reach, and finds them
    /// Computes the expected time of run() and emits estimated().
    void estimate();
    /// The answer that can be exported. Error: why there is none, and what to do.
    [[nodiscard]] Result<std::shared_ptr<const ReviewAnswer>> finished() const;
    /// Displays finished() as the answer that is exported. Its errors; its buildings have changed since.
    [[nodiscard]] Result<void> showFinished();

    [[nodiscard]] bool isShaping() const { return proposed_ != nullptr; }
    /// The building being shaped changed: the displayed city with it; null: nothing is being shaped. While
    /// `following`, or after a run that was quick, the verdicts follow if the rule has few days.
    void shape(std::shared_ptr<const City> proposed);
    void setFollowing(bool following);

    /// The live answer, or else the latest one; null: none.
    [[nodiscard]] std::shared_ptr<const ReviewAnswer> shown() const { return live_ ? live_ : answer_; }
    [[nodiscard]] bool isLive() const { return live_ != nullptr; }
    /// Why the answer shown is not up to date; empty: it is.
    [[nodiscard]] QString whyOutdated();
    /// The places in reach of the scenario, where these alone are reviewed.
    struct Reach {
        ReviewQuestion asked;                        ///< about all places
        Result<ReviewQuestion> kept;                 ///< about those in reach. Error: there is none
        std::map<std::string, std::string> reasons;  ///< by place: why it is left out, or that it is reached
    };
    /// What is known of what would be reviewed now; null: all places are, or they are still to be found.
    [[nodiscard]] const Reach* reach();
    /// Whether they are still to be found, and no place is known to be reviewed until then.
    [[nodiscard]] bool mustFindReach();
    /// Whether places in reach are still to be found before question() is whole.
    [[nodiscard]] bool needsScreening(const ReviewQuestion& question) const;

    [[nodiscard]] JobSlot& running() { return running_; }
    [[nodiscard]] JobSlot& runningAll() { return runningAll_; }
    [[nodiscard]] JobSlot& following() { return followed_; }

    /// A review that took at most this many seconds is computed again after an edit without asking.
    static constexpr double quickSeconds = 10;

Q_SIGNALS:
    void changed();   ///< the choice, or what can be chosen
    void answered();  ///< shown() or whether it is up to date
    void estimated(QString words);
    void noted(QString text);
    void failed(noonmark::Error error);  ///< not emitted for cancelled work
    /// A scenario of reviewAll() could not be reviewed.
    void scenarioFailed(std::string scenario, noonmark::Error error);

private:
    void ask(const Workbench::Adopting& how);
    void adoptShown();
    [[nodiscard]] Asked makeAsked(ReviewQuestion question) const;
    void reportAll(const ScenarioErrors& errors, std::size_t asked);
    void follow();
    [[nodiscard]] bool isKnownAsQuick() const;
    void dropLive();
    void takeLive(Result<ReviewAnswer> answer);
    void findReach(JobSlot& slot, const ReviewQuestion& question, std::function<void()> next);
    [[nodiscard]] bool isAnswered(const ReviewQuestion& now);
    [[nodiscard]] Result<PlacesToReview> livePlaces(const Rule& rule) const;
    void rename(ProjectPart part, const std::string& from, const std::string& to);
    void cityChanged();
    void report(const Error& error);
    void suggest();
    [[nodiscard]] std::string scenarioName() const;
    [[nodiscard]] Result<ReviewQuestion> questionOf(const std::string& scenario);
    std::map<std::string, std::shared_ptr<const ReviewAnswer>> findLatest(const Rule& rule,
                                                                          Result<PlacesToReview> places,
                                                                          bool orSome);
    void recall();
    Result<PlacesToReview> chosenPlaces(const Rule& rule) const;

    Workbench& workbench_;
    RuleLibrary library_;
    ReviewChoice choice_;
    std::shared_ptr<const ReviewAnswer> answer_;
    ReviewCache<ReviewAnswer, 64> cached_;
    std::shared_ptr<const ReviewAnswer> live_;
    std::shared_ptr<const City> proposed_;
    std::optional<Reach> reach_;  // of the question that was screened last
    bool newerShape_ = false;
    bool following_ = false;
    JobSlot running_;
    JobSlot runningAll_;
    JobSlot followed_;
    JobSlot estimating_;
};

/// Errors of the reviews of places and of windows: baseline and scenario are the same, as `what` says, and
/// there is no review to export.
Error proposesNothing(std::string what);
Error noReviewError();

/// Hands the reviews of several scenarios over to a cache and to the workbench, which lists them without
/// displaying them. Returns the errors of the other scenarios.
template <class Review, std::size_t maximum>
ScenarioErrors adoptReviews(std::vector<Result<std::shared_ptr<const Answer>>> answers,
                            const ScenarioQuestions<Asked>& asked, ReviewCache<Review, maximum>& cached,
                            Workbench& workbench) {
    return adoptEach(
        std::move(answers), asked, [&](const std::shared_ptr<const Answer>& answer, std::size_t) {
            const auto review = contentOf<Review>(answer);
            cached.add(review);
            workbench.adopt({review->question.after, review->question.before, answer}, {.isShown = false});
        });
}

/// Displays a review that a dock shows, so that it can be exported. Error: its buildings have changed since.
template <class Review>
Result<void> showReview(Workbench& workbench, const std::shared_ptr<const Review>& review,
                        const ReviewSource& source) {
    if (workbench.answerAs<Review>() == review) return {};
    const auto& asked = review->question;
    workbench.adopt(
        {asked.after, asked.before, makeAnswer(review, std::make_shared<const ReviewSource>(source))},
        {.isWork = false});
    if (workbench.answerAs<Review>() == review) return {};
    return failure("The buildings have changed since this review", asked.to, "Run the review again");
}

}  // namespace noonmark
