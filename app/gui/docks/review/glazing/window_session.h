#pragma once

// Rules about windows in the review dock. WindowSession runs the review of the windows that the choice of a
// ReviewSession names (app/questions/window_question.h), WindowForm chooses the windows, and WindowTable
// lists the answer. verdict_tiles paints its verdicts; WindowPanel chooses which, and VerdictLinks connects
// table and view.

#include <QObject>

#include "app/gui/docks/review/review_session.h"
#include "app/questions/window_question.h"

namespace noonmark {

/// The review of windows of the open project, by the rule and the scenarios of a ReviewSession. Knows no
/// widgets.
class WindowSession final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive it.
    WindowSession(Workbench& workbench, ReviewSession& review, QObject* parent = nullptr);

    /// Whether the chosen rule is about windows.
    [[nodiscard]] bool applies() const;
    /// What run() would compute. Error: what is still missing, and what to do.
    [[nodiscard]] Result<WindowQuestion> question();
    void run();
    /// As of ReviewSession.
    void runAll();
    [[nodiscard]] std::map<std::string, std::shared_ptr<const WindowAnswer>> latest();
    /// Computes the expected time of run() and emits estimated(); at once where the question is the same.
    void estimate();

    [[nodiscard]] std::shared_ptr<const WindowAnswer> answer() const { return answer_; }
    /// Why the answer is not up to date; empty: it is.
    [[nodiscard]] QString whyOutdated();
    /// The answer that can be exported. Error: there is none.
    [[nodiscard]] Result<std::shared_ptr<const WindowAnswer>> finished() const;
    void write(std::shared_ptr<const WindowAnswer> answer, const QString& folder);

    [[nodiscard]] JobSlot& running() { return running_; }
    [[nodiscard]] JobSlot& runningAll() { return runningAll_; }

Q_SIGNALS:
    void answered();
    void estimated(QString words);  ///< empty: run() would be refused
    void written(QString folder);
    void failed(noonmark::Error error);  ///< not emitted for cancelled work

private:
    void tell(const Error& error);
    [[nodiscard]] Result<WindowQuestion> questionOf(const Result<ReviewedCities>& cities);

    Workbench& workbench_;
    ReviewSession& review_;
    std::shared_ptr<const WindowAnswer> answer_;
    ReviewCache<WindowAnswer, 8> cached_;  // a whole city's windows take some 100 MB
    JobSlot running_;
    JobSlot runningAll_;
    JobSlot estimating_;
    std::optional<WindowQuestion> asked_;  ///< of the last estimate
    QString estimate_;
};

}  // namespace noonmark
