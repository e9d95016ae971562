#pragma once

#include <QBoxLayout>
#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace noonmark {

class Job;
class JobSlot;

/// The progress of a job, with a button to cancel it. Hidden while there is none. Of several slots it follows
/// the one started last.
class ProgressStrip final : public QWidget {
    Q_OBJECT
public:
    /// `direction`: side by side or, in a narrow place, stacked.
    explicit ProgressStrip(QBoxLayout::Direction direction, QWidget* parent = nullptr);

    enum class Jobs {
        cancellable,
        whole,  ///< not to be cancelled half way: no button
        /// Frequent, usually short jobs: shown only if they take longer, and never instead of others.
        often,
    };
    /// Follows the jobs that the slot starts from now on. `other`: shows them, too; while it can be seen,
    /// this one is hidden. None: null.
    void follow(JobSlot& slot, Jobs jobs = Jobs::cancellable, const QWidget* other = nullptr);

private:
    void begin(const JobSlot& slot, Jobs jobs, const QWidget* other, const Job& job, const QString& what);
    void finish(const JobSlot& slot);

    QLabel* label_;
    QProgressBar* bar_;
    QPushButton* cancel_;
    QTimer wait_;
    const JobSlot* shown_ = nullptr;  ///< the slot of the displayed job; null: none
};

}  // namespace noonmark
