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
#include "core/engines/api/partial_field.h"

namespace noonmark {

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

    void
    /// Asks the work to stop. It still delivers, usually an Error for which isCancelled() holds.
    cancel();

    /// Cancels without waiting: nothing is reported or delivered any more. The job deletes itself when its
    /// work ends, or earlier together with `keeper`.
    static void leave(std::unique_ptr<Job> job, QObject& keeper);

Q_SIGNALS:
    void progressed(double fraction, QString stage);
    /// A partial result, the newest if several came; no more often than PartialPace asks for.
    void partial(std::shared_ptr<const noonmark::PartialField> field);

private:
    class Reporter;
    void deliver(const Deliver& result);

    bool left_ = false;
    std::unique_ptr<Reporter> reporter_;
    std::jthread thread_;
};

/// Turns an exception thrown by the work (such as out of memory) into an Error: on a thread it would end the
/// program.
template <class T>
Result<T> tried(const std::function<Result<T>(Progress&, std::stop_token)>& work, Progress& progress,
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
        auto result = std::make_shared<Result<T>>(tried<T>(work, progress, std::move(stop)));
        return [result, done] { done(std::move(*result)); };
    });
}

}  // namespace noonmark
