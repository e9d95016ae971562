#include "app/window/job.h"

#include <QMetaObject>
#include <mutex>

namespace noonmark {

/// Passes on the newest report only: many threads report often, the window needs few.
class Job::Reporter final : public Progress {
public:
    explicit Reporter(Job& job) : job_(job) {}

    void report(double fraction, std::string_view stage) override {
        const std::scoped_lock lock(mutex_);
        fraction_ = fraction;
        stage_ = stage;
        if (waiting_) return;
        waiting_ = true;
        QMetaObject::invokeMethod(
            &job_, [this] { pass(); }, Qt::QueuedConnection);
    }

private:
    void pass() {
        double fraction = 0;
        QString stage;
        {
            const std::scoped_lock lock(mutex_);
            waiting_ = false;
            fraction = fraction_;
            stage = QString::fromStdString(stage_);
        }
        Q_EMIT job_.progressed(fraction, stage);
    }

    Job& job_;
    std::mutex mutex_;
    double fraction_ = 0;
    std::string stage_;
    bool waiting_ = false;
};

Job::Job(Work work) : reporter_(std::make_unique<Reporter>(*this)) {
    thread_ = std::jthread([this, work = std::move(work)](std::stop_token stop) {
        // A call that waits in a destroyed object's queue is dropped: nothing is delivered too late.
        QMetaObject::invokeMethod(
            this, [this, result = work(*reporter_, std::move(stop))] { deliver(result); },
            Qt::QueuedConnection);
    });
}

Job::~Job() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
}

void Job::cancel() { thread_.request_stop(); }

void Job::leave(std::unique_ptr<Job> job, QObject& keeper) {
    job->cancel();
    job->disconnect();
    job->left_ = true;
    job.release()->setParent(&keeper);
}

void Job::deliver(const Deliver& result) {
    if (left_) return deleteLater();
    result();  // may destroy this job
}

}  // namespace noonmark
