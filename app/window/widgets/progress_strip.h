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

/// How far a job is, with a button to cancel it. Hidden while there is none. Of several slots it follows the
/// one that started last.
class ProgressStrip final : public QWidget {
    Q_OBJECT
public:
    /// Side by side, or above each other where there is little width.
    explicit ProgressStrip(QBoxLayout::Direction direction, QWidget* parent = nullptr);

    enum class Jobs {
        cancellable,
        whole,  ///< cancelling would leave things half done: no button
        often,  ///< many that are short as a rule: only one that takes longer is shown, and none beside
                ///< others
    };
    /// What the slot starts from now on.
    void follow(JobSlot& slot, Jobs jobs = Jobs::cancellable);

private:
    void begin(const JobSlot& slot, Jobs jobs, const Job& job, const QString& what);
    void finish(const JobSlot& slot);

    QLabel* label_;
    QProgressBar* bar_;
    QPushButton* cancel_;
    QTimer wait_;
    const JobSlot* shown_ = nullptr;  ///< whose job; null: none
};

}  // namespace noonmark
