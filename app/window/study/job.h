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

/// Work on its own thread. Destroying a job cancels it and waits for its end; then nothing more is called.
/// Signals and callbacks come in the thread that made the job.
class Job final : public QObject {
    Q_OBJECT
public:
    using Deliver = std::function<void()>;
    /// Runs on the job's thread; what it returns is called back in the maker's thread.
    using Work = std::function<Deliver(Progress&, std::stop_token)>;

    explicit Job(Work work);
    ~Job() override;

    void
    cancel();  ///< asks the work to stop; it still delivers, as a rule an Error for which isCancelled() holds

    /// Cancels without waiting: nothing is reported or delivered any more. The job destroys itself when its
    /// work has ended, or goes with `keeper` if that is earlier.
    static void leave(std::unique_ptr<Job> job, QObject& keeper);

Q_SIGNALS:
    void progressed(double fraction, QString stage);
    /// A running result, the newest where several came; no more than PartialPace asks for.
    void partial(std::shared_ptr<const noonmark::PartialField> field);

private:
    class Reporter;
    void deliver(const Deliver& result);

    bool left_ = false;
    std::unique_ptr<Reporter> reporter_;
    std::jthread thread_;
};

/// What escapes the work (memory that runs out) becomes its Error: on a thread it would end the program.
template <class T>
Result<T> tried(const std::function<Result<T>(Progress&, std::stop_token)>& work, Progress& progress,
                std::stop_token stop) try {
    return work(progress, std::move(stop));
} catch (const std::exception& exception) {
    return failure(std::string("This could not be done (") + exception.what() + ")", {},
                   "Close other programs, or choose a smaller region or file");
}

/// A job that computes a Result and hands it to `done`. `done` may not destroy the job itself; JobSlot may.
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
