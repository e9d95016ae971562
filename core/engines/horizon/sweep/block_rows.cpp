#include <algorithm>
#include <cmath>

#include "core/engines/horizon/sweep/raise_block.h"

namespace noonmark {

namespace {}

BlockRows::BlockRows(double k, double sign) : rowsPerQ(k == 0 ? 0 : float(sign / k)) {
    for (int row = 0; row < ReceiverBlocks::side; ++row) {
        shifts[std::size_t(row)] = float(k * sign * row);
        alongs[std::size_t(row)] = float(sign * row);
    }
}

RowRange findRows(const WallOnBlock& wall, const BlockRows& rows) {
    if (rows.rowsPerQ == 0) return {0, ReceiverBlocks::side};
    constexpr float roundingQ = 1e-5F;  // spans many rows if shadows run almost along the rows
    const float margin = 1 + roundingQ * std::abs(rows.rowsPerQ);
    const float a = wall.high * rows.rowsPerQ,
                b = (wall.low + float(ReceiverBlocks::side - 1)) * rows.rowsPerQ;
    return {int(std::clamp(std::min(a, b) - margin, 0.0F, float(ReceiverBlocks::side))),
            int(std::clamp(std::max(a, b) + margin + 1, 0.0F, float(ReceiverBlocks::side)))};
}

}  // namespace noonmark
