#pragma once

#include <stop_token>
#include <string>

#include "core/base/progress.h"
#include "core/bench/contests/allowance.h"

namespace noonmark::bench {

/// Progress, stop token and time limit of an experiment.
struct Work {
    Progress& progress;
    std::stop_token stop;
    Allowance allowance{};

    [[nodiscard]] bool stopped() const { return stop.stop_requested(); }
};

/// Progress over a list of pieces of work that take about equally long.
class Pieces {
public:
    Pieces(const Work& work, std::string stage, std::size_t count)
        : work_(work), stage_(std::move(stage)), count_(count) {}

    /// Call before each piece.
    void next() { work_.progress.report(double(done_++) / double(count_), stage_); }

private:
    const Work& work_;
    std::string stage_;
    std::size_t count_;
    std::size_t done_ = 0;
};

}  // namespace noonmark::bench
