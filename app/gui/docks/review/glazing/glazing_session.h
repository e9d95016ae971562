#pragma once

// Rules about windows in the review dock. GlazingSession runs the review of the windows that the choice of a
// ReviewSession names (app/questions/glazing_question.h), GlazingForm chooses the windows, and GlazingTable
// lists the answer. Tiles of the view are painted by its verdicts; GlazingPanel chooses which, and
// VerdictLinks connects table and view.

#include <QObject>

#include "app/gui/docks/review/review_session.h"
#include "app/questions/glazing_question.h"

namespace noonmark {

/// The review of windows of the open project, by the rule and the scenarios of a ReviewSession. Knows no
/// widgets.
class GlazingSession final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive it.
    GlazingSession(Workbench& workbench, ReviewSession& review, QObject* parent = nullptr);

    /// Whether the chosen rule is about windows.
    [[nodiscard]] bool applies() const;
    /// What run() would compute. Error: what is still missing, and what to do.
    [[nodiscard]] Result<GlazingQuestion> question();
    /// Takes the answers of another session of the same workbench.
    void takeOver(const GlazingSession& before);
    void run();
    /// As of ReviewSession.
    void runAll();
    [[nodiscard]] std::map<std::string, std::shared_ptr<const GlazingAnswer>> latest();
    /// Computes the expected time of run() and emits estimated(); at once where the question is the same.
    void estimate();

    [[nodiscard]] std::shared_ptr<const GlazingAnswer> answer() const { return answer_; }
    /// Why the answer is not up to date; empty: it is.
    [[nodiscard]] QString whyOutdated();
    /// The answer that can be exported. Error: there is none.
    [[nodiscard]] Result<std::shared_ptr<const GlazingAnswer>> finished() const;
    /// Displays finished() as the answer that is exported. Its errors; its buildings have changed since.
    [[nodiscard]] Result<void> showFinished();

    [[nodiscard]] JobSlot& running() { return running_; }
    [[nodiscard]] JobSlot& runningAll() { return runningAll_; }

Q_SIGNALS:
    void answered();
    void estimated(QString words);       ///< empty: run() would be refused
    void failed(noonmark::Error error);  ///< not emitted for cancelled work
    /// A scenario of reviewAll() could not be reviewed.
    void scenarioFailed(std::string scenario, noonmark::Error error);

private:
    void adoptShown();
    [[nodiscard]] Asked makeAsked(GlazingQuestion question) const;
    void reportAll(const ScenarioErrors& errors, std::size_t asked);
    void report(const Error& error);
    [[nodiscard]] Result<GlazingQuestion> questionOf(const Result<ReviewedCities>& cities);

    Workbench& workbench_;
    ReviewSession& review_;
    std::shared_ptr<const GlazingAnswer> answer_;
    ReviewCache<GlazingAnswer, 8> cached_;  // a whole city's windows take some 100 MB
    JobSlot running_;
    JobSlot runningAll_;
    JobSlot estimating_;
    std::optional<GlazingQuestion> asked_;  ///< of the last estimate
    QString estimate_;
};

}  // namespace noonmark
