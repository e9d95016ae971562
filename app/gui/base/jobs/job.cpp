#include "app/gui/base/jobs/job.h"

#include <QMetaObject>
#include <mutex>

#ifdef __GLIBC__
#include <malloc.h>

#include <atomic>
#include <chrono>
#endif

namespace noonmark {

#ifdef __GLIBC__

void returnLargeBlocks() {
    constexpr int largeBytes = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, largeBytes);  // an explicit value turns off glibc's adaptive threshold
    mallopt(M_TRIM_THRESHOLD, largeBytes);
}

void trimHeap() {
    using Clock = std::chrono::steady_clock;
    static std::atomic<Clock::time_point> last{Clock::time_point{}};
    constexpr std::chrono::seconds pause{2};
    Clock::time_point before = last;
    const Clock::time_point now = Clock::now();
    if (now - before >= pause && last.compare_exchange_strong(before, now)) malloc_trim(0);
}

#else

void returnLargeBlocks() {}
void trimHeap() {}

#endif

/// Passes on only the newest report: many threads report often, the window needs few. A new partial result is
/// taken only after the window has received the previous one.
class Job::Reporter final : public Progress, public PartialSink {
public:
    explicit Reporter(Job& job) : job_(job) {}

    [[nodiscard]] bool wants() const override {
        const std::scoped_lock lock(mutex_);
        return !partial_ && pace_.due(watch_.seconds());
    }

    void take(PartialField field) override {
        auto taken = std::make_shared<const PartialField>(std::move(field));
        const std::scoped_lock lock(mutex_);
        pace_.taken(watch_.seconds());
        const bool waiting = partial_ != nullptr;
        partial_ = std::move(taken);
        if (waiting) return;
        QMetaObject::invokeMethod(
            &job_, [this] { passPartial(); }, Qt::QueuedConnection);
    }

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
    void passPartial() {
        std::shared_ptr<const PartialField> field;
        {
            const std::scoped_lock lock(mutex_);
            field = std::move(partial_);
        }
        Q_EMIT job_.partial(field);
    }

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
    mutable std::mutex mutex_;
    std::shared_ptr<const PartialField> partial_;  // not yet passed to the window
    Stopwatch watch_;
    PartialPace pace_;
    double fraction_ = 0;
    std::string stage_;
    bool waiting_ = false;
};

Job::Job(Work work) : reporter_(std::make_unique<Reporter>(*this)) {
    thread_ = std::jthread([this, work = std::move(work)](std::stop_token stop) {
        // Queued calls to a destroyed object are dropped, so nothing is delivered too late.
        QMetaObject::invokeMethod(
            this, [this, result = work(*reporter_, std::move(stop))] { deliver(result); },
            Qt::QueuedConnection);
        trimHeap();
    });
}

Job::~Job() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
}

void Job::cancel() { thread_.request_stop(); }

void Job::abandon(std::unique_ptr<Job> job, QObject& keeper) {
    job->cancel();
    job->disconnect();
    job->abandoned_ = true;
    job.release()->setParent(&keeper);
}

void Job::deliver(const Deliver& result) {
    if (abandoned_) return deleteLater();
    result();  // may destroy this job
}

}  // namespace noonmark
