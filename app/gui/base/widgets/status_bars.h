#pragma once

#include <QBoxLayout>
#include <QFrame>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <vector>

#include "core/base/result.h"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QTimer;
class QToolButton;
class QProgressBar;

namespace noonmark {

/// A bar over the view for errors and notices. It is not modal; a click closes it. Of a notice of
/// several lines it shows the first, and the others on request.
class MessageBar final : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(QWidget* parent = nullptr);

    void showError(const Error& error);
    void showNote(const QString& text);  ///< disappears after a while
    void showHelp(const QString& text);  ///< stays until closed
    /// Adds a button to the current message; clicking it hides the message and calls `done`.
    void offer(const QString& remedy, std::function<void()> done);
    /// Adds a second button; likewise.
    void offerSecond(const QString& remedy, std::function<void()> done);
    void dismiss();                      ///< hides the message unless it offers something
    [[nodiscard]] QString text() const;  ///< all lines; empty: no message

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    void closeByClick(const QMouseEvent& event);
    void show(const QString& text);
    void unfold(bool all);
    void paintColours();
    QLabel* label_;
    QToolButton* more_;
    QString text_;
    bool isError_ = false;
    bool unfolded_ = false;
    struct Remedy {
        QPushButton* button;
        std::function<void()> chosen;
    };
    void add(Remedy& remedy, const char* name, QHBoxLayout& row);
    static void offer(Remedy& remedy, const QString& text, std::function<void()> done);

    Remedy remedy_;
    Remedy other_;
    QTimer* leave_;
};

class Job;
class JobSlot;

/// The progress of a job, with a button to cancel it. Hidden while there is none. Of several slots it shows
/// the one started last, and when that has ended, the one before.
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
    struct Running {
        JobSlot* slot;
        Jobs jobs;
        const QWidget* other;
        QString what;
        QString stage;  ///< what it does just now: in the tooltip, since the label would change its width
        double fraction = 0;
    };
    void begin(Running now, const Job& job);
    void take(const JobSlot& slot, double fraction, const QString& stage);
    void finish(const JobSlot& slot);
    void showLast();
    [[nodiscard]] static bool isSeen(const QWidget& widget);

    QLabel* label_;
    QProgressBar* bar_;
    QPushButton* cancel_;
    QTimer wait_;
    std::vector<Running> running_;  ///< the last is shown
};

}  // namespace noonmark
