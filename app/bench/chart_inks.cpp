#include "app/bench/chart_inks.h"

#include <array>

#include "app/report/maps/style.h"

namespace noonmark {

namespace {

constexpr std::array<ChartInk, 10> engineInks{{{{0x1d, 0x20, 0x27}, MarkShape::circle},
                                               {{0x00, 0x72, 0xb2}, MarkShape::square},
                                               {{0xd5, 0x5e, 0x00}, MarkShape::triangle},
                                               {{0x00, 0x9e, 0x73}, MarkShape::diamond},
                                               {{0xcc, 0x79, 0xa7}, MarkShape::pentagon},
                                               {{0xe6, 0x9f, 0x00}, MarkShape::circle},
                                               {{0x56, 0xb4, 0xe9}, MarkShape::square},
                                               {{0x88, 0x22, 0x55}, MarkShape::triangle},
                                               {{0x99, 0x99, 0x33}, MarkShape::diamond},
                                               {{0x6b, 0x6f, 0x76}, MarkShape::pentagon}}};

}  // namespace

ChartInks::ChartInks(const std::vector<bench::Finding>& findings) {
    inks_ = {{"", {ink::quiet, MarkShape::circle}},
             {"ours", {{0x00, 0x72, 0xb2}, MarkShape::circle}},
             {"edge", {{0x56, 0xb4, 0xe9}, MarkShape::square}},
             {"most", {{0xd5, 0x5e, 0x00}, MarkShape::triangle}},
             {"paper", {{0xe6, 0x9f, 0x00}, MarkShape::diamond}}};
    std::size_t next = 0;
    for (const auto& finding : findings)
        for (const auto& chart : finding.charts)
            for (const auto& series : chart.series)
                if (inks_.try_emplace(series.colourOf, engineInks[next % engineInks.size()]).second) ++next;
}

ChartInk ChartInks::of(const std::string& word) const {
    const auto found = inks_.find(word);
    return found == inks_.end() ? ChartInk{ink::quiet} : found->second;
}

}  // namespace noonmark
