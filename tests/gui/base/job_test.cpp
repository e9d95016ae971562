#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include "app/gui/base/jobs/job.h"
#include "core/engines/api/shadow_field.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;
using IntWork = std::function<Result<int>(Progress&, std::stop_token)>;
using IntDone = std::function<void(Result<int>)>;

// Works until it is stopped.
IntWork endless(std::atomic<bool>& running) {
    return [&running](Progress& progress, std::stop_token stop) -> Result<int> {
        running = true;
        while (!stop.stop_requested()) progress.report(0.5, "turning");
        running = false;
        return cancelled();
    };
}

TEST(Job, HandsOverItsResultInTheMakersThread) {
    std::optional<int> got;
    std::thread::id where;
    const auto job = runJob<int>([](Progress&, std::stop_token) -> Result<int> { return 42; },
                                 [&](const Result<int>& result) {
                                     got = *result;
                                     where = std::this_thread::get_id();
                                 });
    ASSERT_TRUE(waitFor([&] { return got.has_value(); }));
    EXPECT_EQ(*got, 42);
    EXPECT_EQ(where, std::this_thread::get_id());
}

TEST(Job, WhatEscapesTheWorkIsAnError) {
    std::optional<Error> error;
    const IntWork work = [](Progress&, std::stop_token) -> Result<int> { throw std::bad_alloc(); };
    const auto job = runJob<int>(work, IntDone([&](const Result<int>& result) { error = result.error(); }));
    ASSERT_TRUE(waitFor([&] { return error.has_value(); }));
    EXPECT_NE(error->what.find("bad_alloc"), std::string::npos);
}

TEST(Job, DestroyedWhileRunningStopsAndDeliversNothing) {
    std::atomic<bool> running = false;
    bool delivered = false;
    auto job = runJob<int>(endless(running), IntDone([&](const Result<int>&) { delivered = true; }));
    ASSERT_TRUE(waitFor([&] { return running.load(); }));
    job.reset();
    EXPECT_FALSE(running) << "the destructor waits for the work to end";
    QCoreApplication::processEvents();
    EXPECT_FALSE(delivered);
}

TEST(Job, CancelDeliversCancelled) {
    std::atomic<bool> running = false;
    std::optional<Error> error;
    auto job =
        runJob<int>(endless(running), IntDone([&](const Result<int>& result) { error = result.error(); }));
    ASSERT_TRUE(waitFor([&] { return running.load(); }));
    job->cancel();
    ASSERT_TRUE(waitFor([&] { return error.has_value(); }));
    EXPECT_TRUE(isCancelled(*error));
}

TEST(Job, ReportsProgressUntilItIsDestroyed) {
    std::atomic<bool> running = false;
    int reports = 0;
    auto job = runJob<int>(endless(running), IntDone([](const Result<int>&) {}));
    QObject::connect(job.get(), &Job::progressed, [&](double fraction, const QString& stage) {
        EXPECT_DOUBLE_EQ(fraction, 0.5);
        EXPECT_EQ(stage, QStringLiteral("turning"));
        ++reports;
    });
    ASSERT_TRUE(waitFor([&] { return reports > 2; }));
    job.reset();
    const int after = reports;
    QCoreApplication::processEvents();
    EXPECT_EQ(reports, after);
}

TEST(Job, HandsOverRunningResultsNewestFirst) {
    std::atomic<bool> wantedAtOnce = true;
    const IntWork work = [&](Progress& progress, const std::stop_token&) -> Result<int> {
        PartialSink& sink = *findPartialSink(progress);
        for (int i = 1; i <= 3; ++i) sink.take({{}, i / 4.0, "part"});
        wantedAtOnce = sink.wants();
        return 0;
    };
    std::vector<double> shares;
    bool done = false;
    const auto job = runJob<int>(work, IntDone([&](const Result<int>&) { done = true; }));
    QObject::connect(job.get(), &Job::partial,
                     [&](const auto& partial) { shares.push_back(partial->share); });
    ASSERT_TRUE(waitFor([&] { return done; }));
    ASSERT_FALSE(shares.empty());
    EXPECT_EQ(shares.back(), 0.75) << "the newest arrived, even if others were skipped";
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_FALSE(wantedAtOnce) << "only one is passed until it has been shown";
}

TEST(JobSlot, ASecondJobReplacesTheFirst) {
    std::atomic<bool> running = false;
    std::vector<int> got;
    const IntDone note = [&](const Result<int>& result) { got.push_back(result.value_or(-1)); };
    JobSlot slot;
    slot.start<int>(QStringLiteral("first"), endless(running), note);
    ASSERT_TRUE(waitFor([&] { return running.load(); }));
    slot.start<int>(
        QStringLiteral("second"), [](Progress&, std::stop_token) -> Result<int> { return 2; }, note);
    ASSERT_TRUE(waitFor([&] { return !slot.busy(); }));
    EXPECT_EQ(got, std::vector<int>{2});
}

TEST(JobSlot, AJobThatWillNotStopYetHoldsNobodyUp) {
    std::atomic<bool> released = false;
    std::atomic<bool> running = false;
    const IntWork stubborn = [&](Progress&, const std::stop_token&) -> Result<int> {
        running = true;
        released.wait(false);
        return 1;
    };
    std::vector<int> got;
    const IntDone note = [&](const Result<int>& result) { got.push_back(result.value_or(-1)); };
    JobSlot slot;
    slot.start<int>(QStringLiteral("stubborn"), stubborn, note);
    ASSERT_TRUE(waitFor([&] { return running.load(); }));
    slot.start<int>(
        QStringLiteral("second"), [](Progress&, const std::stop_token&) -> Result<int> { return 2; }, note);
    ASSERT_TRUE(waitFor([&] { return !slot.busy(); }))
        << "the second finishes while the first is still running";
    released = true;
    released.notify_all();
    ASSERT_TRUE(waitFor([&] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return slot.findChildren<Job*>().empty();
    }));
    EXPECT_EQ(got, std::vector<int>{2}) << "the replaced job delivers nothing";
}

}  // namespace
}  // namespace noonmark
