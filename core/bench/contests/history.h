#pragma once

#include <cmath>
#include <vector>

namespace noonmark::bench {

/// What is known of a contestant from shorter periods.
class History {
public:
    void add(int days, double seconds) { periods_.push_back({days, seconds}); }

    /// Seconds over so many days, where time has almost grown in proportion so far, over ten times the days
    /// at least; else 0: who knows.
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
