#pragma once

#include <QObject>
#include <QString>
#include <exception>
#include <functional>
#include <memory>
#include <stop_token>
#include <thread>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/engines/api/shadow_field.h"

namespace noonmark {

// The memory that the program holds in a long session: no more than its caches need. glibc alone keeps freed
// blocks, scattered over the heaps of all threads: after an hour of use, 730 MB beside 250 MB in use. Both
// functions do nothing with another C library.

/// Makes the allocator return large freed arrays to the system at once; by default glibc keeps those of up to
/// 32 MB. Call it before the first thread starts.
void returnLargeBlocks();

/// Returns the free pages between smaller blocks, some milliseconds; at most once in two seconds, otherwise
/// it does nothing. Any thread.
void trimHeap();

/// Work on its own thread. Destroying a job cancels it and waits for its end; after that nothing is called.
/// Signals and callbacks arrive in the thread that created the job.
class Job final : public QObject {
    Q_OBJECT
public:
    using Deliver = std::function<void()>;
    /// Runs on the job's thread; the function it returns is called in the creator's thread.
    using Work = std::function<Deliver(Progress&, std::stop_token)>;

    explicit Job(Work work);
    ~Job() override;

    /// Asks the work to stop. It still delivers, usually an Error for which isCancelled() holds.
    void cancel();

    /// Cancels without waiting: nothing is reported or delivered any more. The job deletes itself when its
    /// work ends, or earlier together with `keeper`.
    static void abandon(std::unique_ptr<Job> job, QObject& keeper);

Q_SIGNALS:
    void progressed(double fraction, QString stage);
    /// A partial result, the newest if several came; no more often than PartialPace asks for.
    void partial(std::shared_ptr<const noonmark::PartialField> field);

private:
    class Reporter;
    void deliver(const Deliver& result);

    bool abandoned_ = false;
    std::unique_ptr<Reporter> reporter_;
    std::jthread thread_;
};

/// Turns an exception thrown by the work (such as out of memory) into an Error: on a thread it would end the
/// program.
template <class T>
Result<T> runGuarded(const std::function<Result<T>(Progress&, std::stop_token)>& work, Progress& progress,
                     std::stop_token stop) try {
    return work(progress, std::move(stop));
} catch (const std::exception& exception) {
    return failure(std::string("This could not be done (") + exception.what() + ")", {},
                   "Close other programs, or choose a smaller region or file");
}

/// A job that computes a Result and passes it to `done`. `done` must not destroy the job itself; JobSlot may.
template <class T>
std::unique_ptr<Job> runJob(std::function<Result<T>(Progress&, std::stop_token)> work,
                            std::function<void(Result<T>)> done) {
    return std::make_unique<Job>([work = std::move(work), done = std::move(done)](
                                     Progress& progress, std::stop_token stop) -> Job::Deliver {
        auto result = std::make_shared<Result<T>>(runGuarded<T>(work, progress, std::move(stop)));
        return [result, done] { done(std::move(*result)); };
    });
}

/// Runs one job at a time. Starting another cancels the one before, which ends on its own while the new one
/// runs, without blocking. Destroying the slot waits for all jobs.
class JobSlot final : public QObject {
    Q_OBJECT
public:
    explicit JobSlot(QObject* parent = nullptr) : QObject(parent) {}

    [[nodiscard]] bool busy() const { return job_ != nullptr; }

    /// `done` is called in this thread when the work ends, unless another job was started or the slot was
    /// destroyed.
    template <class T>
    void start(const QString& what, std::function<Result<T>(Progress&, std::stop_token)> work,
               std::function<void(Result<T>)> done) {
        abandon();
        job_ = runJob<T>(std::move(work), [this, done = std::move(done)](Result<T> result) {
            end();
            done(std::move(result));
        });
        Q_EMIT started(*job_, what);
    }

    void cancel() {
        if (job_) job_->cancel();
    }

    /// Cancels the job, if any, and discards its result.
    void drop() {
        if (!job_) return;
        abandon();
        Q_EMIT ended();
    }

Q_SIGNALS:
    void started(const noonmark::Job& job, QString what);
    void ended();

private:
    void abandon() {
        if (job_) Job::abandon(std::move(job_), *this);
    }

    // The job is calling this slot: it is deleted after it has returned.
    void end() {
        job_.release()->deleteLater();
        Q_EMIT ended();
    }

    std::unique_ptr<Job> job_;
};

}  // namespace noonmark
