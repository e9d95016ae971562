#pragma once

#include "app/gui/base/jobs/job.h"

namespace noonmark {

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
        leave();
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
        leave();
        Q_EMIT ended();
    }

Q_SIGNALS:
    void started(const noonmark::Job& job, QString what);
    void ended();

private:
    void leave() {
        if (job_) Job::leave(std::move(job_), *this);
    }

    // The job is calling this slot: it is deleted after it has returned.
    void end() {
        job_.release()->deleteLater();
        Q_EMIT ended();
    }

    std::unique_ptr<Job> job_;
};

}  // namespace noonmark
