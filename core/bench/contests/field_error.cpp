#include "core/bench/contests/field_error.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace noonmark::bench {

FieldError errorOf(const ShadowField& field, const ShadowField& truth, const Receivers& receivers) {
    if (receivers.cells.empty() || !(truth.sunlitMinutesPerDay > 0)) return {};
    const double toPct = 100 / truth.sunlitMinutesPerDay;
    const double count = double(receivers.cells.size());
    FieldError error;
    double balance = 0;
    std::vector<double> differences;
    for (const std::uint32_t cell : receivers.cells) {
        const double difference = toPct * (double(field.grossMin[cell]) - double(truth.grossMin[cell]));
        balance += difference / count;
        error.cellMeanPct += std::abs(difference) / count;
        differences.push_back(std::abs(difference));
    }
    std::ranges::sort(differences);
    error.areaPct = std::abs(balance);
    error.cellP99Pct = differences[(differences.size() - 1) * 99 / 100];
    error.cellMaxPct = differences.back();
    return error;
}

}  // namespace noonmark::bench
