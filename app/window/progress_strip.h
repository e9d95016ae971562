#pragma once

#include <QBoxLayout>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace noonmark {

class Job;

/// How far a job is, with a button to cancel it. Hidden while there is none.
class ProgressStrip final : public QWidget {
    Q_OBJECT
public:
    /// Side by side, or above each other where there is little width.
    explicit ProgressStrip(QBoxLayout::Direction direction, QWidget* parent = nullptr);

    /// Without the button where cancelling would leave things half done.
    void follow(const Job& job, const QString& what, bool cancellable = true);
    void finish();

Q_SIGNALS:
    void cancelRequested();

private:
    QLabel* label_;
    QProgressBar* bar_;
    QPushButton* cancel_;
};

}  // namespace noonmark
