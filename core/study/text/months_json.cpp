#include "core/study/text/months_json.h"

namespace noonmark {

nlohmann::ordered_json monthsJson(const std::vector<MonthShadow>& months) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const MonthShadow& month : months)
        json.push_back({{"month", month.month},
                        {"sunlit_min", month.sunlitMinutes},
                        {"shadow_area_m2", month.shadowAreaM2},
                        {"mean_shadow_min", month.meanMinutes}});
    return json;
}

}  // namespace noonmark
