#pragma once

#include <cmath>
#include <vector>

namespace noonmark::bench {

/// A contestant's times over shorter periods, to predict longer ones.
class History {
public:
    void add(int days, double seconds) { periods_.push_back({days, seconds}); }

    /// Predicted seconds over `days`, if time has grown almost in proportion so far, over a range of at least
    /// ten times the days; 0: unknown.
    [[nodiscard]] double expected(int days) const {
        if (periods_.empty() || periods_.back().days < 10 * periods_.front().days) return 0;
        const Period& last = periods_.back();
        return growth(periods_.front(), last) > 0.75 ? last.seconds * days / last.days : 0;
    }

private:
    struct Period {
        int days = 1;
        double seconds = 0;
    };

    /// 1: in proportion to the days; 0: not at all.
    static double growth(const Period& from, const Period& to) {
        return std::log(to.seconds / from.seconds) / std::log(double(to.days) / from.days);
    }

    std::vector<Period> periods_;
};

}  // namespace noonmark::bench
